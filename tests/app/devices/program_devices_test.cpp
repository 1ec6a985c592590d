#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "app/devices/waiting.h"
#include "core/io/expect_error.h"
#include "devices/program_run.h"
#include "devices/program_sensor.h"
#include "devices/program_turntable.h"
#include "io/file_bytes.h"
#include "support/test_data.h"
#include "support/written_scans.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using testing::expectError;
using testing::TemporaryFolder;
using testing::Waiting;
using testing::WrittenScan;

constexpr std::chrono::seconds kSoon{10};

// A shell script as the program of an operator.
ProgramDevice script(const std::string& text, const std::vector<std::string>& arguments) {
  ProgramDevice program;
  program.run = {"/bin/sh", "-c", text, "script"};
  program.run.insert(program.run.end(), arguments.begin(), arguments.end());
  program.timeout = std::chrono::seconds(30);
  return program;
}

class ProgramSensorTest : public ::testing::Test {
 protected:
  std::unique_ptr<ProgramSensor> sensor(const ProgramDevice& program) {
    auto made = std::make_unique<ProgramSensor>(program, profile_);
    made->open({});
    made->standAt({1, profile_->workspace.poses[1], PoseSource::Commanded, {}});
    return made;
  }
  void expectFailure(const ProgramDevice& program, const std::vector<std::string>& parts) {
    testing::expectError<DeviceError>([&] { static_cast<void>(sensor(program)->capture({})); }, parts);
  }

  TemporaryFolder folder_;
  std::shared_ptr<const ScannerProfile> profile_ = std::make_shared<const ScannerProfile>(testing::stripeProfile());
  WrittenScan scan_{*profile_};
  std::string ply_ = folder_.write("scan.ply", testing::plyText(scan_, {}, true));
};

TEST_F(ProgramSensorTest, ReadsWhatTheProgramWrites) {
  const std::string told = folder_.file("told");
  const auto made = sensor(script("cp \"$1\" \"$2\"; echo \"$3 $4 $5\" > \"$6\"; echo done",
                                  {ply_, "{file}", "{position}", "{angle}", "at {tilt}", told}));
  EXPECT_EQ(made->capture({}).sampleCount(),
            static_cast<std::size_t>(
                std::count_if(scan_.points.begin(), scan_.points.end(), [](const auto& p) { return p.has_value(); })));
  EXPECT_EQ(made->output(), "done\n");
  std::ifstream in(told);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "1 -57.2958 at 0");
  static_cast<void>(made->capture({}));
}

TEST_F(ProgramSensorTest, TellsTheFormatByContentOrName) {
  const std::string text = folder_.write("points.txt", testing::xyzText(scan_, {}, false, false));
  EXPECT_GT(sensor(script("cp \"$1\" \"$2\"", {text, "{file}"}))->capture({}).sampleCount(), 100U);
  EXPECT_GT(sensor(script("cp \"$1\" \"$2\"", {text, "{file}.xyz"}))->capture({}).sampleCount(), 100U);
  EXPECT_GT(sensor(script("cp \"$1\" \"$2.asc\"", {text, "{file}"}))->capture({}).sampleCount(), 100U);
}

TEST_F(ProgramSensorTest, SaysWhatWentWrong) {
  expectFailure(script("echo no camera >&2; exit 3", {"{file}"}), {"exit code 3", "no camera"});
  expectFailure(script("kill -SEGV $$", {"{file}"}), {"exit code 139", "said nothing"});
  expectFailure(script("echo all well", {"{file}"}), {"wrote no file", "all well"});
  expectFailure(script(": > \"$1\"", {"{file}"}), {"empty file"});
  expectFailure(script("echo nonsense > \"$1\"", {"{file}"}), {"cannot be used", "'nonsense"});
  expectFailure(script("head -c 2000 \"$1\" > \"$2\"", {ply_, "{file}"}), {"cannot be used", "scan.ply"});
  ProgramDevice missing;
  missing.run = {"/no/such/program", "{file}"};
  expectFailure(missing, {"/no/such/program", "cannot be started"});
}

TEST_F(ProgramSensorTest, RefusesArgumentsThatMakeNoSense) {
  expectError<InvalidInput>([&] { ProgramSensor(script("true", {}), profile_); }, {"no {file}"});
  expectError<InvalidInput>([&] { ProgramSensor(script("true", {"{file}", "{speed}"}), profile_); }, {"{speed}"});
  expectError<InvalidInput>([&] { ProgramSensor(ProgramDevice{}, profile_); }, {"empty"});
}

// The program's child writes the file as soon as it is let live on.
TEST_F(ProgramSensorTest, EndsAProgramThatHangsWithAllThatItStarted) {
  const std::string alive = folder_.file("alive");
  ProgramDevice hanging = script("(trap '' TERM; sleep 2; : > \"$2\") & echo started; wait", {"{file}", alive});
  hanging.timeout = std::chrono::milliseconds(300);
  expectFailure(hanging, {"not ended within 0.3 s", "started"});
  std::this_thread::sleep_for(std::chrono::milliseconds(2500));
  EXPECT_FALSE(fs::exists(alive));
}

