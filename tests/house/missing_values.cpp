#include "house/missing_values.h"

#include <regex>
#include <set>

#include "house/source_files.h"

namespace vantage::testing {
namespace {

const std::regex kMinusOne("\\b(\\w+)\\s*[={]\\s*-\\s*1\\s*\\}?\\s*;");

const std::set<std::string> kDescriptors{"core/base/atomic_file.h descriptor_",
                                         "core/session/session_lock.h descriptor_"};

}  // namespace

std::vector<std::string> missingValues(const std::filesystem::path& root) {
  std::vector<std::string> found;
  for (const SourceFile& file : sourceFiles(root)) {
    if (!file.isHeader()) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string code = withoutComment(file.lines[i]);
      std::smatch match;
      if (!std::regex_search(code, match, kMinusOne) || kDescriptors.contains(file.name + " " + match[1].str()))
        continue;
      found.push_back(file.name + ":" + std::to_string(i + 1) + ": " + match[1].str());
    }
  }
  return found;
}

}  // namespace vantage::testing
