#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "base/random.h"
#include "scanner/range_image.h"

namespace vantage {

/// What was scanned.
enum class BodyKind : std::uint8_t { Unique, Symmetric, Plate, PartOnTable };
inline constexpr int kBodyKinds = 4;
[[nodiscard]] const char* name(BodyKind kind);

/// A body by the signed distance of points from its surface [mm].
using Body = std::function<double(const Vec3& point)>;

/// A body of about 100 mm that stands on z = 0 about the axis. The same for the same random numbers.
[[nodiscard]] Body bodyOf(BodyKind kind, Random& random);
[[nodiscard]] Body scaledBy(const Body& body, double factor);

/// What a scanner measures of a body from a place, without light or receivers in the way. Nothing beyond `reach` and
/// where the surface is steeper than 72 degrees.
/// @param pitch between the samples [mm] @param noise along the rays, sigma [mm]
[[nodiscard]] RangeImage scanned(const Body& body, const Pose& T_object_scanner,
                                 const std::shared_ptr<const RayGrid>& rays, double reach, double pitch, double noise,
                                 std::uint64_t seed);

}  // namespace vantage
