#include "support/scenes/small_profiles.h"

#include <sstream>

#include "base/random.h"

namespace vantage::testing {
namespace {

const std::string kCommon =
    R"("breakdown_angle_deg": 60, "range_mm": [50, 900]}, "viewing_volume": {"radius_mm": 150, "height_mm": 300},)";

ScannerProfile parsed(const std::string& scanner, const std::string& workspace) {
  return parseProfile({"test", R"({"name": "test", "scanner": {)" + scanner + kCommon + workspace + "}", {}});
}

std::string turntableOf(int steps) {
  return R"("workspace": {"type": "turntable", "steps": )" + std::to_string(steps) + "}";
}

const std::string kPinhole =
    R"("type": "pinhole", "position": [420, 10, 240], "look_at": [0, 0, 140], "rows": 60, "columns": 70,
       "horizontal_fov_deg": 40, "vertical_fov_deg": 36, "receivers": [[-60, 0, 0]],)";

}  // namespace

ScannerProfile rotatingStripe(int steps) {
  return parsed(R"("type": "rotating_stripe", "position": [300, 0, 150], "stripe_height_mm": 300,
                   "samples_per_stripe": 100, "stripes": 90, "sweep_deg": 60, "receivers": [[60, 0, 0]],)",
                turntableOf(steps));
}

ScannerProfile linearStripe(int steps) {
  return parsed(R"("type": "linear_stripe", "position": [320, 0, 150], "stripe_height_mm": 290,
                   "samples_per_stripe": 70, "stripes": 80, "travel_mm": 230, "receivers": [],)",
                turntableOf(steps));
}

ScannerProfile pinhole(int steps) {
  return parsed(kPinhole, turntableOf(steps));
}

ScannerProfile rayTable(int steps) {
  const auto owner = pinhole(1).rays;
  const RayGrid& rays = *owner;
  std::ostringstream table;
  table.precision(17);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const char* separator = "";
    for (const Vec3& v : {rays.ray(i).origin, rays.ray(i).direction, rays.receivers(i)[0]}) {
      table << separator << v.x() << ',' << v.y() << ',' << v.z();
      separator = ",";
    }
    table << '\n';
  }
  const std::string scanner = R"("type": "rays", "file": "rays.csv", "rows": 60, "columns": 70,)";
  return parseProfile({"test",
                       R"({"name": "test", "scanner": {)" + scanner + kCommon + turntableOf(steps) + "}",
                       {{"rays.csv", table.str()}}});
}

ScannerProfile tiltedPinhole(const std::string& tilts, int steps) {
  return parsed(kPinhole, R"("workspace": {"type": "turntable_tilt", "tilts_deg": [)" + tilts +
                              R"(], "tilt_center": [0, 0, 140], "steps": )" + std::to_string(steps) + "}");
}

std::vector<ScannerProfile> everyKind() {
  return {rotatingStripe(), linearStripe(), pinhole(), rayTable(), tiltedPinhole("0, 25"), tiltedPinhole("20, 70")};
}

std::vector<ObservationSource> scatteredSources(int count, double radius, double halfHeight) {
  std::vector<ObservationSource> sources;
  for (int i = 0; i < count; ++i) {
    Random random(11, static_cast<std::uint64_t>(i));
    const double angle = 2.0 * kPi * random.uniform();
    const double axial = radius * std::sqrt(random.uniform());
    ObservationSource source;
    source.centre =
        Vec3(axial * std::cos(angle), axial * std::sin(angle), 150.0 + halfHeight * (2.0 * random.uniform() - 1.0));
    source.normal = Vec3(random.normal(), random.normal(), 0.5 * random.normal()).normalized();
    source.weight = 0.5 + random.uniform();
    sources.push_back(source);
  }
  return sources;
}

std::vector<ObservationSource> sourcesOf(const Mesh& mesh) {
  std::vector<ObservationSource> sources;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 normal = triangleNormal(mesh, t);
    const bool degenerate = normal.isZero(0.0);
    sources.push_back({triangleCentre(mesh, t), degenerate ? Vec3(Vec3::UnitZ()) : normal, triangleArea(mesh, t)});
  }
  return sources;
}

}  // namespace vantage::testing
