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
    : profile_(std::move(profile)), table_(std::move(table)), use_(use), farther_(use.stands.farther) {}

void TurntablePositioner::open(const Progress& progress) {
  table_->open(progress);
  if (where_) return;
  // One that does not know where it stands is told angles from position 0, whoever turned it before.
  const auto now = table_->angle();
  const TableStand& stands = use_.stands;
  offset_ = now ? now->degrees - tableAngleOf(*profile_, stands.position, 0.0) +
                      countPerDegree(*profile_) * degrees(stands.counted)
                : 0.0;
}

ReachedPose TurntablePositioner::moveTo(int position, const Progress& progress) {
  static_cast<void>(workspacePose(*this, profile_->workspace, position));
  const auto before = table_->angle();
  const double here = before ? before->degrees : offset_;
  const double count = countPerDegree(*profile_);
  const double offset = offset_ + count * degrees(farther_);
  double commanded = tableAngleOf(*profile_, position, here - offset) + offset;
  if (use_.alwaysMoves && std::abs(commanded - here) < kNoMove)
    commanded += (here > offset ? -1.0 : 1.0) * 360.0 * std::abs(count);
  where_.reset();
  table_->headFor(position);
  const TableAngle reached = table_->turnTo(commanded, progress);
  const double beyond = (reached.degrees - commanded) / count;
  where_ = poseAt(position, beyond, reached.knownBy);
  where_->movedUntil = reached.turnedUntil;
  return *where_;
}

// The pose of a table that counts so many degrees beyond a position.
ReachedPose TurntablePositioner::poseAt(int position, double beyond, PoseSource knownBy) const {
  const Pose& nominal = profile_->workspace.poses[static_cast<std::size_t>(position)];
  // The scanner goes round the object the other way than the table turns.
  const double off = radians(beyond) + farther_;
  const Pose turned = Eigen::AngleAxisd(-off, Vec3::UnitZ()) * nominal;
  return {position, off == 0.0 ? nominal : turned, knownBy, {}};
}

std::optional<ReachedPose> TurntablePositioner::where() const {
  if (where_) return where_;
  const auto now = table_->angle();
  if (!now) return std::nullopt;
  const double count = countPerDegree(*profile_);
  const double angle = now->degrees - offset_ - count * degrees(farther_);
  const auto beyond = [&](int position) { return (angle - tableAngleOf(*profile_, position, angle)) / count; };
  int nearest = 0;
  for (int i = 1; i < static_cast<int>(profile_->workspace.size()); ++i)
    if (std::abs(beyond(i)) < std::abs(beyond(nearest))) nearest = i;
  return poseAt(nearest, beyond(nearest), now->knownBy);
}

}  // namespace vantage
