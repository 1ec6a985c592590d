#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vantage::testing {

/// A source of core, widgets or app.
struct SourceFile {
  std::string name;  ///< from the root: "core/base/errors.h"
  std::vector<std::string> lines;

  [[nodiscard]] bool isHeader() const { return name.ends_with(".h"); }
  [[nodiscard]] std::string layer() const { return name.substr(0, name.find('/')); }
  [[nodiscard]] std::string folder() const { return name.substr(0, name.rfind('/')); }
  /// The name without its folder and its ending: "errors".
  [[nodiscard]] std::string stem() const;
};

/// All .h and .cpp files below core/, widgets/ and app/ in order of name; a missing folder has none.
[[nodiscard]] std::vector<SourceFile> sourceFiles(const std::filesystem::path& root);

/// A line without its `//` comment.
[[nodiscard]] std::string withoutComment(const std::string& line);

}  // namespace vantage::testing
