#include "base/plain_text.h"

#include <cstddef>

namespace vantage {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

struct Character {
  char32_t code = 0;
  std::size_t length = 1;
  bool valid = false;
};

// The first character of a text that is not empty (RFC 3629); one byte that is not valid where there is none.
Character firstOf(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {};
  char32_t code = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0U) != 0x80U) return {};
    code = (code << 6U) | (next & 0x3FU);
  }
  const bool tooLong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (tooLong || surrogate || code > 0x10FFFF) return {};
  return {code, length, true};
}

bool isPlain(char32_t code) {
  const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  const bool separator = code == 0x2028 || code == 0x2029;
  const bool direction = code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
                         (code >= 0x2066 && code <= 0x2069);
  return !control && !separator && !direction;
}

std::string plain(std::string_view text, bool linesStay) {
  std::string result;
  while (!text.empty()) {
    const Character character = firstOf(text);
    const bool stays = character.valid && (isPlain(character.code) || (linesStay && character.code == U'\n'));
    result += stays ? text.substr(0, character.length) : kReplacement;
    text.remove_prefix(character.length);
  }
  return result;
}

}  // namespace

std::string plainText(std::string_view text) {
  return plain(text, false);
}

std::string plainLines(std::string_view text) {
  return plain(text, true);
}

}  // namespace vantage
