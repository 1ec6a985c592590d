#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vantage::testing {

/// A string literal with a space in it, as it is written in a source.
struct Sentence {
  int line = 0;
  std::string text;  ///< without the quotes
};

/// The sentences of a C++ source, but for comments and for what is thrown: from `throw` to the end of its statement.
[[nodiscard]] std::vector<Sentence> sentencesIn(std::string_view source);

/// Checks that results are codes and numbers: the rooms of core that make what is hashed and stored (registration,
/// integration, composites, void_space, planning, acquisition) hold no sentence but in errors, since a sentence in a
/// result cannot be translated and changes what is stored when it is worded anew. The words for results are in
/// core/report and app; the help of the settings and the words of a device that hangs, which no result holds, are let
/// alone.
/// @param root folder that holds core/; a missing one has nothing to check.
/// @return one line for every violation, "file:line: why", in order of path.
[[nodiscard]] std::vector<std::string> sentenceViolations(const std::filesystem::path& root);

}  // namespace vantage::testing
