// Scans that the laboratory's vendor program takes of an object on its table, with the head elsewhere than its profile
// says: the environment variable VANTAGE_LAB names the folder with that program.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/random.h"
#include "support/test_data.h"
#include "turning_scene.h"

namespace vantage::testing {
namespace {

const char* const kCamera = R"({ "name": "camera over a table",
  "scanner": { "type": "pinhole", "position": [450, 0, 250], "look_at": [0, 0, 60], "rows": 240, "columns": 320,
    "horizontal_fov_deg": 40, "vertical_fov_deg": 30, "receivers": [], "breakdown_angle_deg": 75,
    "range_mm": [100, 2000], "noise": { "range_sigma_mm": 0.15, "dropout": 0.002 } },
  "workspace": { "type": "turntable", "steps": 90 } })";

// The ranges of an ASCII range grid along rays that it was taken with, cell by cell.
RangeImage readRanges(const std::string& path, const std::shared_ptr<const RayGrid>& rays) {
  std::ifstream in(path);
  std::string line;
  std::size_t vertices = 0;
  while (std::getline(in, line) && line != "end_header") {
    std::istringstream words(line);
    std::string element;
    std::string name;
    if (words >> element >> name && element == "element" && name == "vertex") words >> vertices;
  }
  std::vector<Vec3> points(vertices);
  for (Vec3& p : points) in >> p.x() >> p.y() >> p.z();
  RangeImage image;
  image.rays = rays;
  image.range.assign(rays->size(), kNoSample);
  for (std::size_t i = 0; i < rays->size(); ++i) {
    int count = 0;
    std::size_t vertex = 0;
    in >> count;
    if (count == 0) continue;
    in >> vertex;
    image.range[i] = static_cast<float>((points.at(vertex) - rays->ray(i).origin).dot(rays->ray(i).direction));
  }
  if (!in) throw std::runtime_error(path + " is no range grid of these rays");
  return image;
}

struct Laboratory {
  std::string program;
  std::string object;
  Vec3 shift = Vec3::Zero();        // of the head [mm]
  Vec3 turnDegrees = Vec3::Zero();  // and about its position
  double turnsPerCount = 1.0;
  std::uint64_t seed = 1;

  std::vector<CalibrationScan> scans(const std::vector<double>& angles, const ScannerProfile& profile,
                                     const TemporaryFolder& folder) const {
    std::vector<CalibrationScan> result;
    Random random(seed, 5);
    for (std::size_t k = 0; k < angles.size(); ++k) {
      const double angle = turnsPerCount * angles[k] + 0.2 * random.normal();
      std::ostringstream command;
      command << "'" << program << "' --mesh '" << object << "' --profile '" << folder.file("camera.json")
              << "' --out '" << folder.file("scans") << "' --name scan_" << k << ".ply --wall 400 --seed "
              << 100 * seed + k << " --angle " << angle << " --head " << shift.x() << "," << shift.y() << ","
              << shift.z() << "," << turnDegrees.x() << "," << turnDegrees.y() << "," << turnDegrees.z()
              << " > /dev/null";
      const std::string text = command.str();
      if (std::system(text.c_str()) != 0) throw std::runtime_error("failed: " + text);  // NOLINT(cert-env33-c)
      const std::string file =
          (std::filesystem::path(folder.file("scans")) / ("scan_" + std::to_string(k) + ".ply")).string();
      result.push_back({std::make_shared<const RangeImage>(readRanges(file, profile.rays)), angles[k]});
    }
    return result;
  }
};

TEST(Laboratory, TablesAreCalibratedWithinTheTarget) {
  const char* lab = std::getenv("VANTAGE_LAB");
  if (lab == nullptr) GTEST_SKIP() << "no laboratory: set VANTAGE_LAB to the folder with lab_vendor";
  const std::string program = (std::filesystem::path(lab) / "lab_vendor").string();
  if (!std::filesystem::exists(program)) GTEST_SKIP() << program << " is not there";
  const TemporaryFolder folder;
  const ScannerProfile profile = loadProfile(folder.write("camera.json", kCamera));
  const char* often = std::getenv("VANTAGE_LAB_SEEDS");
  const int seeds = often == nullptr ? 2 : std::atoi(often);
  const std::vector<double> angles{0, 20, 45, 75, 110, 150};
  for (const char* object : {"mug.ply", "handset.ply"}) {
    for (int seed = 1; seed <= seeds; ++seed) {
      Laboratory laboratory;
      laboratory.program = program;
      laboratory.object = (sourceFolder() / "resources" / "objects" / object).string();
      laboratory.seed = static_cast<std::uint64_t>(seed);
      Random random(laboratory.seed, 9);
      auto u = [&] { return 2.0 * random.uniform() - 1.0; };
      laboratory.shift = 8.0 * Vec3(u(), u(), u());
      laboratory.turnDegrees = 3.0 * Vec3(u(), u(), u());
      constexpr double kTurns[] = {1.0, -1.0, 0.97, -1.1};
      laboratory.turnsPerCount = kTurns[seed % 4];
      const auto result = calibrateTable(laboratory.scans(angles, profile, folder), profile, {}, Progress({}, {}, 2));
      const Pose truth = offBy(laboratory.shift, laboratory.turnDegrees, Vec3(450, 0, 250));
      const AxisError error = errorOf(result.calibration, truth, 50.0);
      const std::string what = std::string(object) + ", seed " + std::to_string(seed);
      EXPECT_EQ(result.calibration.verdict, CalibrationVerdict::Good) << what;
      for (const auto& finding : result.findings)
        EXPECT_EQ(worthOf(finding), CalibrationVerdict::Good) << what << ": " << describe(finding);
      EXPECT_LT(error.direction, 0.1) << what;
      EXPECT_LT(error.place, 0.2) << what;
      EXPECT_LT(error.plane, 0.2) << what;
      EXPECT_EQ(result.calibration.sense, laboratory.turnsPerCount < 0.0 ? -1 : 1) << what;
      EXPECT_NEAR(result.calibration.degreesPerCommandedDegree, std::abs(laboratory.turnsPerCount), 0.01) << what;
      RecordProperty(what, std::to_string(error.direction) + " deg, " + std::to_string(error.place) + " mm");
    }
  }
}

}  // namespace
}  // namespace vantage::testing
