#include "devices/serial/serial_turntable.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/plain_text.h"
#include "devices/serial/table_recognition.h"
#include "scanner/profile_reader.h"

namespace vantage {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

// How long who stops the table waits for its rest; what is left is done before the next move.
constexpr milliseconds kStopping{350};
constexpr seconds kAnswer{3};
constexpr const char* kNewReference = "; turn it to where it shall count from, then set the reference anew (home)";

}  // namespace

SerialTurntable::SerialTurntable(std::unique_ptr<SerialLine> line, std::vector<TableProfile> profiles)
    : line_(std::move(line)), profiles_(std::move(profiles)) {
  if (profiles_.empty()) throw InvalidInput("a turntable on " + line_->name() + " needs a profile");
  profile_ = &profiles_.front();
  known_.identity = (profiles_.size() == 1 ? profile_->title + " turntable on " : "turntable on ") + line_->name();
}

SerialTurntable::~SerialTurntable() {
  close();
}

// --- what is known ------------------------------------------------------------------------------------------------

std::string SerialTurntable::identity() const {
  const std::lock_guard lock(mutex_);
  return known_.identity;
}

std::string SerialTurntable::protocol() const {
  const std::lock_guard lock(mutex_);
  return known_.protocol;
}

std::string SerialTurntable::title() const {
  const std::lock_guard lock(mutex_);
  return known_.title;
}

std::optional<std::string> SerialTurntable::notReady() const {
  const std::lock_guard lock(mutex_);
  if (known_.state == TableState::Closed) return known_.lost.value_or("is not connected");
  if (known_.lost) return *known_.lost + kNewReference;
  return std::nullopt;
}

TableStatus SerialTurntable::status() const {
  const std::lock_guard lock(mutex_);
  TableStatus status{known_.state, {}};
  if (known_.position && !known_.lost && known_.state != TableState::Closed) status.angle = angleAt(*known_.position);
  return status;
}

void SerialTurntable::know(TableState state, std::optional<double> position) {
  const std::lock_guard lock(mutex_);
  known_.state = state;
  known_.position = position;
}

void SerialTurntable::lose(const std::string& why) {
  const std::lock_guard lock(mutex_);
  known_.lost = why;
  if (!line_->isOpen()) known_.state = TableState::Closed;
}

TableAngle SerialTurntable::angleAt(double units) const {
  return {profile_->sense * (units - origin_) * 360.0 / profile_->unitsPerTurn,
          profile_->status ? PoseSource::Reported : PoseSource::Commanded};
}

double SerialTurntable::unitsOf(double degrees) const {
  return profile_->sense * degrees * profile_->unitsPerTurn / 360.0;
}

// --- what every operation does ------------------------------------------------------------------------------------

TableDialog::Pulse SerialTurntable::pulseOf(const Progress& progress) const {
  return [this, &progress] {
    progress.checkpoint(0.0);
    if (stopAsked_) throw Cancelled();
  };
}

// Does work and leaves the table in a state that is known, or known to be lost, whatever becomes of it.
void SerialTurntable::guarded(const Progress& progress, const std::function<void(const TableDialog::Pulse&)>& work) {
  stopAsked_ = false;
  const TableDialog::Pulse pulse = pulseOf(progress);
  dialog_->expectRestart(false);
  try {
    work(pulse);
  } catch (const Cancelled&) {
    afterCancel();
    throw;
  } catch (const PositionLost& e) {
    afterLoss(e.what(), pulse);
    throw DeviceError(identity() + " " + e.what() + kNewReference);
  } catch (const DeviceError& e) {
    if (!line_->isOpen()) {
      lose("was unplugged or switched off; plug it in and connect again");
      throw;
    }
    afterRefusal(pulse);
    throw DeviceError(identity() + " " + e.what());
  }
}

void SerialTurntable::afterCancel() noexcept {
  try {
    const TableState before = status().state;
    if (before == TableState::Homing) {
      // Nothing but a reset ends that.
      lose("was stopped while it looked for its index");
      static_cast<void>(motion_->reset(kStopping, [] {}));
      return know(TableState::Unknown, std::nullopt);
    }
    if (before != TableState::Moving) return;
    if (leftAlone_ && profile_->longestMove) return afterShortMove();
    const auto rest = motion_->stop(kStopping, [] {});
    if (rest) return know(TableState::Idle, rest);
    know(TableState::Unknown, std::nullopt);
    if (profile_->status) {
      stopping_ = true;
    } else if (!profile_->stopCommand.empty()) {
      leftAlone_.reset();
      lose("was stopped in a move and does not tell where it stands");
    }
  } catch (const std::exception& e) {
    lose(e.what());
  }
}

// What cannot be stopped ends where it was told to, also when nobody waits for it.
void SerialTurntable::afterShortMove() {
  const double end = *leftAlone_;
  if (motion_->awaitEnd(kStopping, [] {})) leftAlone_.reset();
  know(leftAlone_ ? TableState::Unknown : TableState::Idle, end);
}

void SerialTurntable::afterLoss(const std::string& why, const TableDialog::Pulse& pulse) noexcept {
  lose(why);
  leftAlone_.reset();
  try {
    static_cast<void>(motion_->stop(seconds(2), pulse));
    know(TableState::Unknown, std::nullopt);
  } catch (const std::exception&) {
    know(line_->isOpen() ? TableState::Unknown : TableState::Closed, std::nullopt);
  }
}

