#include "io/scan_reader.h"

#include <cmath>

#include "core/io/expect_error.h"
#include "core/io/grid_scene.h"
#include "scanner/ray_patterns.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::parallelRays;
using testing::pinholeRays;
using testing::plyOf;
using testing::PlyStyle;
using testing::poseAround;
using testing::seeLump;
using testing::SeenGrid;
using testing::TemporaryFolder;

constexpr double kForward = 1.0;
constexpr double kBackward = -1.0;
constexpr double kDistance = 200.0;

SeenGrid seenBy(double forward, double azimuth) {
  return seeLump(60, 56, pinholeRays(forward), poseAround(azimuth, forward, kDistance));
}

std::vector<ReadScan> read(const std::vector<std::string>& texts, const ScanReadingOptions& options = {},
                           const std::vector<ScanPose>* list = nullptr, const ScannerProfile* profile = nullptr) {
  const TemporaryFolder folder;
  std::vector<std::string> files;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    std::string name = "s";
    name += std::to_string(i);
    files.push_back(folder.write(name + ".ply", texts[i]));
  }
  return readScans(files, list, profile, options);
}

// Samples lie where they were seen, before their rays, and every ray looks along `sight`.
void expectSeen(const ReadScan& scan, const SeenGrid& grid, const Vec3& sight, double tolerance = 1e-3) {
  validate(scan.image);
  ASSERT_EQ(scan.image.range.size(), grid.cells.size());
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    ASSERT_EQ(scan.image.valid(i), grid.cells[i].has_value()) << i;
    EXPECT_GT(scan.image.rays->ray(i).direction.dot(sight), 0.8);
    if (grid.cells[i]) {
      EXPECT_NEAR((scan.image.point(i) - *grid.cells[i]).norm(), 0.0, tolerance);
    }
  }
}

// Views from all around, and the list of where they were taken.
struct Round {
  std::vector<SeenGrid> grids;
  std::vector<std::string> texts;
  std::vector<ScanPose> list;
};

Round roundOf(double forward, bool pinhole, const PlyStyle& style = {}, double listUnit = 1.0) {
  Round round;
  for (int i = 0; i < 6; ++i) {
    const Pose pose = poseAround(60.0 * i, forward, pinhole ? kDistance : 0.0);
    round.grids.push_back(seeLump(60, 56, pinhole ? pinholeRays(forward) : parallelRays(forward), pose));
    round.texts.push_back(plyOf(round.grids.back(), style));
    round.list.push_back({std::string("s") + std::to_string(i), pose});
    round.list.back().T_object_scanner.translation() *= listUnit;
  }
  return round;
}

TEST(ScanReader, TellsBySpreadingRaysOnWhichSideTheScannerIs) {
  for (const double forward : {kForward, kBackward}) {
    const SeenGrid grid = seenBy(forward, 20.0);
    const auto scans = read({plyOf(grid, {0.001})});
    ASSERT_EQ(scans.size(), 1U);
    EXPECT_EQ(scans[0].reading.sight, forward * Vec3::UnitZ());
    EXPECT_EQ(scans[0].reading.sightKnownBy, KnownBy::Evidence);
    EXPECT_EQ(scans[0].reading.unit, 1000.0);
    EXPECT_EQ(scans[0].reading.unitKnownBy, KnownBy::Evidence);
    expectSeen(scans[0], grid, forward * Vec3::UnitZ());
  }
}

TEST(ScanReader, TellsByAllViewsOnWhichSideTheScannerOfParallelRaysIs) {
  for (const double forward : {kForward, kBackward}) {
    const Round round = roundOf(forward, false);
    const auto scans = read(round.texts, {}, &round.list);
    ASSERT_EQ(scans.size(), 6U);
    for (std::size_t i = 0; i < scans.size(); ++i) {
      EXPECT_EQ(scans[i].reading.sightKnownBy, KnownBy::Evidence);
      expectSeen(scans[i], round.grids[i], forward * Vec3::UnitZ());
      EXPECT_TRUE(scans[i].image.T_table_scanner.isApprox(round.list[i].T_object_scanner));
      EXPECT_EQ(scans[i].reading.turnsAbout, Axis::Y);
    }
  }
}

