#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vantage::testing {

/// A file or folder that a document names.
struct NamedFile {
  int line = 0;
  std::string path;
  bool link = false;  ///< the target of a link, which is relative to the document
};

/// The files that a Markdown text names: targets of links and pictures but for those with a scheme, and words in
/// backquotes with a slash in them that look like a path. Code blocks do not count, nor what is built (build/...).
[[nodiscard]] std::vector<NamedFile> filesNamedIn(std::string_view markdown);

/// Checks that every file that a document (*.md) in the root or in a folder of sources names is there: a link from the
/// document's folder, a path from the root or, as in an include, from core/.
/// @return one line for every violation, "file:line: why", in order of path.
[[nodiscard]] std::vector<std::string> documentViolations(const std::filesystem::path& root);

}  // namespace vantage::testing
