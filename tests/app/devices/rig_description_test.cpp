#include "devices/rig_description.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "devices/rig_set_up.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::TemporaryFolder;

TEST(RigDescription, SensorsAndTablesAreNamedAsTheyAreRead) {
  for (const char* text : {"simulated", "folder:/tmp/a b", "openni2", "openni2:usb/1", "replay:S.vantage"})
    EXPECT_EQ(describe(parseSensor(text)), text);
  for (const char* text : {"simulated", "none", "hand", "serial:/dev/ttyUSB0", "serial:COM3,grbl"})
    EXPECT_EQ(describe(parseTable(text)), text);
  EXPECT_EQ(std::get<SerialTableDevice>(parseTable("serial:/a,b,grbl")), (SerialTableDevice{"/a,b", "grbl"}));
}

TEST(RigDescription, RefusesWhatIsNeitherSensorNorTable) {
  for (const char* text : {"", "folder:", "replay:", "camera", "openni"})
    EXPECT_THROW(static_cast<void>(parseSensor(text)), InvalidInput) << text;
  for (const char* text : {"", "serial:", "grbl", "simulated:1"})
    EXPECT_THROW(static_cast<void>(parseTable(text)), InvalidInput) << text;
}

TEST(RigDescription, AFileHoldsDevicesProgramsAndWhatIsCut) {
  const TemporaryFolder folder;
  const std::string path = folder.write("rig.json", R"({ "sensor": { "kind": "command", "run": ["scan", "{file}"] },
    "table": "serial:/dev/ttyACM0", "scanner": "p.json", "cut": { "table_margin": 1.5, "isolated": true } })");
  const RigFile file = readRigFile(path);
  EXPECT_EQ(std::get<ProgramDevice>(file.rig.sensor).run, (std::vector<std::string>{"scan", "{file}"}));
  EXPECT_EQ(std::get<ProgramDevice>(file.rig.sensor).timeout, std::chrono::seconds(60));
  EXPECT_EQ(file.rig.scanner, folder.file("p.json"));
  const AcquisitionSettings settings = withCut({}, file);
  EXPECT_EQ(settings.cut.tableMargin, 1.5);
  EXPECT_TRUE(settings.cut.isolated);
  EXPECT_TRUE(settings.cut.volume);
  EXPECT_EQ(parseRigFile(rigFileText(file), path).rig.table, file.rig.table);
}

TEST(RigDescription, MistakesInAFileAreNamedByPlace) {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& text) -> std::string {
    try {
      const RigFile file = readRigFile(folder.write("rig.json", text));
      static_cast<void>(withCut({}, file));
    } catch (const InvalidInput& e) {
      return e.what();
    }
    return {};
  };
  EXPECT_NE(message(R"({ "sensor": "simulated" })").find("table"), std::string::npos);
  EXPECT_NE(message(R"({ "sensor": { "kind": "magic" }, "table": "none" })").find("/sensor/kind"), std::string::npos);
  EXPECT_NE(message(R"({ "sensor": "openni2", "table": "none", "speed": 1 })").find("speed"), std::string::npos);
  EXPECT_NE(message(R"({ "sensor": "openni2", "table": "none", "cut": { "volum": true } })").find("cut.volum"),
            std::string::npos);
}

TEST(RigDescription, ASimulatedScannerSeesASimulatedTable) {
  EXPECT_TRUE(isSimulated({}));
  EXPECT_TRUE(isSimulated({SimulatedSensorDevice{}, HandTableDevice{}, {}, {}}));
  EXPECT_FALSE(isSimulated({FolderDevice{"/tmp"}, HandTableDevice{}, {}, {}}));
  EXPECT_THROW(static_cast<void>(isSimulated({FolderDevice{"/tmp"}, SimulatedTableDevice{}, {}, {}})), InvalidInput);
  EXPECT_THROW(static_cast<void>(isSimulated({SimulatedSensorDevice{}, NoTableDevice{}, {}, {}})), InvalidInput);
}

}  // namespace
}  // namespace vantage
