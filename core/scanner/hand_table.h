#pragma once

#include <functional>

#include "scanner/positioner.h"

namespace vantage {

/// A table that a person turns.
class HandTable final : public Positioner {
 public:
  /// Asks the person to turn the table to a position and returns when they say that it stands there. While it waits it
  /// reports progress at least once a second: that is the sign that somebody is being asked, and the way to be stopped.
  /// @throws DeviceError when the person cannot do it; Cancelled
  using AskPerson = std::function<void(int position, const Progress& progress)>;

  /// @param uncertainty how well the person meets a position; nothing for as well as the profile's mechanics.
  HandTable(std::shared_ptr<const ScannerProfile> profile, AskPerson ask, std::optional<Mechanics> uncertainty = {});

  [[nodiscard]] std::string identity() const override { return "table turned by hand"; }
  void open(const Progress& /*progress*/) override {}
  void close() noexcept override {}
  [[nodiscard]] std::optional<std::string> notReady() const override { return {}; }
  [[nodiscard]] ReachedPose moveTo(int position, const Progress& progress) override;
  [[nodiscard]] std::optional<ReachedPose> where() const override { return where_; }

 private:
  std::shared_ptr<const ScannerProfile> profile_;
  AskPerson ask_;
  std::optional<Mechanics> uncertainty_;
  std::optional<ReachedPose> where_;
};

}  // namespace vantage
