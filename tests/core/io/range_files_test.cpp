#include "io/range_files.h"

#include <cmath>
#include <sstream>

#include "core/io/expect_error.h"
#include "scanner/ray_patterns.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;

// How the cells of an ideal grid lie: interlaced rows and warped columns, seen along slightly tilted lines.
struct Pattern {
  int rows = 20;
  int columns = 30;
  double interlace = 0.0;  // shift of odd rows
  double warp = 0.0;       // columns bunch together toward one end
  Vec2 slope = Vec2::Zero();

  Vec2 place(int r, int c) const { return {0.5 * c + warp * c * c + (r % 2 == 1 ? interlace : 0.0), 0.7 * r}; }
};

// A ball on a floor, with the floor seen only in part: steps in depth and empty cells.
std::optional<double> depthAt(int r, int c) {
  const double d = std::hypot(r - 9.0, c - 14.0);
  if (d < 6.0) return 20.0 + std::sqrt(36.0 - d * d);
  if (r > 15 || c < 2) return std::nullopt;
  return 0.01 * r;
}

std::string fileOf(const Pattern& pattern, double unit = 1.0, const std::string& info = "") {
  std::ostringstream points;
  std::ostringstream grid;
  points.precision(17);
  std::size_t count = 0;
  for (int r = 0; r < pattern.rows; ++r) {
    for (int c = 0; c < pattern.columns; ++c) {
      const auto z = depthAt(r, c);
      if (!z) {
        grid << "0\n";
        continue;
      }
      const Vec2 p = pattern.place(r, c) + pattern.slope * *z;
      points << p.x() * unit << ' ' << p.y() * unit << ' ' << *z * unit << '\n';
      grid << "1 " << count++ << '\n';
    }
  }
  std::ostringstream text;
  text << "ply\nformat ascii 1.0\nobj_info is_cyberware_data 1\nobj_info num_cols " << pattern.columns
       << "\nobj_info num_rows " << pattern.rows << '\n'
       << info << "element vertex " << count << "\nproperty float x\nproperty float y\nproperty float z\n"
       << "element range_grid " << pattern.rows * pattern.columns
       << "\nproperty list uchar int vertex_indices\nend_header\n"
       << points.str() << grid.str();
  return text.str();
}

RangeImage read(const std::string& text, const RangeFileOptions& options = {}) {
  const TemporaryFolder folder;
  return readRangeFile(folder.write("scan.ply", text), options);
}

// Every ray, sampled or not, must lie where the pattern has it.
void expectPattern(const RangeImage& image, const Pattern& pattern, double tolerance) {
  for (int r = 0; r < pattern.rows; ++r) {
    for (int c = 0; c < pattern.columns; ++c) {
      const RangingRay& ray = image.rays->ray(image.rays->index(r, c));
      const double along = -ray.origin.z() / ray.direction.z();
      const Vec3 floor = ray.origin + along * ray.direction;
      EXPECT_NEAR((floor.head<2>() - pattern.place(r, c)).norm(), 0.0, tolerance) << r << ", " << c;
    }
  }
}

TEST(RangeFile, ParallelRaysLookDownAndReproduceTheSamples) {
  const Pattern pattern;
  const RangeImage image = read(fileOf(pattern));
  validate(image);
  for (std::size_t i = 0; i < image.rays->size(); ++i) {
    EXPECT_EQ(image.rays->ray(i).direction, Vec3(0, 0, -1));
    EXPECT_EQ(image.rays->ray(i).origin.z(), image.rays->ray(0).origin.z());
    const auto z = depthAt(static_cast<int>(i) / pattern.columns, static_cast<int>(i) % pattern.columns);
    ASSERT_EQ(image.valid(i), z.has_value());
    if (z) {
      EXPECT_NEAR(image.point(i).z(), *z, 1e-5);
    }
  }
  EXPECT_NEAR(image.rays->ray(0).origin.z(), 26.0 + 100.0, 1e-9);
  expectPattern(image, pattern, 1e-9);
}

TEST(RangeFile, FillsInterlacedRowsAndWarpedColumns) {
  Pattern pattern;
  pattern.interlace = 0.25;
  expectPattern(read(fileOf(pattern)), pattern, 1e-9);
  // Beyond the samples the spacing of the columns can only be guessed: half a cell is near enough to find a ray.
  pattern.warp = 0.004;
  expectPattern(read(fileOf(pattern)), pattern, 0.25);
}

TEST(RangeFile, FindsTheDirectionOfTiltedRays) {
  Pattern pattern;
  pattern.slope = Vec2(0.5, -0.1);
  const TemporaryFolder folder;
  const RangeGrid grid = readRangeGrid(folder.write("scan.ply", fileOf(pattern)));
  EXPECT_NEAR((fitSightSlopes(grid.samples).constant - pattern.slope).norm(), 0.0, 1e-3);
  expectPattern(read(fileOf(pattern)), pattern, 0.02);
}

TEST(RangeFile, RaysCanBeFoundAnywhereInTheGrid) {
  Pattern pattern;
  pattern.interlace = 0.25;
  pattern.slope = Vec2(0.3, 0.0);
  const RangeImage image = read(fileOf(pattern));
  for (std::size_t i = 0; i < image.rays->size(); i += 7) {
    const RangingRay& ray = image.rays->ray(i);
    const auto found = image.rays->locate(ray.origin + 90.0 * ray.direction);
    ASSERT_TRUE(found) << i;
    EXPECT_EQ(image.rays->nearest(*found), i);
  }
}

