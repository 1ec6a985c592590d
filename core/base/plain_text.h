#pragma once

#include <string>
#include <string_view>

namespace vantage {

/// Text from elsewhere as one line that may stand in a terminal, a log or a page: control characters (line ends and
/// tabs among them), line and paragraph separators, characters that turn the direction of writing and bytes that are no
/// UTF-8 become U+FFFD.
[[nodiscard]] std::string plainText(std::string_view text);

/// The same for several lines, whose ends stay.
[[nodiscard]] std::string plainLines(std::string_view text);

}  // namespace vantage
