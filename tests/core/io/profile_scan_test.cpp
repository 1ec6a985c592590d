#include "io/profile_scan.h"

#include <functional>

#include "core/io/expect_error.h"
#include "io/scan_candidates.h"
#include "support/test_data.h"
#include "support/written_scans.h"

namespace vantage {
namespace {

using testing::cameraOf;
using testing::cameraProfile;
using testing::expectError;
using testing::stripeProfile;
using testing::TemporaryFolder;
using testing::Writing;
using testing::WrittenScan;

RangeImage readText(const std::string& name, const std::string& bytes, const ScannerProfile& profile,
                    const ScanReadingOptions& options = {}, const std::optional<Pose>& T_table_scanner = {}) {
  const TemporaryFolder folder;
  return readScan(folder.write(name, bytes), profile, options, {}, T_table_scanner);
}

void expectScan(const RangeImage& image, const WrittenScan& scan, bool coloured, double tolerance = 2e-3) {
  ASSERT_EQ(image.rays, scan.profile.rays);
  ASSERT_EQ(image.range.size(), scan.range.size());
  ASSERT_EQ(image.colours.size(), coloured ? scan.range.size() : 0U);
  validate(image);
  for (std::size_t i = 0; i < scan.range.size(); ++i) {
    ASSERT_EQ(image.valid(i), scan.points[i].has_value()) << i;
    if (!image.valid(i)) continue;
    ASSERT_NEAR(image.range[i], scan.range[i], tolerance) << i;
    if (coloured) {
      ASSERT_EQ(image.colours[i], WrittenScan::colourOf(i)) << i;
    }
  }
}

TEST(ProfileScan, ReadsEveryFormatInAnyOrderOfRows) {
  const ScannerProfile profile = stripeProfile();
  const WrittenScan scan(profile);
  for (const bool fromTop : {true, false}) {
    Writing how;
    how.fromTop = fromTop;
    how.colours = true;
    expectScan(readText("a.ply", testing::plyText(scan, how, true), profile), scan, true);
    expectScan(readText("a.ply", testing::plyText(scan, how, false), profile), scan, true);
    expectScan(readText("a.pcd", testing::pcdText(scan, how, false), profile), scan, true);
    expectScan(readText("a.pcd", testing::pcdText(scan, how, true), profile), scan, true);
    expectScan(readText("a.ptx", testing::ptxText(scan, how), profile), scan, true);
    expectScan(readText("a.asc", testing::xyzText(scan, how, false, false), profile), scan, true);
    how.colours = false;
    for (const char* missing : {"nan nan nan", "0 0 0", "-9999 -9999 -9999"}) {
      how.missing = missing;
      expectScan(readText("a.xyz", testing::xyzText(scan, how, true, true), profile), scan, false);
    }
  }
}

TEST(ProfileScan, ReadsDecimalCommas) {
  const ScannerProfile profile = stripeProfile();
  const WrittenScan scan(profile);
  Writing how;
  how.comma = true;
  expectScan(readText("a.ply", testing::plyText(scan, how, true), profile), scan, false);
  expectScan(readText("a.ptx", testing::ptxText(scan, how), profile), scan, false);
  expectScan(readText("a.asc", testing::xyzText(scan, how, false, false), profile), scan, false);
  how.missing = "-9999 -9999 -9999";
  expectScan(readText("a.xyz", testing::xyzText(scan, how, true, true), profile), scan, false);
}

TEST(ProfileScan, AsksForAUnitThatOnlyTheRaysTell) {
  const ScannerProfile profile = stripeProfile();
  const WrittenScan scan(profile);
  const std::vector<std::pair<std::string, double>> units{{"m", 1000.0}, {"inch", 25.4}, {"cm", 10.0}};
  for (const auto& [name, millimetres] : units) {
    Writing how;
    how.unit = 1.0 / millimetres;
    const std::string text = testing::plyText(scan, how, true);
    expectError<UnansweredQuestion>([&] { static_cast<void>(readText("a.ply", text, profile)); },
                                    {"a.ply", "seems to be in " + name, "say --unit " + name});
    ScanReadingOptions options;
    options.unit = millimetres;
    expectScan(readText("a.ply", text, profile, options), scan, false);
    options.unit = 1.0;
    expectError<InvalidInput>([&] { static_cast<void>(readText("a.ply", text, profile, options)); },
                              {"is not of this scanner", "--unit " + name});
  }
}

TEST(ProfileScan, FindsTheFrame) {
  const ScannerProfile profile = stripeProfile();
  const WrittenScan scan(profile);
  const Pose T_table_scanner(Eigen::AngleAxisd(1.0, Vec3::UnitZ()));
  for (const bool openGl : {false, true}) {
    Writing how;
    how.T_file_scanner = cameraOf({300, 0, 5}, -Vec3::UnitX(), openGl).inverse();
    expectScan(readText("a.ply", testing::plyText(scan, how, true), profile), scan, false);
    expectScan(readText("a.asc", testing::xyzText(scan, how, false, false), profile), scan, false);
    ScanReadingOptions options;
    options.frame = parseFrame(openGl ? "opengl" : "camera");
    expectScan(readText("a.asc", testing::xyzText(scan, how, false, false), profile, options), scan, false);
    options.frame = parseFrame(openGl ? "camera" : "profile");
    expectError<InvalidInput>(
        [&] { static_cast<void>(readText("a.asc", testing::xyzText(scan, how, false, false), profile, options)); },
        {"is not of this scanner", openGl ? "--frame gl" : "--frame camera"});
  }
  Writing table;
  table.T_file_scanner = T_table_scanner;
  expectScan(readText("a.asc", testing::xyzText(scan, table, false, false), profile, {}, T_table_scanner), scan, false);
  Writing head;
  head.T_file_scanner =
      (Eigen::Translation3d(280, 30, 20) * Eigen::AngleAxisd(2.0, Vec3(1, 2, 3).normalized())).inverse();
  expectScan(readText("a.ptx", testing::ptxText(scan, head), profile), scan, false, 5e-3);
  Writing upright;
  upright.T_file_scanner.linear() = uprightTurn(Axis::Y).transpose();
  ScanReadingOptions options;
  options.up = Axis::Y;
  expectScan(readText("a.asc", testing::xyzText(scan, upright, false, false), profile, options), scan, false);
}

TEST(ProfileScan, ReadsDepthWithIntrinsics) {
  const ScannerProfile profile = cameraProfile();
  const WrittenScan scan(profile);
  const Pose camera = cameraOf({300, 0, 40}, Vec3(-300, 0, -40).normalized());
  const TemporaryFolder folder;
  const std::string file = folder.write("a.png", testing::depthPng(scan, camera, 100.0));
  expectError<InvalidInput>([&] { static_cast<void>(readScan(file, profile)); }, {"a.png", "a.json", "depth_scale"});
  static_cast<void>(folder.write("a.json", testing::intrinsicsText(1, 100000.0)));
  expectScan(readScan(file, profile), scan, false, 0.01);
  static_cast<void>(folder.write("a.json", testing::intrinsicsText(1, 0.00001)));
  expectScan(readScan(file, profile), scan, false, 0.01);
}

// What a scanner sees of a plane through the origin.
void lookAtPlane(WrittenScan& scan, const Vec3& normal) {
  for (std::size_t i = 0; i < scan.range.size(); ++i) {
    const RangingRay& ray = scan.profile.rays->ray(i);
    const double t = -ray.origin.dot(normal) / ray.direction.dot(normal);
    scan.points[i] = ray.origin + t * ray.direction;
    scan.range[i] = static_cast<float>(t);
  }
}

// Twice as many pixels as rays: the ranges are those of the rays, not of the pixels beside them. The range r of a plane
// that a ray meets at an angle bends by r (1 + 2 tan^2) per square radian; straight lines to points half a cell and one
// cell away are off by less than that for one cell. Pixels count hundredths of a millimetre.
TEST(ProfileScan, PutsFinerSamplesOnTheRays) {
  const ScannerProfile profile = cameraProfile();
  const ScannerProfile finer = cameraProfile(2);
  const Vec3 forward = Vec3(-300, 0, -40).normalized();
  const Pose camera = cameraOf({300, 0, 40}, forward);
  const double cell = 0.24 / 40.0;
  for (const double tilt : {0.0, 30.0, 60.0}) {
    const Vec3 normal = Eigen::AngleAxisd(radians(tilt), Vec3::UnitZ()) * Vec3(-forward);
    WrittenScan scan(finer);
    WrittenScan expected(profile);
    lookAtPlane(scan, normal);
    lookAtPlane(expected, normal);
    const TemporaryFolder folder;
    static_cast<void>(folder.write("a.json", testing::intrinsicsText(2, 100000.0)));
    const RangeImage image = readScan(folder.write("a.png", testing::depthPng(scan, camera, 100.0)), profile);
    for (int row = 1; row + 1 < profile.rays->rows(); ++row)
      for (int column = 1; column + 1 < profile.rays->columns(); ++column) {
        const std::size_t i = profile.rays->index(row, column);
        ASSERT_TRUE(image.valid(i)) << tilt << " degrees, ray " << i;
        const double cosine = std::abs(profile.rays->ray(i).direction.dot(normal));
        const double bend = 2.0 / (cosine * cosine) - 1.0;
        const double range = static_cast<double>(expected.range[i]);
        ASSERT_NEAR(static_cast<double>(image.range[i]), range, range * bend * cell * cell + 0.02)
            << tilt << " degrees, ray " << i;
      }
  }
}

TEST(ProfileScan, RefusesTheFilesOfOtherScanners) {
  const ScannerProfile profile = stripeProfile();
  ScannerProfile other = profile;
  other.rays = std::make_shared<const RayGrid>(makeRays(Pinhole{{0, 300, 200}, {0, 0, 0}, 60, 60, 0.3, 0.3}, {}));
  const WrittenScan scan(other);
  for (const double unit : {1.0, 0.001}) {
    Writing how;
    how.unit = unit;
    expectError<InvalidInput>(
        [&] { static_cast<void>(readText("a.asc", testing::xyzText(scan, how, false, false), profile)); },
        {"a.asc", "is not of this scanner"});
  }
  ScanReadingOptions options;
  options.frame = parseFrame("x+");
  expectError<InvalidInput>(
      [&] { static_cast<void>(readText("a.asc", testing::xyzText(scan, {}, false, false), profile, options)); },
      {"profile, camera, gl or world"});
}

TEST(ProfileScan, RefusesWhatEndsEarly) {
  const ScannerProfile profile = stripeProfile();
  const WrittenScan scan(profile);
  const std::vector<std::pair<std::string, std::string>> files{{"a.ply", testing::plyText(scan, {}, true)},
                                                               {"a.ply", testing::plyText(scan, {}, false)},
                                                               {"a.pcd", testing::pcdText(scan, {}, false)},
                                                               {"a.pcd", testing::pcdText(scan, {}, true)},
                                                               {"a.ptx", testing::ptxText(scan, {})},
                                                               {"a.xyz", testing::xyzText(scan, {}, true, true)},
                                                               {"a.asc", testing::xyzText(scan, {}, false, false)}};
  for (const auto& [name, text] : files)
    for (const double share : {0.2, 0.6, 0.9}) {
      std::size_t size = static_cast<std::size_t>(share * static_cast<double>(text.size()));
      while (name == "a.asc" && text[size - 1] == '\n') --size;
      expectError<InvalidInput>(
          [&, &name = name, &text = text] { static_cast<void>(readText(name, text.substr(0, size), profile)); },
          {name});
    }
}

TEST(ProfileScan, NamesWhereTheHeadLooks) {
  const Pose head = headOf(*stripeProfile().rays);
  EXPECT_TRUE(head.isApprox(cameraOf({300, 0, 5}, -Vec3::UnitX()), 1e-9));
  const ScannerProfile down = [] {
    ScannerProfile profile;
    std::vector<RangingRay> rays;
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) rays.push_back({Vec3(c, -r, 100), -Vec3::UnitZ()});
    profile.rays = std::make_shared<const RayGrid>(4, 4, rays, std::vector<Vec3>{}, 0);
    return profile;
  }();
  EXPECT_TRUE(headOf(*down.rays).linear().col(0).isApprox(Vec3::UnitX(), 1e-9));
}

}  // namespace
}  // namespace vantage
