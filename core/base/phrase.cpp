#include "base/phrase.h"

#include <array>
#include <cstdio>
#include <utility>

namespace vantage {
namespace {

std::string rounded(double number, int decimals) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, number);
  return text.data();
}

}  // namespace

Phrase words(const char* pattern, std::vector<Phrase> values) {
  return {pattern, std::move(values), {}, 0.0, 0};
}

Phrase figure(double number, int decimals) {
  return {nullptr, {}, {}, number, decimals};
}

Phrase asIs(std::string text) {
  return {nullptr, {}, std::move(text), 0.0, 0};
}

std::string english(const Phrase& phrase) {
  if (phrase.pattern == nullptr) return phrase.text.empty() ? rounded(phrase.number, phrase.decimals) : phrase.text;
  std::string text;
  for (const char* c = phrase.pattern; *c != '\0'; ++c) {
    const auto place = static_cast<std::size_t>(c[0] == '%' && c[1] >= '1' && c[1] <= '9' ? c[1] - '0' : 0);
    if (place == 0 || place > phrase.values.size()) {
      text += *c;
    } else {
      text += english(phrase.values[place - 1]);
      ++c;
    }
  }
  return text;
}

}  // namespace vantage