TEST(ScanReader, TakesASingleScanOfParallelRaysAsUsualAndSaysSo) {
  const SeenGrid grid = seeLump(60, 56, parallelRays(kBackward), Pose::Identity());
  const auto scans = read({plyOf(grid)});
  EXPECT_EQ(scans[0].reading.sightKnownBy, KnownBy::Default);
  expectSeen(scans[0], grid, -Vec3::UnitZ());
  ScanReadingOptions options;
  options.frame = parseFrame("camera");
  const SeenGrid other = seeLump(60, 56, parallelRays(kForward), Pose::Identity());
  const auto forward = read({plyOf(other)}, options);
  EXPECT_EQ(forward[0].reading.sightKnownBy, KnownBy::Operator);
  expectSeen(forward[0], other, Vec3::UnitZ());
}

// The grid in the object's coordinates.
SeenGrid placed(SeenGrid grid, const Pose& T_object_scanner) {
  for (auto& cell : grid.cells)
    if (cell) cell = T_object_scanner * *cell;
  return grid;
}

TEST(ScanReader, AsksForTheSideWhereAScanOfTheWorldDoesNotTellIt) {
  const Pose pose = poseAround(70.0, kBackward, 0.0);
  const SeenGrid grid = placed(seeLump(60, 56, parallelRays(kBackward), pose), pose);
  expectError<InvalidInput>([&] { read({plyOf(grid)}); }, {"s0.ply", "along x", "--frame x+", "--frame x-"});
  ScanReadingOptions options;
  options.frame = parseFrame("x-");
  expectSeen(read({plyOf(grid)}, options)[0], grid, pose.linear() * -Vec3::UnitZ());
}

TEST(ScanReader, FindsThatScansAreInTheCoordinatesOfTheObjectAlready) {
  for (const bool pinhole : {false, true}) {
    Round round = roundOf(kForward, pinhole);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < round.grids.size(); ++i) {
      round.grids[i] = placed(round.grids[i], round.list[i].T_object_scanner);
      texts.push_back(plyOf(round.grids[i]));
    }
    for (const auto* list : {static_cast<const std::vector<ScanPose>*>(nullptr), &std::as_const(round.list)}) {
      const auto scans = read(texts, {}, list);
      for (std::size_t i = 0; i < scans.size(); ++i) {
        EXPECT_TRUE(scans[i].reading.placed);
        EXPECT_TRUE(scans[i].image.T_table_scanner.isApprox(Pose::Identity()));
        expectSeen(scans[i], round.grids[i], round.list[i].T_object_scanner.linear() * Vec3::UnitZ());
      }
    }
  }
}

TEST(ScanReader, TellsMillimetresOfASmallThingFromMetres) {
  const SeenGrid grid = seeLump(60, 56, parallelRays(kBackward), Pose::Identity());
  EXPECT_EQ(read({plyOf(grid, {0.2})})[0].reading.unit, 1.0);
  EXPECT_EQ(read({plyOf(grid, {0.001})})[0].reading.unit, 1000.0);
  EXPECT_EQ(read({plyOf(grid, {0.025})})[0].reading.unit, 1000.0);
}

TEST(ScanReader, AsksForAUnitThatTheNumbersDoNotTell) {
  const SeenGrid grid = seeLump(60, 56, parallelRays(kBackward), Pose::Identity());
  expectError<InvalidInput>([&] { read({plyOf(grid, {0.05})}); }, {"s0.ply", "unit cannot be told", "--unit"});
  ScanReadingOptions options;
  options.unit = 25.4;
  const auto scans = read({plyOf(grid, {1.0 / 25.4})}, options);
  EXPECT_EQ(scans[0].reading.unitKnownBy, KnownBy::Operator);
  expectSeen(scans[0], grid, -Vec3::UnitZ());
  const auto said = read({plyOf(grid, {0.05, Vec3::Zero(), {}, true, false, "obj_info unit_mm 2\n"})});
  EXPECT_EQ(said[0].reading.unit, 2.0);
  EXPECT_EQ(said[0].reading.unitKnownBy, KnownBy::File);
}

TEST(ScanReader, FindsThatTheListOfPosesHasAnotherUnitThanTheFiles) {
  const Round round = roundOf(kForward, true, {0.001}, 1.0);
  const auto scans = read(round.texts, {}, &round.list);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    EXPECT_EQ(scans[i].reading.unit, 1000.0);
    EXPECT_EQ(scans[i].reading.poseUnit, 1.0);
    EXPECT_EQ(scans[i].reading.poseUnitKnownBy, KnownBy::Evidence);
    EXPECT_TRUE(scans[i].image.T_table_scanner.isApprox(round.list[i].T_object_scanner, 1e-9));
  }
  const Round same = roundOf(kForward, true, {0.001}, 0.001);
  EXPECT_EQ(read(same.texts, {}, &same.list)[0].reading.poseUnit, 1000.0);
}

