#pragma once

#include <memory>

#include "scanner/positioner.h"
#include "scanner/turntable.h"

namespace vantage {

/// How a table is driven.
struct TurntableUse {
  int standsAt = 0;          ///< position of the workspace at which the table stands when it is opened
  bool alwaysMoves = false;  ///< also to where it stands already: by a whole turn
};

/// Brings the scanner to the positions of a workspace by turning a table.
///
/// Scanners that begin by themselves once a table has come to rest need a move for every scan: then the table turns
/// once round where it stands already.
///
/// A table that says where it came to stand is believed: the pose is that of its angle, also off the position.
class TurntablePositioner final : public Positioner {
 public:
  /// @param profile with the table's calibration, when there is one: sense and ratio of its turns are taken from it.
  TurntablePositioner(std::shared_ptr<const ScannerProfile> profile, std::shared_ptr<Turntable> table,
                      const TurntableUse& use = {});

  [[nodiscard]] std::string identity() const override { return table_->identity(); }
  void open(const Progress& progress) override;
  void close() noexcept override { table_->close(); }
  [[nodiscard]] std::optional<std::string> notReady() const override { return table_->notReady(); }
  [[nodiscard]] ReachedPose moveTo(int position, const Progress& progress) override;
  [[nodiscard]] std::optional<ReachedPose> where() const override { return where_; }

 private:
  std::shared_ptr<const ScannerProfile> profile_;
  std::shared_ptr<Turntable> table_;
  TurntableUse use_;
  double offset_ = 0.0;  // of the table's count from tableAngleOf [deg]
  std::optional<ReachedPose> where_;
};

/// The angle of the table [deg, as it counts] at a position: the one of all whole turns that is nearest to `near`.
/// @throws InvalidInput when the workspace lacks the position
[[nodiscard]] double tableAngleOf(const ScannerProfile& profile, int position, double near);

}  // namespace vantage