// The table refused, or was halted: it stands where it says.
void SerialTurntable::afterRefusal(const TableDialog::Pulse& pulse) noexcept {
  if (status().state != TableState::Moving) return;
  try {
    std::optional<double> before;
    {
      const std::lock_guard lock(mutex_);
      before = known_.position;
    }
    leftAlone_.reset();
    if (!profile_->status) return know(TableState::Idle, before);
    stopping_ = true;
    const auto rest = motion_->stop(seconds(2), pulse);
    stopping_ = !rest;
    know(rest ? TableState::Idle : TableState::Unknown, rest);
  } catch (const Cancelled&) {
    know(TableState::Unknown, std::nullopt);
  } catch (const std::exception& e) {
    lose(e.what());
  }
}

void SerialTurntable::needOpen() const {
  if (line_->isOpen()) return;
  throw DeviceError(plainText(line_->name()) + ": the turntable is not connected; connect it first");
}

void SerialTurntable::needPosition() const {
  const std::lock_guard lock(mutex_);
  if (known_.lost) throw DeviceError(known_.identity + " " + *known_.lost + kNewReference);
}

StatusReport SerialTurntable::report(const TableDialog::Pulse& pulse) {
  for (int time = 0; time < 40; ++time) {
    const auto report = dialog_->askStatus(kAnswer, pulse);
    if (!report) throw DeviceError("does not answer; the last that came was " + dialog_->lastHeard());
    // Boards that only tell work coordinates tell their offset now and then.
    if (report->position || report->state == TableState::Alarm) return *report;
  }
  throw DeviceError("reports no position that is understood, but " + dialog_->lastHeard() +
                    "; choose another protocol, or let the board report machine positions ($10=1)");
}

// Goes on with a stop that was not waited for, and with a move that cannot be stopped.
void SerialTurntable::finishStop(const TableDialog::Pulse& pulse) {
  if (stopping_) {
    const auto rest = motion_->stop(seconds(10), pulse);
    stopping_ = false;
    if (!rest) throw PositionLost("was stopped and did not say where it came to rest");
    know(TableState::Idle, rest);
  }
  if (leftAlone_) {
    const double end = *std::exchange(leftAlone_, std::nullopt);
    const bool ended = motion_->awaitEnd(motion_->longestMove(end - origin_), pulse);
    if (!ended) throw PositionLost("has not said that its last move is over");
    know(TableState::Idle, end);
  }
}

// Nobody else has turned or restarted it since.
void SerialTurntable::checkStillThere(const TableDialog::Pulse& pulse) {
  dialog_->drain(milliseconds(20), pulse);
  if (!profile_->status) return;
  const StatusReport now = report(pulse);
  if (now.state == TableState::Alarm) throw PositionLost("is locked by an alarm, so that where it stands is not known");
  const auto before = status().angle;
  if (!now.position || !before) return;
  const double off = std::abs(angleAt(*now.position).degrees - before->degrees);
  if (off > 2.0 * profile_->tolerance)
    throw PositionLost("stands elsewhere than after its last move: it was turned by somebody else, or has restarted");
}

void SerialTurntable::turn(double units, const Progress& progress) {
  if (!known_.position) throw PositionLost("does not say where it stands");
  const double from = *known_.position;
  const double to = motion_->rounded(units);
  if (!profile_->status && to == from) return know(TableState::Idle, from);
  double here = from;
  const auto watch = [&](double fraction, const std::optional<double>& position) {
    if (position) know(TableState::Moving, position);
    progress.checkpoint(profile_->status ? fraction : std::abs((here - from) / (to - from)));
    if (stopAsked_) throw Cancelled();
  };
  do {
    const double end = motion_->nextEnd(here, to);
    know(TableState::Moving, here);
    if (!profile_->status) leftAlone_ = end;
    here = motion_->move(here, end, watch);
    leftAlone_.reset();
    know(TableState::Idle, here);
    if (profile_->status) return;
    watch(0.0, {});
  } while (here != to);
  motion_->settle(pulseOf(progress));
}

TableAngle SerialTurntable::turnTo(double degrees, const Progress& progress) {
  if (!std::isfinite(degrees)) throw InvalidInput(identity() + " can only turn to an angle that is a number");
  needOpen();
  needPosition();
  guarded(progress, [&](const TableDialog::Pulse& pulse) {
    finishStop(pulse);
    checkStillThere(pulse);
    turn(origin_ + unitsOf(degrees), progress);
  });
  TableAngle reached = angleAt(*known_.position);
  reached.turnedUntil = motion_->turnedUntil();
  return reached;
}

std::optional<TableAngle> SerialTurntable::jog(double degrees, const Progress& progress) {
  if (!std::isfinite(degrees)) throw InvalidInput(identity() + " can only turn by an angle that is a number");
  needOpen();
  guarded(progress, [&](const TableDialog::Pulse& pulse) {
    finishStop(pulse);
    if (notReady() || !known_.position) makeReady(pulse);
    turn(known_.position.value_or(0.0) + unitsOf(degrees), progress);
  });
  return angle();
}

TableStatus SerialTurntable::askStatus(const Progress& progress) {
  needOpen();
  guarded(progress, [&](const TableDialog::Pulse& pulse) {
    finishStop(pulse);
    dialog_->drain(milliseconds(20), pulse);
    if (!profile_->status) return;
    const StatusReport now = report(pulse);
    know(now.state == TableState::Unknown ? TableState::Idle : now.state, now.position);
    if (now.state == TableState::Alarm) lose("is locked by an alarm, so that where it stands is not known");
  });
  return status();
}

void SerialTurntable::close() noexcept {
  try {
    if (line_->isOpen() && dialog_) {
      if (stopping_ || status().state == TableState::Moving) static_cast<void>(motion_->stop(kStopping, [] {}));
      if (!profile_->motorOff.empty()) dialog_->send(profile_->motorOff);
    }
  } catch (const std::exception&) {
    // It is left as it is: nobody is there any more to tell.
  }
  line_->close();
  stopping_ = false;
  leftAlone_.reset();
  know(TableState::Closed, std::nullopt);
}

}  // namespace vantage
