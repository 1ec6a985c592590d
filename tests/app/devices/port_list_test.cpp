#include "devices/serial/port_list.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/test_data.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

// What Linux says of terminals, in a folder.
class PortList : public ::testing::Test {
 protected:
  // A terminal below a device: its attributes are files beside it.
  void plug(const std::string& name, const std::string& device, bool inDev = true) const {
    const fs::path below = root() / "devices" / device / "tty" / name;
    fs::create_directories(below);
    fs::create_directories(root() / "class" / "tty");
    fs::create_directory_symlink(root() / "devices" / device, below / "device");
    fs::create_directory_symlink(below, root() / "class" / "tty" / name);
    if (inDev) write("dev/" + name, "");
  }
  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((root() / file).parent_path());
    std::ofstream(root() / file) << text;
  }
  [[nodiscard]] std::vector<PortDescription> ports() const { return serialPorts(root(), root() / "dev"); }
  [[nodiscard]] fs::path root() const { return temporary_.file("machine"); }

  testing::TemporaryFolder temporary_;
};

TEST_F(PortList, TellsWhatAnAdapterSaysOfItself) {
  write("devices/usb1/1-2/idVendor", "10c4\n");
  write("devices/usb1/1-2/idProduct", "ea60\n");
  write("devices/usb1/1-2/manufacturer", "Silicon Labs\n");
  write("devices/usb1/1-2/product", "CP2102 USB to UART Bridge Controller\n");
  write("devices/usb1/1-2/serial", "0001\n");
  plug("ttyUSB0", "usb1/1-2/1-2:1.0/ttyUSB0");
  ASSERT_EQ(ports().size(), 1U);
  const PortDescription port = ports().front();
  EXPECT_EQ(port.path, (root() / "dev" / "ttyUSB0").string());
  EXPECT_EQ(describe(port), "Silicon Labs CP2102 USB to UART Bridge Controller, USB 10c4:ea60, serial number 0001");
}

TEST_F(PortList, APortOfTheBoardIsOneWhereThereIsAChip) {
  plug("ttyS0", "pnp0/00:05");
  write("devices/pnp0/00:05/tty/ttyS0/type", "4\n");
  plug("ttyS1", "platform/serial8250");
  write("devices/platform/serial8250/tty/ttyS1/type", "0\n");
  ASSERT_EQ(ports().size(), 1U);
  EXPECT_EQ(ports().front().path, (root() / "dev" / "ttyS0").string());
  EXPECT_EQ(describe(ports().front()), "");
}

TEST_F(PortList, ConsolesAndWhatHasNoDeviceFileAreNoPorts) {
  fs::create_directories(root() / "class" / "tty" / "tty1");
  write("dev/tty1", "");
  plug("ttyUSB3", "usb1/1-3", false);
  EXPECT_TRUE(ports().empty());
}

TEST_F(PortList, IsInOrderAndOfOneLineEach) {
  for (const char* name : {"ttyUSB1", "ttyACM0", "ttyUSB0"}) plug(name, std::string("usb1/") + name);
  write("devices/usb1/ttyACM0/idVendor", "2341");
  write("devices/usb1/ttyACM0/idProduct", "0043");
  write("devices/usb1/ttyACM0/product", "evil\x1b[2Jname\nsecond line");
  const auto found = ports();
  ASSERT_EQ(found.size(), 3U);
  EXPECT_TRUE(found[0].path.ends_with("ttyACM0"));
  EXPECT_TRUE(found[2].path.ends_with("ttyUSB1"));
  EXPECT_EQ(found[0].description.find('\x1b'), std::string::npos);
  EXPECT_EQ(found[0].description.find('\n'), std::string::npos);
}

TEST(PortListOfThisMachine, CanBeRead) {
  for (const PortDescription& port : serialPorts()) EXPECT_TRUE(port.path.starts_with("/dev/"));
  EXPECT_TRUE(serialPorts("/nowhere", "/dev").empty());
}

}  // namespace
}  // namespace vantage
