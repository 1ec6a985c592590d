#include <algorithm>
#include <array>
#include <cmath>

#include "support/sample_objects/distance_fields.h"
#include "support/sample_objects/sample_objects.h"

namespace vantage::testing {
namespace {

// The creature looks along -y and is the same left and right: `m` is the point with |x|.

double base(const Vec3& p) {
  const double scallop = 1.6 * std::cos(8.0 * std::atan2(p.y(), p.x())) * std::min(1.0, p.head<2>().norm() / 40.0);
  return join(post(p, Vec3(0, 0, 0), 46.0 + scallop, 9.0, 3.0), post(p, Vec3(0, 0, 3), 36.0, 12.0, 4.0), 4.0);
}

double body(const Vec3& m) {
  const double belly = ellipsoid(m, Vec3(0, 0, 36), Vec3(23, 20, 25));
  const double chest = ellipsoid(m, Vec3(0, -1, 60), Vec3(19, 16, 18));
  const double thigh = ellipsoid(m, Vec3(19, -11, 25), Vec3(9, 14, 13));
  const double foot = ellipsoid(m, Vec3(20, -26, 17), Vec3(7, 11, 5.5));
  return join(join(join(belly, chest, 8.0), thigh, 4.0), foot, 3.0);
}

double head(const Vec3& m) {
  static const std::array<Vec3, 4> kHorn{Vec3(8, -9, 96), Vec3(14, -6, 105), Vec3(19, 0, 111), Vec3(20, 8, 113)};
  const double skull = ellipsoid(m, Vec3(0, -12, 85), Vec3(14, 15, 14));
  const double snout = bar(m, Vec3(0, -20, 81), Vec3(0, -31, 78), 8.5, 6.0);
  const double brow = bar(m, Vec3(2, -24, 90), Vec3(11, -19, 92), 2.6, 2.0);
  const double ear = plate(m, Vec3(11, -8, 88), Vec3(13, -4, 82), Vec3(27, -3, 95), 3.6);
  const double face = join(join(skull, snout, 5.0), brow, 2.0);
  const double eyed = cut(face, sphere(m, Vec3(6.5, -25.5, 87.0), 3.4), 1.0);
  const double mouth = bar(m, Vec3(0, -38, 75.5), Vec3(9, -27, 77), 1.6, 1.2);
  return join(join(cut(eyed, mouth, 0.8), ear, 2.5), tube(m, kHorn, 4.2, 1.6), 2.0);
}

double wing(const Vec3& m) {
  const Vec3 shoulder(10, 12, 70);
  const Vec3 tip(52, 26, 112);
  const Vec3 middle(54, 30, 74);
  const Vec3 low(34, 26, 46);
  const Vec3 root(10, 14, 42);
  double skin = plate(m, shoulder, tip, middle, 3.2);
  skin = join(skin, plate(m, shoulder, middle, low, 3.2), 1.0);
  skin = join(skin, plate(m, shoulder, low, root, 3.2), 1.0);
  const double bones =
      std::min({bar(m, shoulder, tip, 4.2, 2.2), bar(m, shoulder, middle, 3.4, 2.2), bar(m, shoulder, low, 3.2, 2.2)});
  return join(skin, bones, 2.0);
}

// Both arms hold a ring before the belly.
double arms(const Vec3& m) {
  static const std::array<Vec3, 4> kArm{Vec3(17, -6, 64), Vec3(28, -17, 52), Vec3(24, -31, 47), Vec3(13, -37, 50)};
  return join(tube(m, kArm, 6.0, 3.8), ring(m, Vec3(0, -38, 50), Vec3::UnitY(), 13.0, 6.4), 2.0);
}

double tail(const Vec3& p) {
  static const std::array<Vec3, 7> kTail{Vec3(0, 17, 22), Vec3(12, 28, 18), Vec3(26, 30, 17), Vec3(37, 19, 17),
                                         Vec3(40, 4, 18), Vec3(44, -6, 24), Vec3(46, -6, 32)};
  return tube(p, kTail, 6.5, 2.2);
}

// The stem that grows out of the back, its knot, the drip pan and the cup.
double candle(const Vec3& p) {
  const double stem = bar(p, Vec3(0, 12, 40), Vec3(0, 10, 122), 8.5, 6.5);
  const double knot = ring(p, Vec3(0, 10.3, 112), Vec3::UnitZ(), 6.0, 8.0);
  const double pan = cut(post(p, Vec3(0, 10, 120), 23.0, 7.0, 2.4), post(p, Vec3(0, 10, 124), 19.5, 20.0, 2.0), 1.5);
  const double cup = cut(post(p, Vec3(0, 10, 122), 14.0, 28.0, 1.6), post(p, Vec3(0, 10, 128), 10.8, 40.0, 1.5), 0.8);
  return join(join(join(stem, knot, 3.0), pan, 3.0), cup, 2.0);
}

}  // namespace

double candleHolder(const Vec3& p) {
  const Vec3 m(std::abs(p.x()), p.y(), p.z());
  double figure = join(body(m), head(m), 5.0);
  figure = join(figure, wing(m), 3.0);
  figure = join(figure, arms(m), 2.0);
  figure = join(figure, tail(p), 3.0);
  figure = join(figure, candle(p), 3.0);
  return std::max(join(figure, base(p), 3.0), -p.z());
}

}  // namespace vantage::testing
