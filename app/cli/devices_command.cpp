#include <memory>

#include "base/errors.h"
#include "base/plain_text.h"
#include "cli/command.h"
#include "devices/device_listing.h"

namespace vantage {
namespace {

nlohmann::ordered_json jsonOf(const ListedDevice& device) {
  nlohmann::ordered_json json{
      {"kind", device.kind}, {"name", device.name}, {"description", device.description}, {"asked", device.asked}};
  if (!device.protocol.empty()) json["protocol"] = device.protocol;
  if (device.asked) json[device.protocol.empty() ? "problem" : "answers_as"] = device.answer;
  return json;
}

std::string textOf(const ListedDevice& device) {
  std::string text = device.kind + "  " + plainText(device.name);
  if (!device.description.empty()) text += "  " + plainText(device.description);
  if (!device.protocol.empty()) return text + "  answers as " + device.answer + " (" + device.protocol + ")\n";
  if (!device.asked) return text + "  not asked; name it with --port\n";
  return text + "\n    " + plainText(device.answer) + "\n";
}

void listDevices(const std::string& port, CommandContext& context) {
  // Every kind of device adds its rows here.
  std::vector<ListedDevice> devices = listSerialPorts(port, context.progress());
  if (port.empty())
    for (ListedDevice& camera : listCameras(context.progress())) devices.push_back(std::move(camera));
  nlohmann::ordered_json json{{"devices", nlohmann::ordered_json::array()}};
  std::string text;
  for (const ListedDevice& device : devices) {
    json["devices"].push_back(jsonOf(device));
    text += textOf(device);
  }
  if (devices.empty()) text = "No device is connected.\n";
  context.result(json, text);
  if (!port.empty() && devices.front().protocol.empty()) throw DeviceError(devices.front().answer);
}

}  // namespace

void addDevicesCommand(CLI::App& app, CommandContext& context) {
  auto port = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "devices", "List what is connected, what answers and with which protocol; asking resets most turntables");
  command->add_option("--port", *port, "Ask this serial port only, also one that is in no list");
  context.addCommonOptions(*command);
  command->callback([port, &context] { listDevices(*port, context); });
}

}  // namespace vantage
