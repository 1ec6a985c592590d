#include "io/depth_png.h"

#include "core/io/expect_error.h"
#include "support/test_data.h"
#include "support/written_scans.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;

const std::vector<std::uint16_t> kDepth{1000, 2000, 0, 500};
const std::string kIntrinsics = R"("fx": 2.0, "fy": 4.0, "cx": 0.5, "cy": 0.0)";

void expectDepth(const std::string& json) {
  const TemporaryFolder folder;
  static_cast<void>(folder.write("a.json", json));
  const GridFile file = readDepthPng(folder.write("a.png", testing::pngOf(kDepth, 2, 2)));
  EXPECT_EQ(file.unit, 1.0);
  EXPECT_TRUE(file.ofCamera);
  ASSERT_EQ(file.samples.rows, 2);
  EXPECT_EQ(file.samples.cell[2], kNoIndex);
  EXPECT_TRUE(file.samples.points[1].isApprox(Vec3(50, 0, 200))) << json;
  EXPECT_TRUE(file.samples.points[3].isApprox(Vec3(12.5, 12.5, 50))) << json;
}

TEST(DepthPng, ReadsDepthAndTheUsualWaysToWriteIntrinsics) {
  expectDepth("{" + kIntrinsics + R"(, "depth_scale": 10000, "width": 2, "height": 2, "maker": "any"})");
  expectDepth(R"({"intrinsics": {)" + kIntrinsics + R"(}, "depth_scale": 0.0001})");
  expectDepth(R"({"fx": 2, "fy": 4, "ppx": 0.5, "ppy": 0, "depth_scale": 10000})");
  expectDepth(R"({"K": [[2, 0, 0.5], [0, 4, 0], [0, 0, 1]], "depth_scale": 10000})");
  expectDepth(R"({"intrinsic_matrix": [2, 0, 0, 0, 4, 0, 0.5, 0, 1], "depth_scale": 10000})");
}

TEST(DepthPng, SaysWhatIsMissingOrWrong) {
  const TemporaryFolder folder;
  const std::string png = testing::pngOf(kDepth, 2, 2);
  const std::string file = folder.write("a.png", png);
  const auto refused = [&](const std::string& json, const std::vector<std::string>& parts) {
    static_cast<void>(folder.write("a.json", json));
    expectError<InvalidInput>([&] { static_cast<void>(readDepthPng(file)); }, parts);
  };
  EXPECT_EQ(intrinsicsBeside(file), "");
  expectError<InvalidInput>([&] { static_cast<void>(readDepthPng(file)); }, {"a.png", "a.json", "fx, fy"});
  refused("{" + kIntrinsics + "}", {"a.json", "depth_scale"});
  refused(R"({"fx": 0, "fy": 4, "cx": 0, "cy": 0, "depth_scale": 1000})", {"a.json", "fx and fy"});
  refused("{" + kIntrinsics + R"(, "depth_scale": 0})", {"depth_scale", "above 0"});
  refused("{" + kIntrinsics + R"(, "depth_scale": 1000, "width": 640})", {"'width' 640", "2"});
  refused("[1]", {"a.json", "object"});
  static_cast<void>(folder.write("a.png", png.substr(0, png.size() - 20)));
  refused("{}", {"a.png", "cannot be read"});
}

}  // namespace
}  // namespace vantage
