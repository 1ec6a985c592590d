#include "scanner/calibration_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "scanner/profile_reader.h"
#include "scanner/table_calibration.h"
#include "scanner/table_turn.h"
#include "scanner/turntable_positioner.h"
#include "support/test_data.h"

namespace vantage {
namespace {

const char* const kProfile = R"({
  "name": "Test scanner",
  "scanner": { "type": "rotating_stripe", "position": [300, 0, 150], "stripe_height_mm": 300,
    "samples_per_stripe": 12, "stripes": 9, "sweep_deg": 60, "breakdown_angle_deg": 60, "range_mm": [100, 500] },
  "workspace": { "type": "turntable", "steps": 8 } })";

TableCalibration someCalibration() {
  TableCalibration c;
  c.axisPoint = Vec3(3.0, -2.0, 60.0);
  c.axisDirection = Vec3(0.02, -0.03, 1.0).normalized();
  c.sigma = 0.05;
  c.angleSigma = radians(0.02);
  c.planeNormal = Vec3(0.021, -0.03, 1.0).normalized();
  c.planeOffset = 4.0;
  c.sense = -1;
  c.degreesPerCommandedDegree = 1.1;
  c.residual = 0.1;
  c.verdict = CalibrationVerdict::Doubtful;
  return c;
}

ProfileSource source(const std::string& text = kProfile) {
  return {"profile.json", text, {}};
}

// What is refused, and what the message names.
void expectRefused(const std::function<void(nlohmann::json&)>& spoil, const std::string& named) {
  auto document = nlohmann::json::parse(calibrationText(someCalibration()));
  spoil(document);
  try {
    (void)readCalibration(JsonObjectReader(document, "cal.json", ""));
    ADD_FAILURE() << "accepted: " << document.dump();
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("cal.json: " + named), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("expected"), std::string::npos) << e.what();
  }
}

TEST(CalibrationFile, KeepsEveryValue) {
  const testing::TemporaryFolder folder;
  const TableCalibration c = someCalibration();
  const TableCalibration read = loadCalibration(folder.write("cal.json", calibrationText(c)));
  EXPECT_TRUE(read.axisPoint.isApprox(c.axisPoint, 1e-12));
  EXPECT_TRUE(read.axisDirection.isApprox(c.axisDirection, 1e-12));
  EXPECT_TRUE(read.planeNormal.isApprox(c.planeNormal, 1e-12));
  EXPECT_NEAR(read.planeOffset, c.planeOffset, 1e-12);
  EXPECT_EQ(read.sense, -1);
  EXPECT_EQ(read.degreesPerCommandedDegree, 1.1);
  EXPECT_NEAR(read.angleSigma, c.angleSigma, 1e-12);
  EXPECT_EQ(read.sigma, c.sigma);
  EXPECT_EQ(read.residual, c.residual);
  EXPECT_EQ(read.verdict, CalibrationVerdict::Doubtful);
}

TEST(CalibrationFile, RefusesWhatIsMissingMisspeltOrImpossible) {
  expectRefused([](auto& d) { d.erase("axis"); }, "/axis");
  expectRefused([](auto& d) { d["axis"]["direction"] = {0, 0, 0}; }, "/axis/direction");
  expectRefused([](auto& d) { d["axis"]["point"] = {0, 0}; }, "/axis/point");
  expectRefused([](auto& d) { d["axis"]["sigma_mm"] = -1; }, "/axis/sigma_mm");
  expectRefused([](auto& d) { d["axis"]["tilt"] = 1; }, "/axis/tilt");
  expectRefused([](auto& d) { d["table_plane"] = {0, 0, 0, 1}; }, "/table_plane");
  expectRefused([](auto& d) { d["table_plane"] = {1, 0, 0, 0}; }, "/table_plane");   // parallel to the axis
  expectRefused([](auto& d) { d["table_plane"] = {0, 0, -1, 0}; }, "/table_plane");  // from the other side
  expectRefused([](auto& d) { d["sense"] = 0; }, "/sense");
  expectRefused([](auto& d) { d["degrees_per_commanded_degree"] = 0; }, "/degrees_per_commanded_degree");
  expectRefused([](auto& d) { d["verdict"] = "fine"; }, "/verdict");
  EXPECT_THROW((void)loadCalibration("/nowhere/cal.json"), IoError);
}

