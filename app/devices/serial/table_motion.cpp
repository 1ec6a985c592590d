#include "devices/serial/table_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vantage {
namespace {

using std::chrono::milliseconds;
using Clock = TableDialog::Clock;

constexpr milliseconds kPoll{100};
// A board that says nothing for so long is given up.
constexpr milliseconds kSilence{8000};
// A table that turns, but comes no nearer for so long, is stuck.
constexpr milliseconds kStuck{5000};
// A table that rests elsewhere for so long has not been moved, or not as far.
constexpr milliseconds kElsewhere{2000};
// Reports of rest at the place, the last of them after the object has settled.
constexpr int kReportsOfRest = 3;
constexpr milliseconds kEcho{3000};

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value == 0.0 ? 0.0 : value);
  return text;
}

void fill(std::string& text, const std::string& place, const std::string& value) {
  for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + value.size()))
    text.replace(at, place.size(), value);
}

std::string degreesText(double degrees) {
  return fixed(degrees, 1) + " degrees";
}

}  // namespace

// A move on its way.
struct TableMotion::Course {
  double from, to;
  const Watch& watch;
  Clock::time_point start = Clock::now(), gained = Clock::now();
  double nearest;
  std::optional<double> position, count;
  std::chrono::system_clock::time_point asked = std::chrono::system_clock::now();
  int rests = 0;
  bool moved = false, sentAgain = false, atEnd = false;

  Course(double begin, double end, const Watch& watcher)
      : from(begin), to(end), watch(watcher), nearest(std::abs(end - begin)) {}

  [[nodiscard]] double fraction() const {
    const double whole = std::abs(to - from);
    return position && whole > 0.0 ? std::clamp(1.0 - std::abs(to - *position) / whole, 0.0, 1.0) : 0.0;
  }
  [[nodiscard]] TableDialog::Pulse pulse() const {
    return [this] { watch(fraction(), position); };
  }
  [[nodiscard]] bool gainedWithin(milliseconds time) const { return Clock::now() - gained < time; }

  // Takes down a report. @return whether the motor stood since the one before
  bool note(const StatusReport& report) {
    const bool same = report.count && count && *report.count == *count;
    if (report.count && count && !same) moved = true, gained = Clock::now();
    count = report.count;
    if (!report.position) return same;
    position = report.position;
    if (const double left = std::abs(to - *position); left < nearest) {
      nearest = left;
      gained = Clock::now();
      moved = true;
    }
    return same;
  }
};

double TableMotion::rounded(double units) const {
  const double fine = std::pow(10.0, profile_.move.decimals);
  return std::round(units * fine) / fine;
}

milliseconds TableMotion::longestMove(double units) const {
  return milliseconds(5000 + std::llround(1000.0 * std::abs(degreesOf(units)) / profile_.slowest));
}

std::string TableMotion::command(double from, double to) const {
  const MoveProfile& move = profile_.move;
  std::string text = move.send;
  const double feed = profile_.speed * profile_.unitsPerTurn / 360.0 * move.feedSeconds;
  fill(text, "{axis}", profile_.axis);
  fill(text, "{units}", fixed(to, move.decimals));
  fill(text, "{delta}", fixed(to - from, move.decimals));
  fill(text, "{direction}", to > from ? "1" : "0");
  fill(text, "{magnitude}", fixed(std::abs(to - from), move.decimals));
  fill(text, "{feed}", fixed(feed, 1));
  return text;
}

void TableMotion::pause(milliseconds time, const TableDialog::Pulse& pulse) {
  const auto end = Clock::now() + time;
  while (Clock::now() < end)
    static_cast<void>(dialog_.next(std::chrono::ceil<milliseconds>(end - Clock::now()), pulse));
}

double TableMotion::move(double from, double to, const Watch& watch) {
  turnedUntil_.reset();
  Course course(from, to, watch);
  return profile_.status ? moveReported(course) : moveBlind(course);
}

// A report of rest that is not at the place.
void TableMotion::checkRest(Course& course, const StatusReport& report) {
  course.rests = 0;
  if (course.gainedWithin(kElsewhere)) return;
  if (!course.moved && !course.sentAgain && !dialog_.acknowledged() && !profile_.move.relative) {
    // The command was lost on the way. It tells the place, so that it may come twice.
    course.sentAgain = true;
    course.gained = Clock::now();
    dialog_.send(command(course.from, course.to));
    return;
  }
  if (!report.position) throw PositionLost("does not say where it stands");
  throw PositionLost("stopped " + degreesText(degreesOf(std::abs(course.to - *report.position))) +
                     " away from where it was told to go" + (course.moved ? "" : " and has not moved at all") +
                     ", so that where it stands is not to be trusted");
}

bool TableMotion::arrived(Course& course, const StatusReport& report) {
  const auto gained = course.gained;
  const bool motorStood = course.note(report);
  // It was not there yet when it was asked the time before.
  if (course.gained != gained) turnedUntil_ = course.asked;
  course.asked = std::chrono::system_clock::now();
  const double tolerance = profile_.tolerance * profile_.unitsPerTurn / 360.0;
  const bool there = report.position && std::abs(*report.position - course.to) <= tolerance;
  switch (report.state) {
    case TableState::Alarm:
      throw PositionLost("is locked by an alarm, so that where it stands is not known");
    case TableState::Door:
      throw DeviceError("has stopped because its safety door is open; close the door and turn again");
    case TableState::Held:
      throw DeviceError("was halted at the table itself (state " + report.word + "); turn again to go on");
    case TableState::Check:
      throw DeviceError("only checks commands (state " + report.word +
                        "); leave that mode with $C, or reset the board");
    case TableState::Sleep:
      throw PositionLost("has switched off its motor (state " + report.word + ")");
    case TableState::Moving:
    case TableState::Homing:
      course.rests = 0;
      break;
    default:
      if (profile_.status->state || motorStood) {
        if (there) return ++course.rests >= kReportsOfRest;
        checkRest(course, report);
        return false;
      }
      course.rests = 0;
  }
  if (!course.gainedWithin(kStuck))
    throw PositionLost("is stuck: it says that it turns, but has come no nearer for 5 s; see what blocks it");
  return false;
}

