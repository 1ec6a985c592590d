#include "devices/serial/serial_port.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include "base/errors.h"
#include "devices/device_listing.h"
#include "devices/serial/port_holder.h"
#include "devices/serial/port_list.h"
#include "stand_in_table.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using std::chrono::milliseconds;
using testing::StandInTable;

std::string messageOfOpening(const std::string& port) {
  SerialPort line(port);
  try {
    line.open(115200);
  } catch (const DeviceError& e) {
    EXPECT_FALSE(line.isOpen());
    return e.what();
  }
  return "opened";
}

std::string readUntil(SerialPort& port, const std::string& mark) {
  std::string text;
  for (int i = 0; i < 1200 && text.find(mark) == std::string::npos; ++i) text += port.read(milliseconds(50));
  return text;
}

TEST(SerialPort, TakesBytesFromAnyThreadAndAtAnySpeed) {
  const StandInTable table(testing::grblStandIn({}));
  SerialPort port(table.port());
  for (const int baud : {9600, 115200, 250000}) {
    std::thread([&] { port.open(baud); }).join();
    EXPECT_NE(readUntil(port, "help]").find("Grbl 1.1h"), std::string::npos);
    port.write("?");
    std::thread([&] { EXPECT_NE(readUntil(port, ">").find("<Idle"), std::string::npos); }).join();
    EXPECT_EQ(port.read(milliseconds(20)).find('<'), std::string::npos);
    port.close();
    std::this_thread::sleep_for(milliseconds(50));
  }
}

TEST(SerialPort, SaysWhatKeepsItFromBeingOpened) {
  EXPECT_NE(messageOfOpening("/dev/no-such-port").find("there is no such port"), std::string::npos);
  EXPECT_NE(messageOfOpening("no-such-port").find("/dev/no-such-port: there is no such port"), std::string::npos);
  const testing::TemporaryFolder folder;
  EXPECT_NE(messageOfOpening(folder.write("file", "text")).find("is no serial port"), std::string::npos);
  EXPECT_NE(messageOfOpening(folder.file(".")).find("is no serial port"), std::string::npos);
}

TEST(SerialPort, WithoutPermissionNamesTheGroup) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may open everything";
  const testing::TemporaryFolder folder;
  const std::string path = folder.write("locked", "");
  std::filesystem::permissions(path, std::filesystem::perms::none);
  EXPECT_NE(messageOfOpening(path).find("add yourself to the group dialout"), std::string::npos);
}

TEST(SerialPort, IsNotSharedWithAnotherProgram) {
  const StandInTable table(testing::grblStandIn({}));
  SerialPort port(table.port());
  port.open(115200);
  EXPECT_NE(messageOfOpening(table.port()).find("is in use by another program"), std::string::npos);
  port.close();

  const pid_t other = ::fork();
  if (other == 0) {
    const int descriptor = ::open(table.port().c_str(), O_RDWR | O_NOCTTY);
    ::pause();
    ::_exit(descriptor);
  }
  for (int i = 0; i < 400 && holderOf(table.port()).empty(); ++i) std::this_thread::sleep_for(milliseconds(5));
  const std::string message = messageOfOpening(table.port());
  ::kill(other, SIGKILL);
  ::waitpid(other, nullptr, 0);
  EXPECT_NE(message.find("(process " + std::to_string(other) + ")"), std::string::npos) << message;
}

TEST(SerialPort, ThatVanishesIsClosedAndSaysSo) {
  StandInTable table(testing::grblStandIn({}));
  SerialPort port(table.port());
  port.open(115200);
  static_cast<void>(readUntil(port, "help]"));
  table.unplug();
  try {
    for (int i = 0; i < 10; ++i) static_cast<void>(port.read(milliseconds(50)));
    FAIL() << "a port that is gone was read from";
  } catch (const DeviceError& e) {
    EXPECT_NE(std::string(e.what()).find("has vanished"), std::string::npos) << e.what();
  }
  EXPECT_FALSE(port.isOpen());
  EXPECT_THROW(port.write("?"), DeviceError);
}

TEST(PortsOfThisMachine, IsInOrderAndHasADescriptionOfEach) {
  const auto ports = serialPorts();
  for (std::size_t i = 1; i < ports.size(); ++i) EXPECT_LT(ports[i - 1].path, ports[i].path);
  EXPECT_EQ(describe(PortDescription{"/dev/ttyUSB0", "UART Bridge", "Maker", "0001", "10c4:ea60"}),
            "Maker UART Bridge, USB 10c4:ea60, serial number 0001");
  EXPECT_EQ(describe(PortDescription{"/dev/ttyS0", "", "", "", ""}), "");
}

TEST(DeviceListing, AsksAPortThatIsInNoList) {
  const StandInTable table(testing::grblStandIn({}));
  const auto found = listSerialPorts(table.port(), {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, table.port());
  EXPECT_EQ(found[0].protocol, "grbl");
  EXPECT_EQ(found[0].answer, "GRBL 1.1");

  const auto absent = listSerialPorts("/dev/no-such-port", {});
  ASSERT_EQ(absent.size(), 1U);
  EXPECT_TRUE(absent[0].asked);
  EXPECT_EQ(absent[0].protocol, "");
  EXPECT_NE(absent[0].answer.find("there is no such port"), std::string::npos);
}

}  // namespace
}  // namespace vantage
