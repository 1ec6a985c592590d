#pragma once

#include <string>
#include <vector>

namespace vantage {

/// Words with places for values: English as it stands; in another language when its pattern, which is a literal, is
/// translated before the values go in. Core says with it what codes and numbers mean, the window translates.
struct Phrase {
  const char* pattern = nullptr;  ///< with places %1, %2, ...; null: a value
  std::vector<Phrase> values;     ///< for the places, in order
  std::string text;               ///< a value that is the same in every language: a name, a code
  double number = 0.0;            ///< a value without text
  int decimals = 0;               ///< of the number
};

/// Words of a literal pattern.
[[nodiscard]] Phrase words(const char* pattern, std::vector<Phrase> values = {});
/// A number, rounded to decimals.
[[nodiscard]] Phrase figure(double number, int decimals = 0);
/// A name or code.
[[nodiscard]] Phrase asIs(std::string text);

[[nodiscard]] std::string english(const Phrase& phrase);

}  // namespace vantage
