#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace vantage {

/// The units in which files of objects come.
enum class LengthUnit : std::uint8_t { Millimetre, Centimetre, Inch, Metre };
inline constexpr std::array<LengthUnit, 4> kLengthUnits{LengthUnit::Millimetre, LengthUnit::Centimetre,
                                                        LengthUnit::Inch, LengthUnit::Metre};

/// "mm", "cm", "inch", "m".
[[nodiscard]] std::string_view name(LengthUnit unit);

/// The unit of that name; nothing for anything else.
[[nodiscard]] std::optional<LengthUnit> lengthUnitNamed(std::string_view text);

/// 1, 10, 25.4, 1000.
[[nodiscard]] double millimetresIn(LengthUnit unit);

/// The unit that has so many millimetres; nothing when none has.
[[nodiscard]] std::optional<LengthUnit> lengthUnitOf(double millimetres);

}  // namespace vantage
