#include "io/polygon_soup.h"

namespace vantage {
namespace {

constexpr std::size_t kMaxEarCorners = 64;

// Twice the signed area of a, b, c seen from the tip of `normal`.
double turn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
  return (b - a).cross(c - a).dot(normal);
}

class EarClipper {
 public:
  EarClipper(std::span<const Vec3> points, std::span<const std::uint32_t> polygon)
      : points_(points), left_(polygon.begin(), polygon.end()) {
    const Vec3& first = points_[left_[0]];
    for (std::size_t i = 1; i + 1 < left_.size(); ++i)
      normal_ += (points_[left_[i]] - first).cross(points_[left_[i + 1]] - first);
  }

  void run(std::vector<Triangle>& triangles) {
    while (left_.size() > 3) {
      const std::size_t ear = findEar();
      if (ear == left_.size()) break;
      triangles.push_back({before(ear), left_[ear], after(ear)});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    for (std::size_t i = 1; i + 1 < left_.size(); ++i) triangles.push_back({left_[0], left_[i], left_[i + 1]});
  }

 private:
  std::uint32_t before(std::size_t i) const { return left_[(i + left_.size() - 1) % left_.size()]; }
  std::uint32_t after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }

  // The corner that makes a convex triangle without another corner in it; left_.size() when there is none.
  std::size_t findEar() const {
    for (std::size_t i = 1; i <= left_.size(); ++i) {
      const std::size_t corner = i % left_.size();
      if (turn(points_[before(corner)], points_[left_[corner]], points_[after(corner)], normal_) > 0.0 &&
          isFree(corner))
        return corner;
    }
    return left_.size();
  }

  bool isFree(std::size_t corner) const {
    const Vec3& a = points_[before(corner)];
    const Vec3& b = points_[left_[corner]];
    const Vec3& c = points_[after(corner)];
    for (const std::uint32_t other : left_) {
      if (other == before(corner) || other == left_[corner] || other == after(corner)) continue;
      const Vec3& p = points_[other];
      if (turn(a, b, p, normal_) >= 0.0 && turn(b, c, p, normal_) >= 0.0 && turn(c, a, p, normal_) >= 0.0) return false;
    }
    return true;
  }

  std::span<const Vec3> points_;
  std::vector<std::uint32_t> left_;
  Vec3 normal_ = Vec3::Zero();
};

}  // namespace

void triangulatePolygon(std::span<const Vec3> points, std::span<const std::uint32_t> polygon,
                        std::vector<Triangle>& triangles) {
  if (polygon.size() == 3) {
    triangles.push_back({polygon[0], polygon[1], polygon[2]});
  } else if (polygon.size() <= kMaxEarCorners) {
    EarClipper(points, polygon).run(triangles);
  } else {
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
  }
}

}  // namespace vantage
