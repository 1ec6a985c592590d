#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "app/child_program.h"
#include "integration/vertex_colours.h"
#include "io/file_bytes.h"
#include "io/mesh_colours.h"
#include "io/model_reader.h"
#include "io/range_files.h"
#include "support/coloured_scan.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

class ColouredScans : public ::testing::Test {
 protected:
  ColouredScans() { folder_.write("scanner.json", testing::smallProfileSource().text); }

  // Scans of the painted object from all around; one of them may have no colours.
  void writeScans(std::optional<int> without) {
    const Rig rig = testing::simulation(testing::smallObject(), testing::smallProfile());
    for (int i = 0; i < kScans; ++i) {
      const RangeImage image = scanFrom(rig, i * kStep, Progress());
      writeRangeFile(without == i ? image : testing::painted(image), scan(i));
    }
  }

  [[nodiscard]] std::string scan(int i) const { return folder_.file("scan" + std::to_string(i) + ".ply"); }

  // What the command says on standard output.
  std::string run(const std::vector<std::string>& arguments) const {
    std::vector<std::string> command{VANTAGE_CLI};
    command.insert(command.end(), arguments.begin(), arguments.end());
    command.insert(command.end(), {"--threads", "1"});
    const std::string log = folder_.file("log");
    const int code = testing::ChildProgram(command, log).wait();
    const std::string said(FileBytes(log).text());
    EXPECT_TRUE(code == 0 || code == 4) << code << ": " << said;
    return said;
  }

  void import() const {
    std::vector<std::string> arguments{"import"};
    std::string positions;
    for (int i = 0; i < kScans; ++i) {
      arguments.push_back(scan(i));
      if (i > 0) positions += ',';
      positions += std::to_string(i * kStep);
    }
    arguments.insert(arguments.end(), {"--scanner", folder_.file("scanner.json"), "--position", positions, "--session",
                                       folder_.file("s.vantage")});
    run(arguments);
  }

  static constexpr int kScans = 8;
  static constexpr int kStep = 3;
  testing::TemporaryFolder folder_;
};

TEST_F(ColouredScans, BecomeAModelInTheColoursOfTheObject) {
  writeScans({});
  import();
  const std::string said = run({"export", folder_.file("s.vantage"), "--out", folder_.file("model.ply")});
  EXPECT_NE(said.find("every vertex has a colour"), std::string::npos) << said;
  const Model model = readModel(folder_.file("model.ply"));
  const std::vector<Colour> colours = readMeshColours(folder_.file("model.ply"));
  ASSERT_EQ(colours.size(), model.mesh.vertices.size());
  ASSERT_GT(colours.size(), 1000U);
  int most = 0;
  int sum = 0;
  for (std::size_t v = 0; v < colours.size(); ++v) {
    const int difference = testing::differenceOf(colours[v], testing::paintAt(model.mesh.vertices[v]));
    most = std::max(most, difference);
    sum += difference;
  }
  // 1.5 a millimetre: scans are registered to some tenths of one, and samples lie 3 mm apart.
  EXPECT_LE(most, 6);
  EXPECT_LT(sum, 2.0 * static_cast<double>(colours.size()));

  EXPECT_NE(run({"export", folder_.file("s.vantage"), "--out", folder_.file("model.stl")})
                .find("the colours of the scans are not in the file"),
            std::string::npos);
  run({"export", folder_.file("s.vantage"), "--out", folder_.file("model.obj")});
  EXPECT_EQ(readMeshColours(folder_.file("model.obj")), colours);
}

TEST_F(ColouredScans, AndOthersBecomeAModelThatSaysWhereItHasNone) {
  writeScans(2);
  import();
  const std::string said = run({"export", folder_.file("s.vantage"), "--out", folder_.file("model.ply")});
  EXPECT_NE(said.find("none was measured: they are grey (128, 128, 128)"), std::string::npos) << said;
  const std::vector<Colour> colours = readMeshColours(folder_.file("model.ply"));
  const auto grey = std::count(colours.begin(), colours.end(), kGrey);
  EXPECT_GT(grey, 0);
  EXPECT_LT(grey, static_cast<std::ptrdiff_t>(colours.size() / 2));
}

TEST_F(ColouredScans, WithoutColoursNothingIsSaidOfThem) {
  const Rig rig = testing::simulation(testing::smallObject(), testing::smallProfile());
  for (int i = 0; i < kScans; ++i) writeRangeFile(scanFrom(rig, i * kStep, Progress()), scan(i));
  import();
  const std::string said = run({"export", folder_.file("s.vantage"), "--out", folder_.file("model.ply")});
  EXPECT_EQ(said.find("colour"), std::string::npos) << said;
  EXPECT_TRUE(readMeshColours(folder_.file("model.ply")).empty());
}

}  // namespace
}  // namespace vantage
