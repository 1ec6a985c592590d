#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/placement.h"

namespace vantage {

/// How the next position is chosen: by positional space, or by a baseline to compare with. Everything else is shared.
struct Strategy {
  enum class Kind : std::uint8_t { PositionalSpace, Uniform, Random };
  Kind kind = Kind::PositionalSpace;
  int uniformViews = 0;  ///< N of uniform:N
};

/// "ps", "uniform:N" or "random". @throws InvalidInput for anything else.
[[nodiscard]] Strategy parseStrategy(std::string_view text);
[[nodiscard]] std::string name(const Strategy& strategy);

/// What a session was asked to do.
struct AcquisitionSettings {
  std::string object;  ///< file that the simulated scanner looks at; empty for recorded scans
  Placement placement = Placement::AsIs;
  std::uint64_t seed = 1;
  bool ideal = false;
  int firstView = 0;
  int maxViews = 40;
  double tolerance = 0.0;  ///< u
  Strategy strategy;
};

}  // namespace vantage
