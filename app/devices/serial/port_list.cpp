#include "devices/serial/port_list.h"

#include <QSerialPortInfo>
#include <algorithm>
#include <cstdio>

#include "base/plain_text.h"

namespace vantage {
namespace {

std::string usbOf(const QSerialPortInfo& info) {
  if (!info.hasVendorIdentifier() || !info.hasProductIdentifier()) return {};
  char text[16];
  std::snprintf(text, sizeof text, "%04x:%04x", info.vendorIdentifier(), info.productIdentifier());
  return text;
}

std::string plain(const QString& text) {
  return plainText(text.toStdString());
}

}  // namespace

std::vector<PortDescription> serialPorts() {
  std::vector<PortDescription> ports;
  for (const QSerialPortInfo& info : QSerialPortInfo::availablePorts())
    ports.push_back({info.systemLocation().toStdString(), plain(info.description()), plain(info.manufacturer()),
                     plain(info.serialNumber()), usbOf(info)});
  std::sort(ports.begin(), ports.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return ports;
}

std::string describe(const PortDescription& port) {
  std::string text = port.manufacturer;
  if (!port.description.empty()) text += (text.empty() ? "" : " ") + port.description;
  if (!port.usb.empty()) text += (text.empty() ? "USB " : ", USB ") + port.usb;
  if (!port.serialNumber.empty()) text += ", serial number " + port.serialNumber;
  return text;
}

}  // namespace vantage
