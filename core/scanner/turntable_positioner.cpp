#include "scanner/turntable_positioner.h"

#include <cmath>
#include <utility>

#include "base/errors.h"
#include "scanner/table_turn.h"

namespace vantage {
namespace {

// Nobody notices that a table has turned by less [deg].
constexpr double kNoMove = 0.5;

// Of the table's own count per degree that it turns counter-clockwise.
double countPerDegree(const ScannerProfile& profile) {
  if (!profile.calibration) return 1.0;
  return profile.calibration->sense / profile.calibration->degreesPerCommandedDegree;
}

}  // namespace

double tableAngleOf(const ScannerProfile& profile, int position, double near) {
  const double count = countPerDegree(profile);
  const double angle = count * degrees(turnBetween(profile.workspace, 0, position).angle);
  const double turn = std::abs(count) * 360.0;
  return angle + turn * std::round((near - angle) / turn);
}

TurntablePositioner::TurntablePositioner(std::shared_ptr<const ScannerProfile> profile,
                                         std::shared_ptr<Turntable> table, const TurntableUse& use)
    : profile_(std::move(profile)), table_(std::move(table)), use_(use) {}

void TurntablePositioner::open(const Progress& progress) {
  table_->open(progress);
  if (where_) return;
  const auto now = table_->angle();
  offset_ = (now ? now->degrees : 0.0) - tableAngleOf(*profile_, use_.standsAt, 0.0);
}

ReachedPose TurntablePositioner::moveTo(int position, const Progress& progress) {
  const Pose& nominal = workspacePose(*this, profile_->workspace, position);
  const auto before = table_->angle();
  const double here = before ? before->degrees : offset_;
  double commanded = tableAngleOf(*profile_, position, here - offset_) + offset_;
  if (use_.alwaysMoves && std::abs(commanded - here) < kNoMove)
    commanded += (here > offset_ ? -1.0 : 1.0) * 360.0 * std::abs(countPerDegree(*profile_));
  where_.reset();
  table_->headFor(position);
  const TableAngle reached = table_->turnTo(commanded, progress);
  // The scanner goes round the object the other way than the table turns.
  const double off = radians((reached.degrees - commanded) / countPerDegree(*profile_));
  const Pose turned = Eigen::AngleAxisd(-off, Vec3::UnitZ()) * nominal;
  where_ = {position, off == 0.0 ? nominal : turned, reached.knownBy, {}};
  return *where_;
}

}  // namespace vantage