double TableMotion::moveReported(Course& course) {
  const StatusProfile& status = *profile_.status;
  const auto pulse = course.pulse();
  dialog_.send(command(course.from, course.to));
  for (;;) {
    const auto report = dialog_.askStatus(course.atEnd ? kStuck : kSilence, pulse);
    if (const auto error = dialog_.takeError()) throw DeviceError("refused to turn (" + *error + ")");
    if (!report)
      throw PositionLost(course.atEnd ? "is stuck: its move is not over after 5 s without motion; see what blocks it"
                                      : "has not answered for 8 s, so that where it stands is not known");
    if (arrived(course, *report)) return *report->position;
    if (course.rests == 1 && !status.wait.empty() && !course.atEnd) {
      // What is asked from now on is answered when the move is over.
      dialog_.drain(milliseconds(50), pulse);
      dialog_.send(status.wait);
      course.atEnd = true;
      course.rests = 0;
      continue;
    }
    pause(course.rests == kReportsOfRest - 1 ? profile_.settle : kPoll, pulse);
  }
}

double TableMotion::moveBlind(Course& course) {
  if (course.to == course.from) return course.to;
  const auto pulse = course.pulse();
  course.start = Clock::now();
  const milliseconds longest = longestMove(course.to - course.from);
  bool echoed = !profile_.echo;
  dialog_.send(command(course.from, course.to));
  while (Clock::now() - course.start < longest) {
    const auto message = dialog_.next(kPoll, pulse);
    if (const auto error = dialog_.takeError()) throw DeviceError("refused to turn (" + *error + ")");
    if (message && message->kind == MessageKind::Echo) echoed = true;
    if (message && message->kind == MessageKind::Done && echoed) {
      const auto took = std::chrono::duration<double>(dialog_.heardAt() - course.start).count();
      if (took * profile_.fastest < std::abs(degreesOf(course.to - course.from)))
        throw PositionLost("says that it has arrived sooner than it can turn, so that where it stands is not known");
      return course.to;
    }
    if (!echoed && Clock::now() - course.start > kEcho)
      throw PositionLost("has not repeated the command to turn, so that it is not known whether it turned");
    if (!profile_.heartbeat.empty() && !dialog_.heardWithin(kSilence))
      throw PositionLost("has not answered for 8 s, so that where it stands is not known");
  }
  throw PositionLost("has not said within " + fixed(static_cast<double>(longest.count()) / 1000.0, 0) +
                     " s that it has arrived, so that where it stands is not known; it may be stuck or have restarted");
}

double TableMotion::nextEnd(double from, double to) const {
  if (profile_.status || !profile_.longestMove) return to;
  const double finest = std::pow(10.0, -profile_.move.decimals);
  const double longest = std::max(finest, rounded(*profile_.longestMove * profile_.unitsPerTurn / 360.0));
  return std::abs(to - from) <= longest ? to : rounded(from + std::copysign(longest, to - from));
}

bool TableMotion::awaitEnd(milliseconds patience, const TableDialog::Pulse& pulse) {
  const auto end = Clock::now() + patience;
  while (Clock::now() < end)
    if (const auto message = dialog_.next(kPoll, pulse); message && message->kind == MessageKind::Done) return true;
  return false;
}

std::optional<double> TableMotion::awaitRest(milliseconds patience, const TableDialog::Pulse& pulse) {
  const auto end = Clock::now() + patience;
  std::optional<StatusReport> before;
  while (Clock::now() < end) {
    auto now = dialog_.askStatus(std::chrono::ceil<milliseconds>(end - Clock::now()), pulse);
    if (!now) return std::nullopt;
    const bool turning = now->state == TableState::Moving || now->state == TableState::Homing;
    if (before && !turning && now->position && now->position == before->position && now->count == before->count)
      return now->position;
    before = std::move(now);
    pause(std::min(milliseconds(60), std::chrono::ceil<milliseconds>(end - Clock::now())), pulse);
  }
  return std::nullopt;
}

bool TableMotion::reset(milliseconds patience, const TableDialog::Pulse& pulse) {
  if (profile_.stopReset.empty()) return true;
  bool calm = true;
  dialog_.expectRestart(true);
  dialog_.forgetGreeting();
  dialog_.sendByte(profile_.stopReset);
  const auto end = Clock::now() + patience;
  while (!dialog_.greeted() && Clock::now() < end) {
    const auto message = dialog_.next(kPoll, pulse);
    if (message && message->kind == MessageKind::Alarm) calm = false;
  }
  dialog_.drain(milliseconds(50), pulse);
  dialog_.expectRestart(false);
  return calm && dialog_.greeted();
}

std::optional<double> TableMotion::stop(milliseconds patience, const TableDialog::Pulse& pulse) {
  if (!profile_.stopCommand.empty()) dialog_.send(profile_.stopCommand);
  if (!profile_.stopHold.empty()) dialog_.sendByte(profile_.stopHold);
  if (!profile_.status) return std::nullopt;
  const auto end = Clock::now() + patience;
  const auto rest = awaitRest(patience, pulse);
  if (!rest || profile_.stopReset.empty()) return rest;
  const auto left = std::max(milliseconds(100), std::chrono::ceil<milliseconds>(end - Clock::now()));
  return reset(left, pulse) ? rest : std::nullopt;
}

}  // namespace vantage