TEST(ScanReader, TakesOffAnOffsetFarFromTheOriginOnceForAllScans) {
  const Vec3 far(403000.125, 3604900.25, 1000.5);
  const SeenGrid grid = seeLump(60, 56, parallelRays(kBackward), Pose::Identity());
  SeenGrid beside = grid;
  for (auto& cell : beside.cells)
    if (cell) *cell += Vec3(30, 0, 0);
  const PlyStyle style{0.01, far};
  const auto scans = read({plyOf(grid, style), plyOf(beside, style)});
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans[0].reading.unit, 1000.0);
  EXPECT_EQ(scans[0].reading.offset, scans[1].reading.offset);
  for (std::size_t s = 0; s < 2; ++s) {
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
      if (!grid.cells[i]) continue;
      const Vec3 seen = s == 0 ? *grid.cells[i] : *beside.cells[i];
      const Vec3 world = 1000.0 * (0.01 * seen + far);
      const Vec3 found = scans[s].image.T_table_scanner * scans[s].image.point(i) + scans[s].reading.offset;
      EXPECT_NEAR((found - world).norm(), 0.0, 2e-3);
      EXPECT_LT((scans[s].image.T_table_scanner * scans[s].image.point(i)).norm(), 2000.0);
    }
  }
}

TEST(ScanReader, FindsRowsAndColumnsExchanged) {
  SeenGrid grid = seenBy(kForward, 20.0);
  const auto scans = read({plyOf(grid, {1.0, Vec3::Zero(), {}, true, true})});
  EXPECT_TRUE(scans[0].reading.exchanged);
  EXPECT_EQ(scans[0].image.rays->rows(), 60);
  expectSeen(scans[0], grid, Vec3::UnitZ());
  EXPECT_FALSE(read({plyOf(grid)})[0].reading.exchanged);
}

TEST(ScanReader, ReadsAVertexPerCellWithoutARangeGrid) {
  const SeenGrid grid = seenBy(kBackward, 20.0);
  const auto scans = read({plyOf(grid, {0.001, Vec3::Zero(), Vec3::Zero(), false})});
  EXPECT_EQ(scans[0].reading.noSample, NoSampleMark::Zero);
  EXPECT_EQ(scans[0].reading.dropped,
            static_cast<std::size_t>(std::count(grid.cells.begin(), grid.cells.end(), std::nullopt)));
  expectSeen(scans[0], grid, -Vec3::UnitZ());
  std::string text = plyOf(grid, {0.001, Vec3::Zero(), Vec3::Zero(), false});
  text.replace(text.find("num_rows 60"), 11, "num_rows 61");
  expectError<InvalidInput>([&] { read({text}); }, {"num_rows x num_cols", "one vertex per cell"});
}

// A turntable before a line scanner: column = angle of the table, row = height.
SeenGrid seenAround(int columns) {
  SeenGrid grid{50, columns, {}};
  for (int r = 0; r < grid.rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const double angle = 2.0 * kPi * c / columns;
      const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
      const Vec3 origin = 100.0 * out + Vec3(0, 0, r - 25.0);
      const auto t = testing::distanceToLump({origin, -out});
      const bool beyond = t && *t >= 100.0;  // the far side, through a gap
      grid.cells.push_back(t && !beyond ? std::optional(Vec3(origin - *t * out)) : std::nullopt);
    }
  }
  return grid;
}

TEST(ScanReader, ReadsAGridAroundAnAxisAsViewsFromAllSides) {
  const SeenGrid grid = seenAround(120);
  const auto scans = read({plyOf(grid)});
  ASSERT_EQ(scans.size(), 4U);
  std::size_t samples = 0;
  for (const ReadScan& scan : scans) {
    EXPECT_EQ(scan.file, 0U);
    EXPECT_EQ(scan.reading.sightKind, SightKind::Turntable);
    EXPECT_EQ(scan.reading.sightKnownBy, KnownBy::Evidence);
    validate(scan.image);
    for (std::size_t i = 0; i < scan.image.range.size(); ++i) {
      const RangingRay& ray = scan.image.rays->ray(i);
      EXPECT_LT(ray.origin.head<2>().dot(ray.direction.head<2>()), 0.0);
      if (!scan.image.valid(i)) continue;
      ++samples;
      double nearest = 1e9;
      for (const auto& cell : grid.cells)
        if (cell) nearest = std::min(nearest, (*cell - scan.image.point(i)).norm());
      ASSERT_LT(nearest, 1e-3);
    }
  }
  const auto seen =
      grid.cells.size() - static_cast<std::size_t>(std::count(grid.cells.begin(), grid.cells.end(), std::nullopt));
  EXPECT_GT(samples, seen);
}

