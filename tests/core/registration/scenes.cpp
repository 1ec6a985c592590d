#include "scenes.h"

#include <cmath>
#include <utility>

#include "base/random.h"
#include "scanner/ray_patterns.h"
#include "support/meshes.h"
#include "support/simulation.h"

namespace vantage::testing {

Mesh makeBall() {
  Mesh mesh = makeSphere(1.0, 80);
  for (Vec3& v : mesh.vertices) {
    const Vec3 d = v;
    const double radius = 58.0 + 2.0 * std::sin(7.0 * d.x() + 1.0) + 2.0 * std::sin(8.0 * d.y() + 3.0 * d.z()) +
                          1.5 * std::sin(9.0 * d.z() + 5.0 * d.x() * d.y());
    v = radius * d + Vec3(0, 0, 70);
  }
  return mesh;
}

Mesh makeEggTray() {
  Mesh mesh = makeGrid(120, 120, 1.0);
  for (Vec3& v : mesh.vertices) {
    const double y = v.x() - 60.0;
    const double z = v.y() + 20.0;
    v = Vec3(1.5 * std::sin(2.0 * kPi * y / 12.0) + 1.5 * std::sin(2.0 * kPi * z / 12.0), y, z);
  }
  return mesh;
}

std::shared_ptr<const ScannerProfile> makeProfile(double rangeSigma, int rows, int columns) {
  auto profile = std::make_shared<ScannerProfile>();
  profile->rays = std::make_shared<RayGrid>(
      makeRays(RotatingStripe{Vec3(300, 0, 75), 150.0, rows, columns, radians(30.0)}, ReceiverOffsets{}));
  profile->noise.rangeSigma = rangeSigma;
  profile->workspace = turntable(90);
  return profile;
}

namespace {

View viewOf(RangeImage image) {
  View view;
  view.mesh = std::make_shared<const ViewMesh>(triangulate(image, TriangulationOptions()));
  view.T_object_scanner = image.T_table_scanner;
  view.image = std::make_shared<const RangeImage>(std::move(image));
  return view;
}

}  // namespace

View scanFrom(const Mesh& object, const std::shared_ptr<const ScannerProfile>& profile, int position, unsigned seed) {
  SimulationOptions options;
  options.seed = seed;
  const Rig rig = simulation(object, profile, options);
  return viewOf(scanFrom(rig, position, Progress()));
}

View scanVase(const std::shared_ptr<const ScannerProfile>& profile, int position, unsigned seed) {
  RangeImage image;
  image.rays = profile->rays;
  image.station.position = position;
  image.T_table_scanner = profile->workspace.poses[static_cast<std::size_t>(position)];
  image.range.assign(image.rays->size(), kNoSample);
  for (std::size_t i = 0; i < image.range.size(); ++i) {
    // The rays are horizontal: each meets a circle about z.
    const RangingRay& ray = image.rays->ray(i);
    const double z = ray.origin.z();
    if (z < 10.0 || z > 130.0) continue;
    const double radius = 45.0 + 6.0 * std::sin(z / 14.0);
    const Vec2 o = ray.origin.head<2>();
    const Vec2 d = ray.direction.head<2>();
    const double nearest = -o.dot(d);
    const double inside = radius * radius - (o + nearest * d).squaredNorm();
    // Steeper than 60 degrees is not measured.
    if (inside < 0.25 * radius * radius) continue;
    const double noise = profile->noise.rangeSigma * Random(seed, i).normal();
    image.range[i] = static_cast<float>(nearest - std::sqrt(inside) + noise);
  }
  return viewOf(std::move(image));
}

Pose randomMotion(unsigned seed, double angle, double shift, const Vec3& centre) {
  Random random(seed);
  auto direction = [&] { return Vec3(random.normal(), random.normal(), random.normal()).normalized(); };
  Pose motion = Pose::Identity();
  motion.translate(centre + shift * direction());
  motion.rotate(Eigen::AngleAxisd(angle, direction()));
  motion.translate(-centre);
  return motion;
}

Vec3 centroid(const View& view) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : view.mesh->mesh.vertices) sum += p;
  return view.T_object_scanner * Vec3(sum / static_cast<double>(view.mesh->mesh.vertices.size()));
}

double poseError(const View& view, const Pose& a, const Pose& b) {
  double squares = 0.0;
  for (const Vec3& p : view.mesh->mesh.vertices) squares += (a * p - b * p).squaredNorm();
  return std::sqrt(squares / static_cast<double>(view.mesh->mesh.vertices.size()));
}

}  // namespace vantage::testing
