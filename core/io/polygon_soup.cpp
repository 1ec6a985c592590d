#include "io/polygon_soup.h"

#include <algorithm>

namespace vantage {
namespace {

// Twice the signed area of a, b, c seen from the tip of `normal`.
double turn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
  return (b - a).cross(c - a).dot(normal);
}

// Corners are in a ring; those where the polygon turns inward, which alone can lie in an ear, are looked at.
class EarClipper {
 public:
  EarClipper(std::span<const Vec3> points, std::span<const std::uint32_t> polygon)
      : points_(points), corners_(polygon), next_(polygon.size()), before_(polygon.size()), left_(polygon.size()) {
    const Vec3& first = points_[corners_[0]];
    for (std::size_t i = 0; i < left_; ++i) {
      next_[i] = (i + 1) % left_;
      before_[i] = (i + left_ - 1) % left_;
      if (i > 0 && i + 1 < left_) normal_ += (points_[corners_[i]] - first).cross(points_[corners_[i + 1]] - first);
    }
    for (std::size_t i = 0; i < left_; ++i)
      if (turnAt(i) <= 0.0) inward_.push_back(i);
  }

  void run(std::vector<Triangle>& triangles) {
    std::size_t at = 1;
    std::size_t tried = 0;
    while (left_ > 3 && tried < left_) {
      const bool ear = turnAt(at) > 0.0 && isFree(at);
      if (ear) clip(at, triangles);
      tried = ear ? 0 : tried + 1;
      at = next_[at];
    }
    fan(triangles);
  }

 private:
  const Vec3& point(std::size_t i) const { return points_[corners_[i]]; }
  double turnAt(std::size_t i) const { return turn(point(before_[i]), point(i), point(next_[i]), normal_); }

  void clip(std::size_t i, std::vector<Triangle>& triangles) {
    triangles.push_back({corners_[before_[i]], corners_[i], corners_[next_[i]]});
    next_[before_[i]] = next_[i];
    before_[next_[i]] = before_[i];
    if (i == first_) first_ = next_[i];
    --left_;
    std::erase_if(inward_,
                  [&](std::size_t k) { return k == i || ((k == before_[i] || k == next_[i]) && turnAt(k) > 0.0); });
  }

  void fan(std::vector<Triangle>& triangles) const {
    std::size_t at = next_[first_];
    for (std::size_t k = 2; k < left_; ++k, at = next_[at])
      triangles.push_back({corners_[first_], corners_[at], corners_[next_[at]]});
  }

  bool isFree(std::size_t corner) const {
    const Vec3& a = point(before_[corner]);
    const Vec3& b = point(corner);
    const Vec3& c = point(next_[corner]);
    return std::none_of(inward_.begin(), inward_.end(), [&](std::size_t other) {
      if (other == before_[corner] || other == corner || other == next_[corner]) return false;
      const Vec3& p = point(other);
      return turn(a, b, p, normal_) >= 0.0 && turn(b, c, p, normal_) >= 0.0 && turn(c, a, p, normal_) >= 0.0;
    });
  }

  std::span<const Vec3> points_;
  std::span<const std::uint32_t> corners_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> before_;
  std::vector<std::size_t> inward_;
  std::size_t left_;
  std::size_t first_ = 0;  // the corner that is still there and comes first
  Vec3 normal_ = Vec3::Zero();
};

}  // namespace

void triangulatePolygon(std::span<const Vec3> points, std::span<const std::uint32_t> polygon,
                        std::vector<Triangle>& triangles) {
  if (polygon.size() == 3) {
    triangles.push_back({polygon[0], polygon[1], polygon[2]});
  } else {
    EarClipper(points, polygon).run(triangles);
  }
}

}  // namespace vantage
