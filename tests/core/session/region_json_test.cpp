#include "session/region_json.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/errors.h"

namespace vantage {
namespace {

Prism somePrism() {
  Prism prism;
  prism.T_region_eye.translate(Vec3(1.0 / 3.0, 2, 3));
  prism.T_region_eye.rotate(Eigen::AngleAxisd(0.3, Vec3::UnitX()));
  prism.perspective = true;
  prism.corners = {{0, 0}, {1.0 / 7.0, 0}, {0, 0.5}};
  prism.nearest = 10.0;
  prism.farthest = std::numeric_limits<double>::infinity();
  return prism;
}

Region readBack(const Region& region) {
  const nlohmann::json json = nlohmann::json::parse(regionJson(region).dump());
  return regionFrom(JsonFields(json, "step 1"));
}

TEST(RegionJson, EveryKindComesBackToTheLastBit) {
  OrientedBox box;
  box.T_region_box = somePrism().T_region_eye;
  box.size = Vec3(1, 2, 1.0 / 3.0);
  for (const Region& region : {Region(BelowPlane{Vec3(0.1, 0, 0), Vec3(0.6, 0.8, 0)}), Region(box), Region(somePrism()),
                               Region(NearPoints{{Vec3(1, 2, 0.1), Vec3(-1, 0, 5)}, 0.7})})
    EXPECT_TRUE(readBack(region) == region) << kindOf(region);
}

TEST(RegionJson, WhatIsDamagedIsNamed) {
  const auto refused = [](nlohmann::json json) {
    EXPECT_THROW(static_cast<void>(regionFrom(JsonFields(json, "step 1"))), InvalidInput) << json.dump();
  };
  nlohmann::json json = regionJson(somePrism());
  json["kind"] = "sphere";
  refused(json);
  json = regionJson(somePrism());
  json["corners"].push_back(3.0);
  refused(json);
  json["corners"] = {1, 2, 3, 4};
  refused(json);
  json = regionJson(BelowPlane{});
  json.erase("normal");
  refused(json);
  json = regionJson(NearPoints{{Vec3::Zero()}, 1.0});
  json["points"] = {"a", "b", "c"};
  refused(json);
}

}  // namespace
}  // namespace vantage
