#include "scanner/profile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

using nlohmann::json;

json rotatingStripe() {
  return json::parse(R"({
    "name": "Test", "scanner": { "type": "rotating_stripe", "position": [300, 0, 150], "stripe_height_mm": 300,
      "samples_per_stripe": 25, "stripes": 24, "sweep_deg": 60, "receivers": [[60, 0, 0]], "breakdown_angle_deg": 55,
      "range_mm": [100, 500], "noise": { "range_sigma_mm": 0.1, "dropout": 0.25 } },
    "workspace": { "type": "turntable", "steps": 90 }, "viewing_volume": { "radius_mm": 140, "height_mm": 280 },
    "positional_space": { "surface": "cylinder", "rows": 21, "columns": 91 },
    "mechanics": { "angle_sigma_deg": 0.3, "position_sigma_mm": 0.4 } })");
}

json linearStripe() {
  json document = rotatingStripe();
  document["scanner"].erase("sweep_deg");
  document["scanner"].update({{"type", "linear_stripe"}, {"travel_mm", 200}});
  return document;
}

json pinhole() {
  json document = rotatingStripe();
  document["scanner"] =
      json::parse(R"({ "type": "pinhole", "position": [400, 0, 150], "look_at": [0, 0, 150], "rows": 30,
    "columns": 40, "horizontal_fov_deg": 50, "vertical_fov_deg": 40, "breakdown_angle_deg": 70, "range_mm": [100, 900] })");
  document["workspace"] = {
      {"type", "turntable_tilt"}, {"steps", 6}, {"tilts_deg", {0, 30}}, {"tilt_center", {0, 0, 100}}};
  return document;
}

json rayTable() {
  json document = rotatingStripe();
  document["scanner"] = json::parse(R"({ "type": "rays", "file": "rays.csv", "rows": 2, "columns": 2,
    "breakdown_angle_deg": 70, "range_mm": [100, 900] })");
  return document;
}

const std::string kTable = "0,0,0, 1,0,0, 5,6,7\n0,1,0, 2,0,0, 5,6,7\n0,0,1, 1,0,0, 5,6,7\n0,1,1, 1,0,0, 8,9,10\n";

json withPoses(const json& matrices) {
  json document = rotatingStripe();
  document["workspace"] = {{"type", "poses"}, {"matrices", matrices}};
  return document;
}

ScannerProfile parse(const json& document, const std::map<std::string, std::string>& attachments = {}) {
  return parseProfile({"test.json", document.dump(), attachments});
}

std::string messageFor(const json& document, const std::map<std::string, std::string>& attachments = {}) {
  try {
    static_cast<void>(parse(document, attachments));
  } catch (const Error& e) {
    return e.what();
  }
  return "accepted";
}

std::string messageWith(const json& base, const std::string& pointer, const json& value) {
  json document = base;
  document[json::json_pointer(pointer)] = value;
  return messageFor(document);
}

TEST(Profile, RotatingStripeArrivesInMillimetresAndRadians) {
  const ScannerProfile p = parse(rotatingStripe());
  EXPECT_EQ(p.name, "Test");
  EXPECT_EQ(p.type, "rotating_stripe");
  EXPECT_EQ(p.rays->rows(), 25);
  EXPECT_EQ(p.rays->columns(), 24);
  EXPECT_TRUE(p.rays->triangulates());
  EXPECT_DOUBLE_EQ(p.breakdownAngle, radians(55));
  EXPECT_EQ(p.minRange, 100.0);
  EXPECT_EQ(p.maxRange, 500.0);
  EXPECT_EQ(p.noise.rangeSigma, 0.1);
  EXPECT_EQ(p.noise.dropout, 0.25);
  EXPECT_EQ(p.workspace.size(), 90U);
  EXPECT_EQ(p.viewingVolume.radius, 140.0);
  EXPECT_EQ(p.viewingVolume.height, 280.0);
  EXPECT_EQ(p.positionalSpace.surface, PositionalSpaceSurface::Cylinder);
  EXPECT_EQ(p.positionalSpace.rows, 21);
  EXPECT_EQ(p.positionalSpace.columns, 91);
  EXPECT_DOUBLE_EQ(p.mechanics.angleSigma, radians(0.3));
  EXPECT_EQ(p.mechanics.positionSigma, 0.4);
}

