#include "stands/picked_points.h"

#include <algorithm>

namespace vantage {

void PickedPoints::pick(PickSide side, const Vec3& point) {
  std::vector<Vec3>& own = side == PickSide::Object ? object_ : stand_;
  const std::vector<Vec3>& other = side == PickSide::Object ? stand_ : object_;
  if (own.size() > other.size())
    own.back() = point;
  else
    own.push_back(point);
}

void PickedPoints::removeLast() {
  const std::size_t longest = std::max(object_.size(), stand_.size());
  if (longest == 0) return;
  object_.resize(std::min(object_.size(), longest - 1));
  stand_.resize(std::min(stand_.size(), longest - 1));
}

std::optional<PickSide> PickedPoints::awaited() const {
  if (object_.size() == stand_.size()) return std::nullopt;
  return object_.size() < stand_.size() ? PickSide::Object : PickSide::Stand;
}

PickedPairs PickedPoints::pairs() const {
  PickedPairs pairs;
  for (std::size_t i = 0; i < std::min(object_.size(), stand_.size()); ++i) pairs.push_back({object_[i], stand_[i]});
  return pairs;
}

}  // namespace vantage