TEST_F(ProgramSensorTest, AnswersAStop) {
  const auto made = sensor(script("exec sleep 100", {"{file}"}));
  Waiting<RangeImage> waiting([&](const Progress& progress) { return made->capture(progress); });
  EXPECT_TRUE(waiting.says("scanning with /bin/sh"));
  waiting.stop();
  ASSERT_TRUE(waiting.isOver(kSoon));
  EXPECT_THROW(static_cast<void>(waiting.get()), Cancelled);
}

// The script of the manual is complete.
TEST_F(ProgramSensorTest, RunsTheExampleOfTheManual) {
  if (std::system("python3 -c pass") != 0) GTEST_SKIP() << "there is no python3";
  const FileBytes page((testing::sourceFolder() / "resources/manual/program_as_device.md").string());
  const std::string text(page.text());
  const std::size_t begin = text.find("```python\n") + 10;
  const std::string example = folder_.write("scan.py", text.substr(begin, text.find("```", begin) - begin));
  profile_ = std::make_shared<const ScannerProfile>(testing::cameraProfile());
  ProgramDevice program;
  program.run = {"python3", example, "{file}.xyz", "{position}"};
  const RangeImage image = sensor(program)->capture({});
  EXPECT_GT(image.sampleCount(), 1000U);
  for (std::size_t i = 0; i < image.range.size(); ++i)
    if (image.valid(i)) {
      EXPECT_NEAR(image.range[i], 403.0, 4.0);
    }
}

TEST_F(ProgramSensorTest, LeavesNoFilesBehind) {
  const std::string where = folder_.file("where");
  {
    const auto made = sensor(script("cp \"$1\" \"$2\"; echo \"$2\" > \"$3\"", {ply_, "{file}", where}));
    static_cast<void>(made->capture({}));
  }
  std::ifstream in(where);
  std::string file;
  std::getline(in, file);
  EXPECT_FALSE(fs::exists(fs::path(file).parent_path()));
}

TEST(ProgramTurntable, KnowsItsAngleFromTheProgramOrFromWhatItWasTold) {
  const auto turned = [](const std::string& text) {
    ProgramTurntable table(script(text, {"{angle}", "{position}"}));
    table.open({});
    EXPECT_FALSE(table.angle());
    table.headFor(7);
    const TableAngle angle = table.turnTo(-12.34567, {});
    EXPECT_EQ(table.angle()->degrees, angle.degrees);
    return angle;
  };
  EXPECT_EQ(turned("echo moving; echo ' -12.5 '").degrees, -12.5);
  EXPECT_EQ(turned("echo -12,5").knownBy, PoseSource::Reported);
  EXPECT_EQ(turned("echo $1").degrees, -12.3457);
  EXPECT_EQ(turned("echo $2").degrees, 7.0);
  EXPECT_EQ(turned("echo arrived").degrees, -12.34567);
  EXPECT_EQ(turned("true").knownBy, PoseSource::Commanded);
}

TEST(ProgramTurntable, SaysWhatWentWrongAndForgetsWhereItStands) {
  ProgramTurntable table(script("test $1 = 10 || { echo stuck; exit 1; }", {"{angle}"}));
  expectError<DeviceError>([&] { static_cast<void>(table.turnTo(10.0, {})); }, {"not open"});
  table.open({});
  static_cast<void>(table.turnTo(10.0, {}));
  EXPECT_TRUE(table.angle());
  expectError<DeviceError>([&] { static_cast<void>(table.turnTo(20.0, {})); }, {"exit code 1", "20 degrees", "stuck"});
  EXPECT_FALSE(table.angle());
  expectError<DeviceError>([&] { table.home({}); }, {"no home"});
  expectError<InvalidInput>([] { ProgramTurntable(script("true", {})); }, {"{angle}"});
  expectError<InvalidInput>([] { ProgramTurntable(script("true", {"{angle}", "{file}"})); }, {"{file}"});
}

TEST(ProgramRun, FillsInAndLeavesOtherBraces) {
  EXPECT_EQ(filledIn({"a{file}b", "{}", "{ x }", "{file}{file}"}, {{"file", "F"}}),
            (std::vector<std::string>{"aFb", "{}", "{ x }", "FF"}));
  EXPECT_EQ(argumentText(-0.00001), "0");
  EXPECT_EQ(argumentText(1234.5), "1234.5");
  EXPECT_EQ(argumentText(-120.0), "-120");
}

TEST(ProgramRun, KeepsTheEndOfALongOutput) {
  const ProgramEnd end =
      runProgram({"/bin/sh", "-c", "seq 1 200000; echo last"}, std::chrono::seconds(30), "counting", {});
  EXPECT_LE(end.output.size(), std::size_t{1} << 16);
  EXPECT_TRUE(end.output.ends_with("200000\nlast\n"));
  EXPECT_TRUE(saidLast(end).ends_with("last"));
}

}  // namespace
}  // namespace vantage
