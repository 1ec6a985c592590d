#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/errors.h"
#include "io/file_info.h"
#include "io/mesh_reader.h"
#include "support/test_data.h"

namespace vantage {
namespace {

constexpr double kMostSeconds = 10.0;

// What became of a file: nothing when it was read, else the message.
struct Outcome {
  std::string message;
  double seconds = 0.0;
  [[nodiscard]] bool wasRead() const { return message.empty(); }
};

template <typename Action>
Outcome attempt(const Action& action) {
  const auto start = std::chrono::steady_clock::now();
  Outcome outcome;
  try {
    action();
  } catch (const Error& e) {
    outcome.message = e.what();
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

void expectGoodMessage(const Outcome& outcome, const std::string& path) {
  EXPECT_LT(outcome.seconds, kMostSeconds) << path;
  if (outcome.wasRead()) return;
  EXPECT_NE(outcome.message.find(path), std::string::npos) << outcome.message;
  EXPECT_EQ(outcome.message.find('\n'), std::string::npos) << outcome.message;
  EXPECT_GT(outcome.message.size(), path.size() + 10) << outcome.message;
}

TEST(HostileFiles, AreEachReadOrRefusedQuicklyInOneSentence) {
  VANTAGE_NEEDS_TEST_DATA(folder);
  for (const std::string& path : testing::filesBelow(*folder / "hostile")) {
    expectGoodMessage(attempt([&] { static_cast<void>(loadMesh(path)); }), path);
    expectGoodMessage(attempt([&] { static_cast<void>(describeFile(path)); }), path);
  }
}

struct Expectation {
  std::string kind;
  std::string expected;
};

std::map<std::string, Expectation> readManifest(const std::filesystem::path& folder) {
  std::map<std::string, Expectation> manifest;
  std::ifstream in(folder / "MANIFEST.tsv");
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, '\t');) fields.push_back(field);
    if (fields.size() >= 9 && fields[0].starts_with("hostile/")) manifest[fields[0]] = {fields[7], fields[8]};
  }
  return manifest;
}

// Files that the list expects to load, and why they do not.
const std::map<std::string, std::string> kNotRead{
    {"hostile/assimp/number_formats.obj", "its only triangle has its corners in one line"},
    {"hostile/inline/tpr_ply_testComment.ply", "it has no vertices"},
    {"hostile/inline/tpr_ply_testFormatAscii_no_final_newline.ply", "it has no vertices"},
    {"hostile/lib3mf/BeamLattice__BeamSet_Unique.3mf", "it has beams but no triangles"},
    {"hostile/lib3mf/SecureContent__keystore.3mf", "one of its parts is wrapped for encryption"},
    {"hostile/lib3mf/SecureContent__keystore_encrypted.3mf", "it is encrypted"},
    {"hostile/lib3mf/SecureContent__keystore_encrypted_compressed.3mf", "it is encrypted"},
    {"hostile/lib3mf/Slice__Expected_Slice_Hierarchy.3mf", "its meshes are empty"},
    {"hostile/manifold/Cray_right.obj", "its coordinates are the largest numbers of single precision"},
};

TEST(HostileFiles, InOurOwnFormatsAreReadIfTheyShouldBe) {
  VANTAGE_NEEDS_TEST_DATA(folder);
  const std::set<std::string> own{".ply", ".obj", ".stl", ".STL", ".off", ".3mf", ".3MF"};
  std::size_t read = 0;
  for (const auto& [name, expectation] : readManifest(*folder)) {
    const std::filesystem::path path = *folder / name;
    const bool shouldLoad = expectation.expected.starts_with("load") || expectation.expected.starts_with("read mesh");
    if (!shouldLoad || own.count(path.extension().string()) == 0 || kNotRead.count(name) != 0) continue;
    const Outcome outcome = attempt([&] { static_cast<void>(describeFile(path.string())); });
    EXPECT_TRUE(outcome.wasRead()) << outcome.message;
    ++read;
  }
  EXPECT_GT(read, 100U);
}

TEST(HostileFiles, ThatAreDamagedAreRefused) {
  VANTAGE_NEEDS_TEST_DATA(folder);
  const std::set<std::string> damaged{"malformed", "bomb", "truncated", "empty", "lfs_pointer"};
  // Readable all the same: the damage is in what a scanner does not need, or can be skipped.
  const std::set<std::string> harmless{"hostile/realworld/bun.conf.missing_extension", "hostile/trimesh/jacked.obj"};
  for (const auto& [name, expectation] : readManifest(*folder)) {
    if (damaged.count(expectation.kind) == 0 || name.ends_with(".3mf") || harmless.count(name) != 0) continue;
    const std::string path = (*folder / name).string();
    const Outcome outcome = attempt([&] { static_cast<void>(describeFile(path)); });
    EXPECT_FALSE(outcome.wasRead()) << path;
  }
}

}  // namespace
}  // namespace vantage
