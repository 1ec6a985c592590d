#include <cstdlib>
#include <filesystem>
#include <future>
#include <nlohmann/json.hpp>

#include "app/devices/waiting.h"
#include "core/io/expect_error.h"
#include "devices/folder_sensor.h"
#include "devices/program_run.h"
#include "devices/program_sensor.h"
#include "io/profile_scan.h"
#include "support/test_data.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using testing::expectError;
using testing::TemporaryFolder;
using testing::Waiting;

constexpr std::chrono::minutes kPatience{3};

// A vendor's program of the laboratory, whose build folder VANTAGE_LAB names.
class LabVendor : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* lab = std::getenv("VANTAGE_LAB");
    if (lab != nullptr) program_ = (fs::path(lab) / "lab_vendor").string();
    if (lab == nullptr || !fs::exists(program_))
      GTEST_SKIP() << "no laboratory: set VANTAGE_LAB to the folder that lab_vendor was built in";
  }

  // What it is asked to write with, for one scan.
  [[nodiscard]] std::vector<std::string> run(const std::string& out, const std::vector<std::string>& more,
                                             bool pinhole) const {
    std::vector<std::string> run{
        program_,  "--mesh", resource("objects/mug.ply"), "--profile", profileFile(pinhole), "--out", out,
        "--angle", "40"};
    run.insert(run.end(), more.begin(), more.end());
    return run;
  }
  static std::string resource(const std::string& name) {
    return (testing::sourceFolder() / "resources" / name).string();
  }
  static std::string profileFile(bool pinhole) {
    return resource(pinhole ? "scanners/depth_camera.json" : "scanners/rotating_stripe.json");
  }
  static std::shared_ptr<const ScannerProfile> profile(bool pinhole) {
    return std::make_shared<const ScannerProfile>(loadProfile(profileFile(pinhole)));
  }

  // The one range file of a folder.
  [[nodiscard]] std::string write(const TemporaryFolder& folder, const std::vector<std::string>& more,
                                  bool pinhole) const {
    const std::string out = folder.file("scans");
    fs::remove_all(out);
    const ProgramEnd end = runProgram(run(out, more, pinhole), kPatience, "the vendor scans", {});
    EXPECT_EQ(end.exitCode, 0) << end.errors;
    return (fs::path(out) / nlohmann::json::parse(end.output).at("file").get<std::string>()).string();
  }

  static void expectSame(const RangeImage& image, const RangeImage& expected, double tolerance) {
    ASSERT_EQ(image.range.size(), expected.range.size());
    std::size_t missing = 0;
    double worst = 0.0;
    for (std::size_t i = 0; i < image.range.size(); ++i) {
      missing += image.valid(i) != expected.valid(i) ? 1U : 0U;
      if (image.valid(i) && expected.valid(i))
        worst = std::max(worst, std::abs(static_cast<double>(image.range[i] - expected.range[i])));
    }
    EXPECT_EQ(missing, 0U);
    EXPECT_LE(worst, tolerance);
  }

  std::string program_;
};

TEST_F(LabVendor, WritesTheSameScanInEveryFormatUnitAndFrame) {
  const TemporaryFolder folder;
  for (const bool pinhole : {false, true}) {
    const auto scanner = profile(pinhole);
    const RangeImage expected = readScan(write(folder, {"--format", "ply-range-grid", "--binary"}, pinhole), *scanner);
    EXPECT_GT(expected.sampleCount(), 2'000U);
    for (const std::string format : {"ply-range-grid", "ply-points", "ptx", "pcd", "pcd-binary", "xyz-grid", "asc"})
      for (const std::string frame : {"profile", "camera", "opengl"}) {
        if (format.starts_with("ply") && frame == "opengl") continue;
        SCOPED_TRACE(scanner->name + " " + format + " " + frame);
        expectSame(readScan(write(folder, {"--format", format, "--frame", frame}, pinhole), *scanner), expected, 1e-2);
      }
    for (const auto& [unit, millimetres] : {std::pair<std::string, double>{"m", 1000.0}, {"inch", 25.4}}) {
      SCOPED_TRACE(unit);
      const std::string file = write(folder, {"--format", "asc", "--units", unit, "--frame", "camera"}, pinhole);
      expectError<UnansweredQuestion>([&] { static_cast<void>(readScan(file, *scanner)); }, {"say --unit " + unit});
      ScanReadingOptions options;
      options.unit = millimetres;
      expectSame(readScan(file, *scanner, options), expected, 1e-2);
    }
    for (const std::string missing : {"nan", "zero", "-9999"}) {
      SCOPED_TRACE(missing);
      const std::string file =
          write(folder, {"--format", "xyz-grid", "--missing", missing, "--decimal", "comma"}, pinhole);
      expectSame(readScan(file, *scanner), expected, 1e-2);
    }
  }
  const auto camera = profile(true);
  const RangeImage expected = readScan(write(folder, {"--format", "ply-range-grid"}, true), *camera);
  expectSame(readScan(write(folder, {"--format", "png16"}, true), *camera), expected, 0.08);
}

TEST_F(LabVendor, IsWaitedForHoweverItWrites) {
  const auto scanner = profile(false);
  const TemporaryFolder folder;
  const RangeImage expected = readScan(write(folder, {"--format", "asc"}, false), *scanner);
  for (const std::string how : {"whole", "slow", "rename", "burst", "truncated-then-complete"}) {
    for (const std::string format : {"ply-range-grid", "asc"}) {
      SCOPED_TRACE(how + " " + format);
      FolderSensorOptions options;
      options.folder = folder.file(how + format);
      options.deadline = kPatience;
      fs::create_directory(options.folder);
      FolderSensor sensor(options, scanner);
      sensor.open({});
      Waiting<RangeImage> waiting([&](const Progress& progress) { return sensor.capture(progress); });
      ASSERT_TRUE(waiting.says("waiting for a range file"));
      const auto vendor = runProgram(
          run(options.folder, {"--write", how, "--format", format, "--write-seconds", "2"}, false), kPatience, "", {});
      ASSERT_EQ(vendor.exitCode, 0) << vendor.errors;
      expectSame(waiting.get(), expected, 1e-2);
    }
  }
}

TEST_F(LabVendor, IsNotBelievedWhenItDiesWhileItWrites) {
  const auto scanner = profile(false);
  const TemporaryFolder folder;
  for (const std::string format : {"ply-range-grid", "ply-points", "ptx", "pcd", "pcd-binary", "xyz-grid"}) {
    SCOPED_TRACE(format);
    const std::string file = write(folder, {"--format", format, "--write", "truncated"}, false);
    EXPECT_THROW(static_cast<void>(readScan(file, *scanner)), InvalidInput);
  }
}

TEST_F(LabVendor, WorksAsAProgramThatIsRunForEveryScan) {
  const TemporaryFolder folder;
  ProgramDevice program;
  program.run = {"/bin/sh",
                 "-c",
                 R"("$1" --mesh "$2" --profile "$3" --out "${4%/*}" --name "${4##*/}" --angle "$5")",
                 "scan",
                 program_,
                 resource("objects/mug.ply"),
                 profileFile(false),
                 "{file}",
                 "{angle}"};
  const auto scanner = profile(false);
  ProgramSensor sensor(program, scanner);
  sensor.open({});
  sensor.standAt({10, scanner->workspace.poses[10], PoseSource::Commanded, {}});
  EXPECT_GT(sensor.capture({}).sampleCount(), 2'000U);
}

}  // namespace
}  // namespace vantage
