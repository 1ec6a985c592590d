#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "acquisition/stand_aligner.h"

namespace vantage {

/// Where a point was picked.
enum class PickSide : std::uint8_t { Object, Stand };

/// Points that the operator picks on the object and on a stand, one after the other: the n-th on one side is the n-th
/// on the other. A value.
class PickedPoints {
 public:
  /// A further point. A side that is ahead by one waits for the other: its last point is taken again.
  void pick(PickSide side, const Vec3& point);
  /// The last point that was picked, or, where both sides have it, the last pair.
  void removeLast();
  void clear() { object_.clear(), stand_.clear(); }

  [[nodiscard]] const std::vector<Vec3>& on(PickSide side) const { return side == PickSide::Object ? object_ : stand_; }
  [[nodiscard]] bool isEmpty() const { return object_.empty() && stand_.empty(); }
  /// The side that the pair that was begun lacks; nothing between pairs.
  [[nodiscard]] std::optional<PickSide> awaited() const;
  /// Those that are whole.
  [[nodiscard]] PickedPairs pairs() const;

 private:
  std::vector<Vec3> object_;  // object coordinates [mm]
  std::vector<Vec3> stand_;   // of the table in the stand [mm]
};

}  // namespace vantage