TEST(TableCalibration, ItsPoseBringsAxisAndPlaneToTheTable) {
  const TableCalibration c = someCalibration();
  const Pose pose = tablePose(c);
  const Vec3 centre = tableCentre(c);
  EXPECT_NEAR(c.planeNormal.dot(centre) + c.planeOffset, 0.0, 1e-9);
  EXPECT_LT((pose * centre).norm(), 1e-9);
  EXPECT_LT((pose * (centre + 50.0 * c.axisDirection) - Vec3(0, 0, 50)).norm(), 1e-9);
  // The smallest rotation: by the angle between the axis and z.
  EXPECT_NEAR(Eigen::AngleAxisd(pose.linear()).angle(), std::acos(c.axisDirection.z()), 1e-9);
  EXPECT_EQ(name(CalibrationVerdict::Good), "good");
}

TEST(CalibratedProfile, EveryPoseIsOfTheCalibratedScanner) {
  const ScannerProfile plain = parseProfile(source());
  const ScannerProfile calibrated = parseProfile(withCalibration(source(), someCalibration()));
  ASSERT_TRUE(calibrated.calibration);
  EXPECT_FALSE(plain.calibration);
  const Pose C = tablePose(someCalibration());
  for (std::size_t i = 0; i < plain.workspace.size(); ++i)
    EXPECT_TRUE(calibrated.workspace.poses[i].isApprox(plain.workspace.poses[i] * C, 1e-9)) << i;
  for (int to = 0; to < 8; ++to)
    EXPECT_NEAR(turnBetween(calibrated.workspace, 0, to).angle, turnBetween(plain.workspace, 0, to).angle, 1e-9);
  // Position 2 is a turn of the scanner by 90 degrees; the table counts the other way, 1.1 degrees for a degree.
  EXPECT_NEAR(tableAngleOf(plain, 2, -90.0), -90.0, 1e-9);
  EXPECT_NEAR(tableAngleOf(calibrated, 2, 80.0), 90.0 / 1.1, 1e-9);
}

TEST(CalibratedProfile, ACameraThatLooksAlongZTurnsAsOneThatStands) {
  // Rays in the axes of a camera: x right, y down, z forward.
  std::string table;
  for (const double v : {-0.2, 0.2})
    for (const double u : {-0.2, 0.2}) table += "0,0,0," + std::to_string(u) + "," + std::to_string(v) + ",1\n";
  ProfileSource camera = source(R"({ "name": "camera", "scanner": { "type": "rays", "file": "rays.csv", "rows": 2,
      "columns": 2, "breakdown_angle_deg": 60, "range_mm": [100, 900] },
      "workspace": { "type": "turntable_tilt", "steps": 8, "tilts_deg": [0, 20] } })");
  camera.attachments["rays.csv"] = table;
  TableCalibration c;
  c.axisPoint = Vec3(0, 0, 400);
  c.axisDirection = -Vec3::UnitY();
  c.planeNormal = -Vec3::UnitY();
  c.planeOffset = 50.0;
  const ScannerProfile profile = parseProfile(withCalibration(camera, c));
  EXPECT_NEAR(turnBetween(profile.workspace, 0, 2).angle, -radians(90.0), 1e-9);
  EXPECT_NEAR(turnBetween(profile.workspace, 0, 8).tilt, radians(20.0), 1e-9);
  EXPECT_NEAR(scannerPlace(profile, profile.workspace.poses[0]).z(), 50.0, 1e-9);
}

TEST(CalibratedProfile, CanBeCalibratedAgain) {
  TableCalibration second = someCalibration();
  second.sense = 1;
  const ProfileSource twice = withCalibration(withCalibration(source(), someCalibration()), second);
  EXPECT_EQ(parseProfile(twice).calibration->sense, 1);
}

TEST(CalibratedProfile, RefusesATableThatTheScannerDoesNotSeeAndAFailure) {
  TableCalibration far = someCalibration();
  far.axisPoint.x() = 5000.0;
  TableCalibration failed = someCalibration();
  failed.verdict = CalibrationVerdict::Failed;
  for (const auto& [calibration, named] : {std::pair(far, "/calibration/axis"), {failed, "/calibration/verdict"}}) {
    try {
      (void)parseProfile(withCalibration(source(), calibration));
      ADD_FAILURE() << named;
    } catch (const InvalidInput& e) {
      EXPECT_NE(std::string(e.what()).find(std::string("profile.json: ") + named), std::string::npos) << e.what();
    }
  }
  EXPECT_THROW((void)withCalibration(source("[]"), someCalibration()), InvalidInput);
}

}  // namespace
}  // namespace vantage
