#pragma once

#include <optional>
#include <regex>
#include <string>
#include <vector>

namespace vantage {

/// What a message is recognised by: a regular expression (ECMAScript) that is found somewhere in it.
class MessagePattern {
 public:
  /// One that nothing matches.
  MessagePattern() = default;
  /// @throws std::regex_error
  explicit MessagePattern(const std::string& expression) : regex_(expression) {}

  [[nodiscard]] bool matches(const std::string& message) const { return std::regex_search(message, regex_); }

  /// What its groups hold, those without a part in the match left out; nothing when it is not found.
  [[nodiscard]] std::optional<std::vector<std::string>> groups(const std::string& message) const {
    std::smatch match;
    if (!std::regex_search(message, match, regex_)) return std::nullopt;
    std::vector<std::string> groups;
    for (std::size_t i = 1; i < match.size(); ++i)
      if (match[i].matched) groups.push_back(match[i].str());
    return groups;
  }

 private:
  std::regex regex_;
};

}  // namespace vantage
