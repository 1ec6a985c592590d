#include "house/definitions.h"

#include <map>
#include <optional>
#include <regex>
#include <set>

#include "house/source_files.h"

namespace vantage::testing {
namespace {

// By folder and name of a class or function: stems of the headers that declare it.
using Declarations = std::map<std::string, std::set<std::string>>;

const std::regex kClass("^(?:class|struct)\\s+(?:alignas\\(\\d+\\)\\s+)?(\\w+)[^;]*\\{");
const std::regex kNoFunction(
    "^(?:$|[\\s#}/]|namespace|using|template|class|struct|enum|union|static|inline|constexpr|"
    "typedef|extern|requires|const |public|private|protected|static_assert)");
// The name before the first bracket of a line that begins with a type: "Class::method" or "function".
const std::regex kFunction("^(?:\\[\\[nodiscard\\]\\] )?[\\w:<>,&* ]*?((?:\\w+::)*~?\\w+)\\(");

std::optional<std::string> functionOf(const std::string& line) {
  std::smatch match;
  if (std::regex_search(line, kNoFunction) || !std::regex_search(line, match, kFunction)) return std::nullopt;
  return match[1].str();
}

Declarations declarationsOf(const std::vector<SourceFile>& files) {
  Declarations declarations;
  for (const SourceFile& file : files) {
    if (!file.isHeader() || file.layer() != "core") continue;
    for (const std::string& line : file.lines) {
      const std::string code = withoutComment(line);
      std::smatch match;
      if (std::regex_search(code, match, kClass))
        declarations[file.folder() + " " + match[1].str()].insert(file.stem());
      else if (const auto function = functionOf(code))
        declarations[file.folder() + " " + *function].insert(file.stem());
    }
  }
  return declarations;
}

// The class of a method, of the outermost where they nest, or the function itself.
std::string ownerOf(const std::string& function) {
  return function.substr(0, function.find("::"));
}

bool beside(const std::string& source, const std::set<std::string>& headers) {
  for (const std::string& header : headers)
    if (source == header || source.starts_with(header + "_")) return true;
  return false;
}

void check(const SourceFile& file, const Declarations& declarations, std::vector<std::string>& found) {
  bool hidden = false;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const std::string& line = file.lines[i];
    if (line == "namespace {") hidden = true;
    if (line == "}  // namespace") hidden = false;
    const auto function = hidden ? std::nullopt : functionOf(withoutComment(line));
    if (!function) continue;
    const auto declared = declarations.find(file.folder() + " " + ownerOf(*function));
    if (declared == declarations.end() || beside(file.stem(), declared->second)) continue;
    found.push_back(file.name + ":" + std::to_string(i + 1) + ": " + *function + " is declared in " +
                    *declared->second.begin() + ".h");
  }
}

}  // namespace

std::vector<std::string> strayDefinitions(const std::filesystem::path& root) {
  const std::vector<SourceFile> files = sourceFiles(root);
  const Declarations declarations = declarationsOf(files);
  std::vector<std::string> found;
  for (const SourceFile& file : files)
    if (!file.isHeader() && file.layer() == "core") check(file, declarations, found);
  return found;
}

}  // namespace vantage::testing
