#include "acquisition/settings.h"

#include <charconv>

#include "base/errors.h"

namespace vantage {

Strategy parseStrategy(std::string_view text) {
  if (text == "ps") return {};
  if (text == "random") return {Strategy::Kind::Random, 0};
  constexpr std::string_view kUniform = "uniform:";
  if (text.starts_with(kUniform)) {
    Strategy strategy{Strategy::Kind::Uniform, 0};
    const std::string_view count = text.substr(kUniform.size());
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), strategy.uniformViews);
    if (error == std::errc() && end == count.data() + count.size() && strategy.uniformViews >= 1) return strategy;
  }
  throw InvalidInput("strategy is '" + std::string(text) + "', expected ps, uniform:N with N >= 1, or random");
}

std::string name(const Strategy& strategy) {
  switch (strategy.kind) {
    case Strategy::Kind::PositionalSpace:
      return "ps";
    case Strategy::Kind::Uniform:
      return "uniform:" + std::to_string(strategy.uniformViews);
    case Strategy::Kind::Random:
      return "random";
  }
  return "";
}

}  // namespace vantage
