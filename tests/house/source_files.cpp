#include "house/source_files.h"

#include <algorithm>
#include <fstream>

namespace vantage::testing {

namespace fs = std::filesystem;

std::string SourceFile::stem() const {
  return fs::path(name).stem().string();
}

std::vector<SourceFile> sourceFiles(const fs::path& root) {
  std::vector<SourceFile> files;
  for (const char* layer : {"core", "widgets", "app"}) {
    if (!fs::is_directory(root / layer)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / layer)) {
      const fs::path& path = entry.path();
      if (!entry.is_regular_file() || (path.extension() != ".h" && path.extension() != ".cpp")) continue;
      SourceFile file{fs::relative(path, root).generic_string(), {}};
      std::ifstream in(path);
      for (std::string line; std::getline(in, line);) file.lines.push_back(line);
      files.push_back(std::move(file));
    }
  }
  std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.name < b.name; });
  return files;
}

std::string withoutComment(const std::string& line) {
  return line.substr(0, line.find("//"));
}

}  // namespace vantage::testing