TEST(Profile, OptionalPartsHaveTheirDefaults) {
  json document = rotatingStripe();
  for (const char* part : {"viewing_volume", "positional_space", "mechanics"}) document.erase(part);
  document["scanner"].erase("noise");
  document["scanner"].erase("receivers");
  const ScannerProfile p = parse(document);
  EXPECT_EQ(p.viewingVolume.radius, 150.0);
  EXPECT_EQ(p.positionalSpace.columns, 90);
  EXPECT_EQ(p.noise.rangeSigma, 0.0);
  EXPECT_EQ(p.mechanics.angleSigma, 0.0);
  EXPECT_FALSE(p.rays->triangulates());
}

TEST(Profile, EveryTypeIsRead) {
  EXPECT_EQ(parse(linearStripe()).rays->ray(0).direction, Vec3(-1, 0, 0));
  EXPECT_EQ(parse(pinhole()).rays->rows(), 30);
  EXPECT_EQ(parse(pinhole()).workspace.size(), 12U);
  const ScannerProfile table = parse(rayTable(), {{"rays.csv", kTable}});
  EXPECT_EQ(table.rays->ray(1).origin, Vec3(0, 1, 0));
  EXPECT_EQ(table.rays->ray(1).direction, Vec3(1, 0, 0));
  EXPECT_EQ(table.rays->receivers(3)[0], Vec3(8, 9, 10));
}

