#pragma once

#include <memory>

#include "scanner/device.h"
#include "scanner/patience.h"

namespace vantage {

/// A scanner that is given up when it shows no sign of life for too long (see Patience).
class PatientScanner final : public ScannerDevice {
 public:
  PatientScanner(std::shared_ptr<ScannerDevice> scanner, std::chrono::milliseconds patience)
      : scanner_(std::move(scanner)), patience_("the scanner", patience) {}

  /// @throws DeviceError also when the device does not answer, and until it comes back; Cancelled soon, whether the
  /// device listens or not.
  [[nodiscard]] RangeImage scan(int position, const Progress& progress) override {
    return patience_.call<RangeImage>(
        "scanning from position " + std::to_string(position),
        [scanner = scanner_, position](const Progress& inner) { return scanner->scan(position, inner); }, progress);
  }

 private:
  std::shared_ptr<ScannerDevice> scanner_;
  Patience patience_;
};

}  // namespace vantage
