#include "house/documents.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace vantage::testing {

namespace fs = std::filesystem;

namespace {

bool isDocument(const fs::directory_entry& entry) {
  return entry.is_regular_file() && entry.path().extension() == ".md";
}

std::vector<fs::path> documents(const fs::path& root) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(root))
    if (isDocument(entry)) found.push_back(entry.path());
  for (const char* folder : {"app", "core", "packaging", "resources", "tests", "widgets"}) {
    if (!fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (isDocument(entry)) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

void addMatches(const std::string& text, const std::regex& pattern, NamedFile found, std::vector<NamedFile>& files) {
  for (std::sregex_iterator match(text.begin(), text.end(), pattern); match != std::sregex_iterator(); ++match) {
    found.path = (*match)[1].str();
    if (!found.path.starts_with("build/")) files.push_back(found);
  }
}

bool isThere(const NamedFile& file, const fs::path& document, const fs::path& root) {
  if (file.link) return fs::exists(document.parent_path() / file.path);
  return fs::exists(root / file.path) || fs::exists(root / "core" / file.path);
}

}  // namespace

std::vector<NamedFile> filesNamedIn(std::string_view markdown) {
  static const std::regex kLink(R"(\]\(([^):#]+)(?:#[^)]*)?\))");
  static const std::regex kPath(R"(`(\w[\w.-]*/[\w./-]*)`)");
  std::vector<NamedFile> files;
  std::istringstream in{std::string(markdown)};
  bool code = false;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.starts_with("```")) {
      code = !code;
    } else if (!code) {
      addMatches(line, kLink, {number, {}, true}, files);
      addMatches(line, kPath, {number, {}, false}, files);
    }
  }
  return files;
}

std::vector<std::string> documentViolations(const fs::path& root) {
  std::vector<std::string> violations;
  for (const fs::path& document : documents(root)) {
    std::ifstream in(document);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::string name = fs::relative(document, root).generic_string();
    for (const NamedFile& file : filesNamedIn(text))
      if (!isThere(file, document, root))
        violations.push_back(name + ":" + std::to_string(file.line) + ": names a file that is not there: " + file.path);
  }
  return violations;
}

}  // namespace vantage::testing