// A matrix of distinct entries shows any mix-up of rows, columns and order.
TEST(Profile, MatricesMayBeNestedOrFlat) {
  Pose expected = Pose::Identity();
  expected.translate(Vec3(11, 12, 13));
  expected.rotate(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  json nested = json::array();
  json flat = json::array();
  for (int r = 0; r < 4; ++r) {
    json row = json::array();
    for (int c = 0; c < 4; ++c) {
      row.push_back(expected.matrix()(r, c));
      flat.push_back(expected.matrix()(r, c));
    }
    nested.push_back(row);
  }
  const ScannerProfile p = parse(withPoses({nested, flat, json(nested.begin(), nested.begin() + 3)}));
  ASSERT_EQ(p.workspace.size(), 3U);
  EXPECT_EQ(p.workspace.steps, 0);
  for (const Pose& pose : p.workspace.poses) EXPECT_TRUE(pose.isApprox(expected, 1e-9));
}

TEST(Profile, PosesMayStandInAFile) {
  json document = rotatingStripe();
  document["workspace"] = {{"type", "poses"}, {"file", "poses.csv"}};
  const ScannerProfile p = parse(document, {{"poses.csv", "1,0,0,5,0,1,0,6,0,0,1,7\n0,-1,0,0,1,0,0,0,0,0,1,0\n"}});
  ASSERT_EQ(p.workspace.size(), 2U);
  EXPECT_TRUE(p.workspace.poses[0].translation().isApprox(Vec3(5, 6, 7)));
  EXPECT_TRUE((p.workspace.poses[1] * Vec3(1, 0, 0)).isApprox(Vec3(0, 1, 0)));
}

TEST(Profile, AMissingFieldIsNamedWithWhatWasExpected) {
  const std::vector<std::pair<json, std::vector<std::string>>> required{
      {rotatingStripe(),
       {"/name", "/scanner", "/scanner/type", "/scanner/position", "/scanner/stripe_height_mm",
        "/scanner/samples_per_stripe", "/scanner/stripes", "/scanner/sweep_deg", "/scanner/breakdown_angle_deg",
        "/scanner/range_mm", "/workspace", "/workspace/type", "/workspace/steps", "/viewing_volume/radius_mm",
        "/viewing_volume/height_mm", "/positional_space/surface", "/positional_space/rows",
        "/positional_space/columns"}},
      {linearStripe(), {"/scanner/travel_mm"}},
      {pinhole(),
       {"/scanner/look_at", "/scanner/rows", "/scanner/columns", "/scanner/horizontal_fov_deg",
        "/scanner/vertical_fov_deg", "/workspace/tilts_deg"}},
      {rayTable(), {"/scanner/file", "/scanner/rows", "/scanner/columns"}},
      {withPoses(json::array()), {"/workspace/matrices"}}};
  for (const auto& [document, pointers] : required) {
    for (const std::string& pointer : pointers) {
      json broken = document;
      const json::json_pointer p(pointer);
      broken[p.parent_pointer()].erase(p.back());
      const std::string message = messageFor(broken, {{"rays.csv", kTable}});
      EXPECT_EQ(message.find("test.json: " + pointer + " is missing, expected "), 0U) << message;
    }
  }
}

TEST(Profile, AFieldNobodyKnowsIsNamedWithItsValueAndTheKnownOnes) {
  for (const std::string parent :
       {"", "/scanner", "/scanner/noise", "/workspace", "/viewing_volume", "/positional_space", "/mechanics"}) {
    const std::string message = messageWith(rotatingStripe(), parent + "/colour", "red");
    EXPECT_EQ(message.find("test.json: " + parent + "/colour is \"red\" but not a known field, expected one of "), 0U)
        << message;
  }
  // Fields of another type are unknown to this one, and a misspelt optional field is answered with the right one.
  EXPECT_NE(messageWith(rotatingStripe(), "/scanner/travel_mm", 5).find("not a known field"), std::string::npos);
  json misspelt = rotatingStripe();
  misspelt["scanner"].erase("receivers");
  misspelt["scanner"]["reciever"] = json::array();
  EXPECT_NE(messageFor(misspelt).find("receivers"), std::string::npos);
}

TEST(Profile, AnImpossibleValueIsShownWithWhatWasExpected) {
  const struct {
    json base;
    std::string pointer;
    json value;
    std::string expected;
  } cases[] = {
      {rotatingStripe(), "/name", "", "\"\", expected a text that is not empty"},
      {rotatingStripe(), "/name", 5, "5, expected a text that is not empty"},
      {rotatingStripe(), "/scanner", 7, "7, expected an object"},
      {rotatingStripe(), "/scanner/type", "laser",
       "\"laser\", expected one of rotating_stripe, linear_stripe, pinhole, rays"},
      {rotatingStripe(), "/scanner/position", {1, 2}, "[1,2], expected a list of 3 numbers"},
      {rotatingStripe(), "/scanner/position", {1, 2, 1e6}, "[1,2,1000000.0], expected coordinates within 100000 mm"},
      {rotatingStripe(), "/scanner/stripe_height_mm", 0, "0, expected a number between 0 and 100000"},
      {rotatingStripe(), "/scanner/samples_per_stripe", 1, "1, expected a whole number from 2 to 100000"},
      {rotatingStripe(), "/scanner/stripes", 2.5, "2.5, expected a whole number from 2 to 100000"},
      {rotatingStripe(), "/scanner/sweep_deg", 170, "170, expected a number between 0 and 170"},
      {rotatingStripe(), "/scanner/sweep_deg", "wide", "\"wide\", expected a number between 0 and 170"},
      {rotatingStripe(), "/scanner/receivers", {{1, 2}}, "[[1,2]], expected a list of at most 16 triples"},
      {rotatingStripe(),
       "/scanner/receivers",
       {{1, 2, 1e9}},
       "[[1,2,1000000000.0]], expected a list of at most 16 triples"},
      {rotatingStripe(), "/scanner/breakdown_angle_deg", 90, "90, expected a number between 0 and 90"},
      {rotatingStripe(), "/scanner/range_mm", {500, 100}, "[500,100], expected [nearest, farthest]"},
      {rotatingStripe(), "/scanner/range_mm", {-1, 100}, "[-1,100], expected [nearest, farthest]"},
      {rotatingStripe(), "/scanner/noise/range_sigma_mm", -0.1, "-0.1, expected a number from 0 to 1000"},
      {rotatingStripe(), "/scanner/noise/dropout", 1.5, "1.5, expected a number from 0 to 1"},
      {linearStripe(), "/scanner/travel_mm", -3, "-3, expected a number between 0 and 100000"},
      {pinhole(), "/scanner/look_at", {400, 0, 150}, "[400,0,150], expected a point other than position"},
      {pinhole(), "/scanner/look_at", {400, 0, 0}, "[400,0,0], expected a point that is not straight above or below"},
      {pinhole(), "/scanner/horizontal_fov_deg", 180, "180, expected a number between 0 and 170"},
      {pinhole(), "/workspace/tilts_deg", {0, 91}, "[0,91], expected angles from -90 to 90"},
      {pinhole(), "/workspace/tilts_deg", json::array(), "[], expected a list of 1 to 180 numbers"},
      {rotatingStripe(), "/workspace/type", "arm", "\"arm\", expected one of turntable, turntable_tilt, poses"},
      {rotatingStripe(), "/workspace/steps", 0, "0, expected a whole number from 1 to 36000"},
      {rotatingStripe(), "/viewing_volume/radius_mm", 0, "0, expected a number between 0 and 100000"},
      {rotatingStripe(), "/positional_space/surface", "torus", "\"torus\", expected cylinder or sphere"},
      {rotatingStripe(), "/positional_space/rows", 0, "0, expected a whole number from 1 to 1000"},
      {rotatingStripe(), "/mechanics/angle_sigma_deg", nullptr, "null, expected a number from 0 to 90"},
  };
  for (const auto& c : cases) {
    const std::string message = messageWith(c.base, c.pointer, c.value);
    EXPECT_EQ(message.find("test.json: " + c.pointer + " is " + c.expected), 0U) << message;
  }
}

TEST(Profile, AGridOfTooManyRaysIsRefusedBeforeItIsBuilt) {
  json document = rotatingStripe();
  document["scanner"]["samples_per_stripe"] = 100000;
  document["scanner"]["stripes"] = 100000;
  EXPECT_EQ(messageFor(document), "test.json: /scanner/stripes is 100000, expected a grid of at most 16000000 rays");
}

TEST(Profile, TablesOfRaysAreChecked) {
  auto tableMessage = [](const std::string& table) { return messageFor(rayTable(), {{"rays.csv", table}}); };
  EXPECT_EQ(tableMessage("0,0,0,1,0,0\n"), "rays.csv: has 1 rays, expected rows x columns = 4");
  EXPECT_EQ(tableMessage("1,2,3\n1,2,3\n1,2,3\n1,2,3\n"),
            "rays.csv: has 3 numbers for every ray, expected ox,oy,oz,dx,dy,dz and three for every receiver");
  EXPECT_NE(tableMessage(kTable + "0,0,0, 1,0,0, 5,6,7\n").find("rays.csv: line 5 has row 5"), std::string::npos);
  EXPECT_NE(
      tableMessage("0,0,0,1,0,0\n0,0,0,0,0,0\n0,0,0,1,0,0\n0,0,0,1,0,0\n").find("rays.csv: ray 1 has a direction"),
      std::string::npos);
  EXPECT_NE(
      tableMessage("0,0,0,1,0,0\n0,0,0,1,0,0\n0,0,0,1e200,0,0\n0,0,0,1,0,0\n").find("rays.csv: ray 2 has a direction"),
      std::string::npos);
  EXPECT_NE(
      tableMessage("0,0,0,1,0,0\n0,9e9,0,1,0,0\n0,0,0,1,0,0\n0,0,0,1,0,0\n").find("rays.csv: ray 1 has the coordinate"),
      std::string::npos);
  EXPECT_EQ(messageFor(rayTable()), "test.json: names the file rays.csv, which was not read");
}

TEST(Profile, MatricesThatAreNoRigidMotionAreRefused) {
  const json identity = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  EXPECT_EQ(messageFor(withPoses(json::array({identity}))), "accepted");
  json scaled = identity;
  scaled[0][0] = 2;
  EXPECT_NE(messageFor(withPoses({identity, scaled})).find("/workspace/matrices/1 is not a rigid motion"),
            std::string::npos);
  json mirrored = identity;
  mirrored[2][2] = -1;
  EXPECT_NE(messageFor(withPoses(json::array({mirrored}))).find("not a rigid motion"), std::string::npos);
  json projective = identity;
  projective[3][0] = 0.5;
  EXPECT_NE(messageFor(withPoses(json::array({projective}))).find("not a rigid motion"), std::string::npos);
  json far = identity;
  far[0][3] = 1e7;
  EXPECT_NE(messageFor(withPoses(json::array({far}))).find("stands farther out than 100000 mm"), std::string::npos);
  EXPECT_NE(messageFor(withPoses(json::array({json::array({1, 2, 3})}))).find("has 3 numbers, expected the 12 or 16"),
            std::string::npos);
  EXPECT_NE(messageFor(withPoses({{{1, 2, 3}}})).find("expected 4 x 4 matrices"), std::string::npos);
  EXPECT_NE(messageFor(withPoses({{{1, 2, 3, "x"}}})).find("expected 4 x 4 matrices"), std::string::npos);
  EXPECT_NE(messageFor(withPoses("none")).find("expected a list of at most"), std::string::npos);
  EXPECT_NE(messageFor(withPoses(json::array())).find("/workspace has no pose"), std::string::npos);
}

TEST(Profile, TextThatIsNoJsonSaysWhere) {
  try {
    static_cast<void>(parseProfile({"test.json", "{ \"name\": \n oops }", {}}));
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_EQ(std::string(e.what()).find("test.json: is not a JSON document: parse error at line 2"), 0U) << e.what();
  }
  EXPECT_THROW(static_cast<void>(parseProfile({"test.json", "[1, 2]", {}})), InvalidInput);
  EXPECT_THROW(static_cast<void>(parseProfile({"test.json", "", {}})), InvalidInput);
  EXPECT_THROW(static_cast<void>(parseProfile({"test.json", "{\"name\": 1e999}", {}})), InvalidInput);
}

TEST(Profile, ANameGivenTwiceIsRefused) {
  std::string text = rotatingStripe().dump();
  const auto begin = text.find('{');
  text.insert(begin + 1, "\"name\": \"other\", ");
  try {
    static_cast<void>(parseProfile({"test.json", text, {}}));
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_EQ(std::string(e.what()), "test.json: has \"name\" twice in one object, expected every name once");
  }
}

TEST(Profile, ItsNameIsPlainText) {
  json document = rotatingStripe();
  document["name"] = "A\x1b[31mB\nscans: 9";
  EXPECT_EQ(parseProfile({"test.json", document.dump(), {}}).name, "A\uFFFD[31mB\uFFFDscans: 9");
}

TEST(Profile, EndlessNestingIsRefused) {
  const std::string deep = "{\"name\": " + std::string(1'000'000, '[') + std::string(1'000'000, ']') + "}";
  try {
    static_cast<void>(parseProfile({"test.json", deep, {}}));
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("nested deeper"), std::string::npos) << e.what();
  }
}

