#include <array>
#include <filesystem>

#include "base/errors.h"
#include "fuzz/fuzz_target.h"
#include "scanner/profile.h"

// An input is a profile and the two files that it may name, "rays" and "poses", with a zero byte after each.

namespace vantage::testing {
namespace {

constexpr const char* kRayProfile =
    R"({ "name": "T", "scanner": { "type": "rays", "file": "rays", "rows": 2, "columns": 2,
  "breakdown_angle_deg": 55, "range_mm": [100, 500], "noise": { "range_sigma_mm": 0.1, "dropout": 0.25 } },
  "workspace": { "type": "poses", "file": "poses" }, "viewing_volume": { "radius_mm": 140, "height_mm": 280 },
  "positional_space": { "surface": "sphere", "rows": 21, "columns": 91 },
  "mechanics": { "angle_sigma_deg": 0.3, "position_sigma_mm": 0.4 } })";
constexpr const char* kMatrixProfile =
    R"({ "name": "T", "scanner": { "type": "rotating_stripe", "position": [300, 0, 150],
  "stripe_height_mm": 300, "samples_per_stripe": 9, "stripes": 8, "sweep_deg": 60, "receivers": [[60, 0, 0]],
  "breakdown_angle_deg": 60, "range_mm": [100, 500] }, "workspace": { "type": "poses",
  "matrices": [[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]] } })";
constexpr const char* kTiltProfile = R"({ "name": "T", "scanner": { "type": "depth_camera", "position": [300, 0, 150],
  "target": [0, 0, 60], "rows": 5, "columns": 6, "fov_deg": [40, 30], "breakdown_angle_deg": 60, "range_mm": [100, 500] },
  "workspace": { "type": "turntable_tilt", "steps": 9, "tilts_deg": [0, 3] } })";
constexpr const char* kRays =
    "row,column,x,y,z\n0,0,0,1,0,0,5,6,7\n0,1,0,2,0,0,5,6,7\n0,0,1,1,0,0,5,6,7\n0,1,1,1,0,0,8,9,10\n";
constexpr const char* kPoses = "1,0,0,0,0,1,0,0,0,0,1,0\n1 0 0 5 0 1 0 6 0 0 1 7\n";

}  // namespace

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds;
  for (const char* profile : {kRayProfile, kMatrixProfile, kTiltProfile})
    seeds.push_back(std::string(profile) + '\0' + kRays + '\0' + kPoses);
  for (const char* name : {"rotating_stripe", "linear_stripe", "depth_camera"})
    seeds.push_back(readProfileSource(std::string(VANTAGE_SOURCE_DIR "/resources/scanners/") + name + ".json").text);
  return seeds;
}

}  // namespace vantage::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string rest(reinterpret_cast<const char*>(data), size);
  std::array<std::string, 3> parts;
  for (std::string& part : parts) {
    part = rest.substr(0, rest.find('\0'));
    rest.erase(0, std::min(rest.size(), part.size() + 1));
  }
  try {
    const vantage::ScannerProfile profile =
        vantage::parseProfile({"p.json", parts[0], {{"rays", parts[1]}, {"poses", parts[2]}}});
    static_cast<void>(profile.rays->locate(vantage::Vec3(0, 0, 150)));
  } catch (const vantage::Error&) {
    return 0;
  }
  return 0;
}
