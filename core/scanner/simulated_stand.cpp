#include "scanner/simulated_stand.h"

#include <algorithm>
#include <vector>

#include "base/random.h"
#include "geometry/resting_faces.h"

namespace vantage {
namespace {

// The stream of random numbers of the first stand; every stand has one of its own.
constexpr std::uint64_t kStandStream = 0x7374616eULL << 24;
// How far from the axis a hand puts an object down, at most [mm].
constexpr double kBeside = 5.0;

const RestingFace& faceFor(const std::vector<RestingFace>& faces, const std::optional<Vec3>& down, int stand) {
  if (!down) return faces[static_cast<std::size_t>(stand) % faces.size()];
  return *std::max_element(faces.begin(), faces.end(), [&](const RestingFace& a, const RestingFace& b) {
    return a.normal.dot(*down) < b.normal.dot(*down);
  });
}

}  // namespace

Pose simulatedStand(const Mesh& object, const std::optional<Vec3>& down, int stand, std::uint64_t seed) {
  if (stand == 0) return Pose::Identity();
  const std::vector<RestingFace> faces = restingFaces(object.vertices);
  Random random(seed, kStandStream + static_cast<std::uint64_t>(stand));
  const double angle = 2.0 * kPi * random.uniform();
  const double x = kBeside * (2.0 * random.uniform() - 1.0);
  const double y = kBeside * (2.0 * random.uniform() - 1.0);
  Pose put = Pose::Identity();
  put.translate(Vec3(x, y, 0.0));
  put.rotate(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
  return put * restingPose(faceFor(faces, down, stand));
}

}  // namespace vantage
