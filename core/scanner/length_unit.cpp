#include "scanner/length_unit.h"

#include <cstddef>

namespace vantage {

std::string_view name(LengthUnit unit) {
  constexpr std::array<std::string_view, kLengthUnits.size()> kNames{"mm", "cm", "inch", "m"};
  return kNames[static_cast<std::size_t>(unit)];
}

std::optional<LengthUnit> lengthUnitNamed(std::string_view text) {
  for (const LengthUnit unit : kLengthUnits)
    if (name(unit) == text) return unit;
  return std::nullopt;
}

double millimetresIn(LengthUnit unit) {
  constexpr std::array<double, kLengthUnits.size()> kMillimetres{1.0, 10.0, 25.4, 1000.0};
  return kMillimetres[static_cast<std::size_t>(unit)];
}

std::optional<LengthUnit> lengthUnitOf(double millimetres) {
  for (const LengthUnit unit : kLengthUnits)
    if (millimetresIn(unit) == millimetres) return unit;
  return std::nullopt;
}

}  // namespace vantage
