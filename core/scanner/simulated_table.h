#pragma once

#include <cstdint>
#include <memory>

#include "scanner/positioner.h"

namespace vantage {

struct SimulationOptions {
  std::uint64_t seed = 1;
  bool ideal = false;  ///< no noise, no dropout, no mechanical error
};

/// A turntable that errs as its profile says, and reports where it was told to go. With every scan it has moved once
/// more: each move adds an error of its own (a turn about z, a shift in x and y) to those before; the first has none.
///
/// Errors depend on the seed and the ordinal of the scan only. A move whose scan was not taken, because it was
/// interrupted or failed, is not counted: repeated, it ends in the same place.
class SimulatedTable final : public Positioner {
 public:
  /// @param scansBefore how many scans were taken before, to go on with an interrupted series.
  SimulatedTable(std::shared_ptr<const ScannerProfile> profile, const SimulationOptions& options, int scansBefore = 0);

  [[nodiscard]] std::string identity() const override { return "simulated turntable"; }
  void open(const Progress& /*progress*/) override {}
  void close() noexcept override {}
  [[nodiscard]] std::optional<std::string> notReady() const override { return {}; }
  [[nodiscard]] ReachedPose moveTo(int position, const Progress& progress) override;
  [[nodiscard]] std::optional<ReachedPose> where() const override { return where_; }

  /// Where the scanner really is, relative to where the table believes it to be, for the scan of that ordinal:
  /// T_table_scanner (true) = this * workspace pose.
  [[nodiscard]] Pose mechanicalError(int ordinal) const;

  /// Where the scanner really is, T_table_scanner; nothing before the first move.
  [[nodiscard]] const std::optional<Pose>& truth() const { return truth_; }

  /// Ordinal of the scan to come, from 0.
  [[nodiscard]] int scans() const { return scans_; }
  /// Tells that a scan was taken.
  void countScan() { ++scans_; }

 private:
  std::shared_ptr<const ScannerProfile> profile_;
  SimulationOptions options_;
  int scans_;
  std::optional<Pose> truth_;
  std::optional<ReachedPose> where_;
};

}  // namespace vantage
