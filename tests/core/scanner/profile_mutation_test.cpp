#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "base/errors.h"
#include "base/random.h"
#include "scanner/profile.h"

namespace vantage {
namespace {

const std::string kProfile = R"({
  "name": "Test", "scanner": { "type": "rays", "file": "r", "rows": 2, "columns": 2, "breakdown_angle_deg": 55,
    "range_mm": [100, 500], "noise": { "range_sigma_mm": 0.1, "dropout": 0.25 } },
  "workspace": { "type": "poses", "matrices": [[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]],
    [1,0,0,5,0,1,0,6,0,0,1,7,0,0,0,1]] }, "viewing_volume": { "radius_mm": 140, "height_mm": 280 },
  "positional_space": { "surface": "cylinder", "rows": 21, "columns": 91 },
  "mechanics": { "angle_sigma_deg": 0.3, "position_sigma_mm": 0.4 } })";
const std::string kStripe = R"({ "name": "Test", "scanner": { "type": "rotating_stripe", "position": [300, 0, 150],
    "stripe_height_mm": 300, "samples_per_stripe": 9, "stripes": 8, "sweep_deg": 60, "receivers": [[60, 0, 0]],
    "breakdown_angle_deg": 60, "range_mm": [100, 500] },
  "workspace": { "type": "turntable_tilt", "steps": 9, "tilts_deg": [0, 3] } })";
const std::string kTable = "0,0,0,1,0,0,5,6,7\n0,1,0,2,0,0,5,6,7\n0,0,1,1,0,0,5,6,7\n0,1,1,1,0,0,8,9,10\n";

// Bytes that mean something in JSON and in tables, and some that mean nothing.
const std::string kBytes = std::string("{}[]\",:0123456789-+.eE# \n\t\\/truefalsnu\x80\xff\x01") + '\0';

std::string mutated(std::string text, Random& random) {
  const std::uint64_t changes = 1 + random.below(4);
  for (std::uint64_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = random.below(text.size());
    const std::size_t length = std::min<std::size_t>(1 + random.below(12), text.size() - at);
    switch (random.below(4)) {
      case 0:
        text[at] = kBytes[random.below(kBytes.size())];
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, 1, kBytes[random.below(kBytes.size())]);
        break;
      default:
        text.insert(random.below(text.size()), text.substr(at, length));
        break;
    }
  }
  return text;
}

// A broken profile is refused with a message, or happens to be a profile; nothing else may come out.
void expectMessageOrProfile(const ProfileSource& source, int& accepted) {
  try {
    const ScannerProfile profile = parseProfile(source);
    ++accepted;
    EXPECT_GE(profile.rays->size(), 4U);
    EXPECT_GE(profile.workspace.size(), 1U);
    static_cast<void>(profile.rays->locate(Vec3(0, 0, 150)));
  } catch (const Error& e) {
    const std::string message = e.what();
    EXPECT_FALSE(message.empty());
    EXPECT_LT(message.size(), 1000U);
    const auto control = std::find_if(message.begin(), message.end(), [](char ch) { return ch >= 0 && ch < ' '; });
    EXPECT_EQ(control, message.end()) << message;
  }
}

TEST(ProfileMutation, ProfilesAreRefusedOrRead) {
  Random random(1);
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::string& text = i % 2 == 0 ? kProfile : kStripe;
    expectMessageOrProfile({"p.json", mutated(text, random), {{"r", kTable}}}, accepted);
  }
  EXPECT_GT(accepted, 100);
  EXPECT_LT(accepted, 19000);
}

TEST(ProfileMutation, TablesAreRefusedOrRead) {
  Random random(2);
  int accepted = 0;
  for (int i = 0; i < 20000; ++i)
    expectMessageOrProfile({"p.json", kProfile, {{"r", mutated(kTable, random)}}}, accepted);
  EXPECT_GT(accepted, 100);
  EXPECT_LT(accepted, 19000);
}

}  // namespace
}  // namespace vantage
