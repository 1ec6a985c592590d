#pragma once

#include <algorithm>
#include <cmath>

#include "scanner/range_image.h"

namespace vantage::testing {

/// The paint of a test object: a colour that changes by less than 2.5 a millimetre wherever it is not at its end.
[[nodiscard]] inline Colour paintAt(const Vec3& p) {
  const auto channel = [](double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
  };
  return {channel(128.0 + 1.5 * p.x()), channel(128.0 + 1.5 * p.y()), channel(40.0 + 1.5 * p.z())};
}

/// The greatest difference in a channel.
[[nodiscard]] inline int differenceOf(const Colour& a, const Colour& b) {
  int most = 0;
  for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(int{a[k]} - int{b[k]}));
  return most;
}

/// A scan of a painted object as a sensor with colours takes it.
[[nodiscard]] inline RangeImage painted(RangeImage image) {
  image.colours.assign(image.range.size(), Colour{});
  for (std::size_t i = 0; i < image.range.size(); ++i)
    if (image.valid(i)) image.colours[i] = paintAt(image.T_table_scanner * image.point(i));
  return image;
}

}  // namespace vantage::testing