TEST(Profile, MessagesStayShortAndPrintable) {
  json document = rotatingStripe();
  document["scanner"]["type"] = std::string(100000, 'x');
  EXPECT_LT(messageFor(document).size(), 250U);
  document = rotatingStripe();
  document["scanner"]["\x1b[2J~/" + std::string(5000, 'y')] = 1;
  const std::string message = messageFor(document);
  EXPECT_LT(message.size(), 500U);
  EXPECT_EQ(message.find("test.json: /scanner/\\u001b[2J~0~1yyy"), 0U) << message;
  document = rayTable();
  document["scanner"]["file"] = "a\nb";
  EXPECT_NE(messageFor(document).find("without control characters"), std::string::npos);
}

TEST(Profile, TheShippedProfilesLoad) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(VANTAGE_SCANNERS)) {
    if (entry.path().extension() != ".json") continue;
    ++count;
    ScannerProfile profile;
    ASSERT_NO_THROW(profile = loadProfile(entry.path().string())) << entry.path();
    EXPECT_GE(profile.rays->size(), 10000U) << entry.path();
    EXPECT_GE(profile.workspace.size(), 24U) << entry.path();
    EXPECT_GT(profile.noise.rangeSigma, 0.0) << entry.path();
    // The middle of the viewing volume is in sight and in range from everywhere.
    const Vec3 middle(0, 0, 0.4 * profile.viewingVolume.height);
    for (const Pose& pose : profile.workspace.poses) {
      const Vec3 p = pose.inverse() * middle;
      const auto place = profile.rays->locate(p);
      ASSERT_TRUE(place) << entry.path();
      const double range = (p - profile.rays->rayAt(*place).origin).norm();
      EXPECT_GT(range, profile.minRange) << entry.path();
      EXPECT_LT(range, profile.maxRange) << entry.path();
    }
  }
  EXPECT_EQ(count, 4);
}

TEST(Profile, FilesThatCannotBeReadAreIoErrors) {
  EXPECT_THROW(static_cast<void>(loadProfile("/nowhere/scanner.json")), IoError);
  EXPECT_THROW(static_cast<void>(loadProfile(VANTAGE_SCANNERS)), IoError);
  EXPECT_THROW(static_cast<void>(loadProfile("/dev/zero")), IoError);
}

}  // namespace
}  // namespace vantage
