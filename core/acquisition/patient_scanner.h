#pragma once

#include <chrono>
#include <memory>

#include "scanner/device.h"

namespace vantage {

/// A scanner that is given up when it shows no sign of life for too long: neither progress nor a result. The device is
/// then left to itself; it is kept alive until it comes back, however late.
class PatientScanner final : public ScannerDevice {
 public:
  PatientScanner(std::shared_ptr<ScannerDevice> scanner, std::chrono::milliseconds patience)
      : scanner_(std::move(scanner)), patience_(patience) {}

  /// @throws DeviceError also when the device does not answer, and from then on; Cancelled at once, whether the device
  /// listens or not.
  [[nodiscard]] RangeImage scan(int position, const Progress& progress) override;

 private:
  std::shared_ptr<ScannerDevice> scanner_;
  std::chrono::milliseconds patience_;
  bool givenUp_ = false;
};

}  // namespace vantage