TEST(ScanReader, TurnsTheWorldUpright) {
  const Round round = roundOf(kForward, true);
  ScanReadingOptions options;
  options.up = Axis::Y;
  const auto scans = read(round.texts, options, &round.list);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const Vec3 top = scans[i].image.T_table_scanner * (round.list[i].T_object_scanner.inverse() * Vec3(0, 10, 0));
    EXPECT_NEAR((top - Vec3(0, 0, 10)).norm(), 0.0, 1e-9);
  }
}

TEST(ScanReader, FindsTheUnitThatPutsSamplesOnTheRaysOfAProfile) {
  ScannerProfile profile;
  profile.rays = std::make_shared<const RayGrid>(makeRays(Pinhole{{300, 0, 0}, {0, 0, 0}, 40, 44, 0.2, 0.2}, {}));
  profile.workspace.poses = {Pose::Identity(), poseAround(30.0, kForward, 10.0)};
  SeenGrid grid{40, 44, {}};
  for (std::size_t i = 0; i < profile.rays->size(); ++i) {
    const auto t = testing::distanceToLump(profile.rays->ray(i));
    grid.cells.push_back(t ? std::optional(Vec3(profile.rays->ray(i).origin + *t * profile.rays->ray(i).direction))
                           : std::nullopt);
  }
  for (const double unit : {1.0, 0.001, 1.0 / 25.4}) {
    const auto scans = read({plyOf(grid, {unit})}, {}, nullptr, &profile);
    EXPECT_NEAR(scans[0].reading.unit * unit, 1.0, 1e-12);
    EXPECT_EQ(scans[0].image.rays, profile.rays);
  }
  expectError<InvalidInput>([&] { read({plyOf(grid, {0.5})}, {}, nullptr, &profile); },
                            {"s0.ply", "beside its ranging ray"});
  const TemporaryFolder folder;
  const ReadScan at = readScanAt(folder.write("a.ply", plyOf(grid)), profile, 1, {});
  EXPECT_EQ(at.image.station.position, 1);
  EXPECT_EQ(at.image.poseKnownBy, PoseSource::Commanded);
  EXPECT_TRUE(at.image.T_table_scanner.isApprox(profile.workspace.poses[1]));
}

TEST(ScanReader, FindsTheFrameThatPutsSamplesOnTheRaysOfAProfile) {
  ScannerProfile profile;
  profile.rays = std::make_shared<const RayGrid>(makeRays(Pinhole{{300, 0, 0}, {0, 0, 0}, 40, 44, 0.2, 0.2}, {}));
  profile.workspace.poses = {Pose::Identity(), poseAround(30.0, kForward, 10.0)};
  const Pose& T_table_scanner = profile.workspace.poses[1];
  const Pose T_scanner_camera =
      Eigen::Translation3d(300, 0, 0) * Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), -Vec3::UnitX());
  SeenGrid onRays{40, 44, {}};
  for (std::size_t i = 0; i < profile.rays->size(); ++i) {
    const auto t = testing::distanceToLump(profile.rays->ray(i));
    onRays.cells.push_back(t ? std::optional(Vec3(profile.rays->ray(i).origin + *t * profile.rays->ray(i).direction))
                             : std::nullopt);
  }
  const TemporaryFolder folder;
  for (const Pose& T_file_scanner : {Pose::Identity(), Pose(T_scanner_camera.inverse()), T_table_scanner}) {
    const std::string file = folder.write("a.ply", plyOf(placed(onRays, T_file_scanner), {0.001}));
    const ReadScan scan = readScanAt(file, profile, 1, {});
    EXPECT_EQ(scan.reading.unit, 1000.0);
    EXPECT_TRUE(scan.image.T_table_scanner.isApprox(T_table_scanner));
    for (std::size_t i = 0; i < onRays.cells.size(); ++i)
      if (onRays.cells[i]) {
        EXPECT_NEAR((scan.image.point(i) - *onRays.cells[i]).norm(), 0.0, 1e-3);
      }
  }
}

TEST(ScanReader, KnowsItsFrames) {
  EXPECT_EQ(parseFrame("auto"), std::nullopt);
  EXPECT_EQ(parseFrame("gl"), parseFrame("z-"));
  expectError<InvalidInput>([] { static_cast<void>(parseFrame("left")); }, {"'left'", "camera", "world"});
}

}  // namespace
}  // namespace vantage
