#pragma once

#include <memory>

#include "scanner/positioner.h"
#include "scanner/table_stand.h"
#include "scanner/turntable.h"

namespace vantage {

/// How a table is driven.
struct TurntableUse {
  TableStand stands = {};    ///< where the table stands when it is opened
  bool alwaysMoves = false;  ///< also to where it stands already: by a whole turn
};

/// Brings the scanner to the positions of a workspace by turning a table. One that knows its angle when it is opened
/// counts from there; others, such as programs, are told angles from position 0.
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
  void standsFarther(double angle) override { farther_ += angle; }
  /// After a move that failed or was cancelled, the position that is nearest to the angle that the table then says.
  [[nodiscard]] std::optional<ReachedPose> where() const override;

 private:
  [[nodiscard]] ReachedPose poseAt(int position, double beyond, PoseSource knownBy) const;

  std::shared_ptr<const ScannerProfile> profile_;
  std::shared_ptr<Turntable> table_;
  TurntableUse use_;
  double offset_ = 0.0;  // of the table's count from tableAngleOf [deg]
  double farther_;       // the scanner really stands round the table than that says [rad]
  std::optional<ReachedPose> where_;
};

/// The angle of the table [deg, as it counts] at a position: the one of all whole turns that is nearest to `near`.
/// @throws InvalidInput when the workspace lacks the position
[[nodiscard]] double tableAngleOf(const ScannerProfile& profile, int position, double near);

}  // namespace vantage
