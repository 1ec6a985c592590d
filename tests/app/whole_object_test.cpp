#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "app/child_program.h"
#include "geometry/measures.h"
#include "io/mesh_reader.h"
#include "report/evaluation.h"
#include "scanner/profile.h"
#include "support/test_data.h"

// The sample objects all around: turned over by the program itself, aligned without a hint, in one model.

namespace vantage {
namespace {

const std::string kResources = std::string(VANTAGE_SOURCE_DIR) + "/resources/";

struct Whole {
  nlohmann::json report;
  MeshMeasures measures;
  Evaluation evaluation;
};

Whole acquireAllAround(const std::string& object, int seed) {
  const testing::TemporaryFolder folder;
  const std::string mesh = kResources + "objects/" + object + ".ply";
  const std::string scanner = kResources + "scanners/rotating_stripe.json";
  const std::string out = folder.file("out");
  testing::ChildProgram acquire({VANTAGE_CLI, "acquire", "--object", mesh, "--scanner", scanner, "--stands", "auto",
                                 "--seed", std::to_string(seed), "--out", out, "--threads", "2"},
                                folder.file("log"));
  // Doubtful views are told.
  const int code = acquire.wait();
  EXPECT_TRUE(code == 0 || code == 4) << code;
  Whole whole;
  std::ifstream(out + "/report.json") >> whole.report;
  const Mesh model = loadMesh(out + "/model.ply").mesh;
  whole.measures = measure(model);
  whole.evaluation = evaluate(model, loadMesh(mesh).mesh, loadProfile(scanner), {}, Progress().withThreads(2));
  return whole;
}

// What must hold of every object: all stands are put together by evidence, and nothing is wrong with the surface.
void expectSound(const Whole& whole) {
  EXPECT_EQ(whole.report["terminated_by"], "finished");
  for (const auto& stand : whole.report["stands"]) {
    const std::string verdict = stand["verdict"];
    EXPECT_EQ(verdict, stand["index"] == 0 ? "reference" : "good") << stand;
    double square = 0.0;
    for (const double r : stand["rotation"]) square += r * r;
    EXPECT_NEAR(square, 3.0, 1e-6) << stand["rotation"];
  }
  EXPECT_EQ(whole.measures.nonManifoldEdges, 0U);
  EXPECT_EQ(whole.measures.components, 1U);
  EXPECT_LE(whole.evaluation.rms, 0.12);
  EXPECT_LE(whole.evaluation.falseSurface, 0.001);
}

TEST(WholeObject, TheHandsetIsClosed) {
  const Whole handset = acquireAllAround("handset", 1);
  expectSound(handset);
  EXPECT_LE(handset.report["stands"].size(), 3U);
  EXPECT_EQ(handset.measures.boundaryEdges, 0U);
  EXPECT_GE(handset.evaluation.wholeCoverage, 0.999);
}

TEST(WholeObject, OfTheMugOnlyWhatNoSideShowsIsMissing) {
  const Whole mug = acquireAllAround("mug", 1);
  expectSound(mug);
  EXPECT_LE(mug.report["stands"].size(), 7U);
  EXPECT_GE(mug.evaluation.wholeCoverage, 0.93);
}

}  // namespace
}  // namespace vantage