TEST(RangeFile, TellsMetresFromMillimetresUnlessTold) {
  const TemporaryFolder folder;
  const Pattern pattern;
  auto scaleOf = [&](double unit, const std::string& info, std::optional<double> asked) {
    RangeFileOptions options;
    options.scale = asked;
    return readRangeGrid(folder.write("scan.ply", fileOf(pattern, unit, info)), options).scale;
  };
  EXPECT_EQ(scaleOf(1.0, "", {}), 1.0);
  EXPECT_EQ(scaleOf(0.001, "", {}), 1000.0);
  EXPECT_EQ(scaleOf(0.001, "obj_info unit_mm 1\n", {}), 1.0);
  EXPECT_EQ(scaleOf(0.001, "obj_info unit_mm 1\n", 25.4), 25.4);
  expectError<InvalidInput>([&] { scaleOf(1.0, "obj_info unit_mm zero\n", {}); }, {"unit_mm", "'zero'"});
  expectError<InvalidInput>([&] { scaleOf(1.0, "", -1.0); }, {"scale", "above 0"});
}

TEST(RangeFile, WrittenByUsComesBackAsItWas) {
  const TemporaryFolder folder;
  Pattern pattern;
  pattern.interlace = 0.25;
  const RangeImage image = read(fileOf(pattern));
  writeRangeFile(image, folder.file("out.ply"));
  const RangeImage back = readRangeFile(folder.file("out.ply"));
  ASSERT_EQ(back.rays->rows(), image.rays->rows());
  for (std::size_t i = 0; i < image.rays->size(); ++i) {
    ASSERT_EQ(back.valid(i), image.valid(i));
    if (image.valid(i)) {
      EXPECT_NEAR((back.point(i) - image.point(i)).norm(), 0.0, 1e-4);
    }
  }
}

// A depth camera that sees the plane z = 0 in every second pixel.
RangeImage cameraImage() {
  RangeImage image;
  image.rays = std::make_shared<const RayGrid>(makeRays(Pinhole{{300, 0, 150}, {0, 0, 20}, 12, 16, 0.6, 0.5}, {}));
  image.range.assign(image.rays->size(), kNoSample);
  for (std::size_t i = 0; i < image.range.size(); i += 2) {
    const RangingRay& ray = image.rays->ray(i);
    image.range[i] = static_cast<float>(-ray.origin.z() / ray.direction.z());
  }
  return image;
}

TEST(RangeFile, OfAKnownScannerComesBackOnItsRays) {
  const TemporaryFolder folder;
  const RangeImage image = cameraImage();
  writeRangeFile(image, folder.file("out.ply"));
  const RangeImage back = readRangeFile(folder.file("out.ply"), image.rays);
  EXPECT_EQ(back.rays, image.rays);
  for (std::size_t i = 0; i < image.range.size(); ++i) {
    ASSERT_EQ(back.valid(i), image.valid(i));
    if (image.valid(i)) {
      EXPECT_NEAR(back.range[i], image.range[i], 1e-3F);
    }
  }
}

TEST(RangeFile, OfAKnownScannerIsRefusedWithoutOrWithAnother) {
  const TemporaryFolder folder;
  const RangeImage image = cameraImage();
  writeRangeFile(image, folder.file("out.ply"));
  expectError<InvalidInput>([&] { static_cast<void>(readRangeFile(folder.file("out.ply"))); }, {"out.ply", "profile"});
  const auto other =
      std::make_shared<const RayGrid>(makeRays(Pinhole{{300, 0, 150}, {0, 50, 20}, 12, 16, 0.6, 0.5}, {}));
  expectError<InvalidInput>([&] { static_cast<void>(readRangeFile(folder.file("out.ply"), other)); },
                            {"row 0, column 0", "beside its ranging ray"});
  const auto smaller =
      std::make_shared<const RayGrid>(makeRays(Pinhole{{300, 0, 150}, {0, 0, 20}, 12, 15, 0.6, 0.5}, {}));
  expectError<InvalidInput>([&] { static_cast<void>(readRangeFile(folder.file("out.ply"), smaller)); },
                            {"12 x 16", "12 x 15"});
}

TEST(RangeFile, RefusesWhatIsNoRangeFile) {
  const std::string good = fileOf({});
  auto changed = [&](const std::string& what, const std::string& to) {
    std::string text = good;
    text.replace(text.find(what), what.size(), to);
    return text;
  };
  auto refuse = [](const std::string& text, const std::vector<std::string>& parts) {
    expectError<InvalidInput>([&] { static_cast<void>(read(text)); }, parts);
  };
  refuse(changed("element range_grid", "element some_grid"), {"scan.ply", "no element 'range_grid'"});
  refuse(changed("obj_info num_cols 30\n", ""), {"num_cols", "missing"});
  refuse(changed("num_rows 20", "num_rows 19"), {"600 entries", "570"});
  refuse(changed("num_rows 20", "num_rows many"), {"num_rows", "'many'"});
  refuse(changed("1 5\n", "1 9999\n"), {"range_grid", "vertices"});
  refuse(changed("property float z", "property float depth"), {"x, y and z"});
  refuse(
      "ply\nformat ascii 1.0\nobj_info num_cols 2\nobj_info num_rows 2\nelement vertex 0\nproperty float x\nproperty "
      "float y\n"
      "property float z\nelement range_grid 4\nproperty list uchar int vertex_indices\nend_header\n0\n0\n0\n0\n",
      {"no samples"});
}

}  // namespace
}  // namespace vantage
