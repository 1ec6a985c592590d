// How a turntable on a serial line is connected, made ready and given a reference.
#include <algorithm>
#include <set>

#include "base/plain_text.h"
#include "devices/serial/serial_turntable.h"
#include "devices/serial/table_recognition.h"
#include "scanner/profile_reader.h"

namespace vantage {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr seconds kAnswer{3}, kRest{120}, kIndex{120};

// Speeds to try: what each profile names first, then the others.
std::vector<int> speedsOf(const std::vector<TableProfile>& profiles) {
  std::vector<int> speeds;
  for (std::size_t rank = 0; rank < 8; ++rank)
    for (const TableProfile& profile : profiles)
      if (rank < profile.baud.size() && std::find(speeds.begin(), speeds.end(), profile.baud[rank]) == speeds.end())
        speeds.push_back(profile.baud[rank]);
  return speeds;
}

std::string titlesOf(const std::vector<TableProfile>& profiles) {
  std::string titles;
  for (std::size_t i = 0; i < profiles.size(); ++i)
    titles += (i == 0 ? "" : i + 1 == profiles.size() ? " or " : ", ") + profiles[i].title;
  return titles;
}

std::string noAnswer(const std::string& port, const std::vector<TableProfile>& profiles, const std::string& heard) {
  std::string text = plainText(port) + ": ";
  if (heard.empty())
    return text + "nothing answers there as " + titlesOf(profiles) +
           "; see that the table is switched on, and that it is this port";
  return text + "what is there does not answer as " + titlesOf(profiles) + "; it sends " + shownText(heard) +
         ": choose another protocol or port";
}

}  // namespace

void SerialTurntable::open(const Progress& progress) {
  if (line_->isOpen()) return;
  stopAsked_ = false;
  const TableDialog::Pulse pulse = pulseOf(progress);
  try {
    connect(pulse);
    beginTalking(pulse);
  } catch (const Cancelled&) {
    line_->close();
    throw;
  } catch (const DeviceError& e) {
    const bool talking = line_->isOpen() && dialog_ != nullptr;
    line_->close();
    if (talking) throw DeviceError(identity() + " " + e.what());
    throw;
  }
}

void SerialTurntable::connect(const TableDialog::Pulse& pulse) {
  dialog_.reset();
  motion_.reset();
  std::string heard;
  for (const int baud : speedsOf(profiles_)) {
    line_->open(baud);
    const Recognition found = recognise(*line_, profiles_, pulse);
    if (heard.empty()) heard = found.heard;
    if (!found.profile) continue;
    const std::lock_guard lock(mutex_);
    profile_ = &profiles_[*found.profile];
    known_.identity = profile_->title + " turntable on " + plainText(line_->name());
    known_.protocol = profile_->name;
    known_.title = profile_->title;
    return;
  }
  throw DeviceError(noAnswer(line_->name(), profiles_, heard));
}

void SerialTurntable::beginTalking(const TableDialog::Pulse& pulse) {
  dialog_ = std::make_unique<TableDialog>(*line_, *profile_);
  motion_ = std::make_unique<TableMotion>(*dialog_, *profile_);
  stopping_ = false;
  leftAlone_.reset();
  makeReady(pulse);
  countFromHere(pulse);
}

// Some boards speak of lengths in inches, or have an index.
void SerialTurntable::readSettings(const TableDialog::Pulse& pulse) {
  if (!profile_->settings) return;
  const BoardSettings& settings = *profile_->settings;
  dialog_->send(settings.ask);
  const auto end = TableDialog::Clock::now() + seconds(10);
  while (TableDialog::Clock::now() < end) {
    const auto message = dialog_->next(milliseconds(500), pulse);
    if (!message && !dialog_->heardWithin(milliseconds(1500))) break;
    if (message && (message->kind == MessageKind::Ok || message->kind == MessageKind::Error)) break;
    const auto groups = message ? settings.pattern.groups(message->text) : std::nullopt;
    if (!groups || groups->size() < 2) continue;
    const bool on = (*groups)[1].find_first_of("123456789") != std::string::npos;
    if ((*groups)[0] == settings.inches) dialog_->reader().setInches(on);
    if ((*groups)[0] == settings.homing) hasIndex_ = on;
  }
}

void SerialTurntable::unlock(StatusReport& report, const TableDialog::Pulse& pulse) {
  if (report.state == TableState::Alarm && !profile_->unlock.empty()) {
    static_cast<void>(dialog_->command(profile_->unlock, kAnswer, pulse));
    report = this->report(pulse);
  }
}

// Whatever state it was left in: at rest, unlocked, told how to count.
void SerialTurntable::makeReady(const TableDialog::Pulse& pulse) {
  dialog_->expectRestart(true);
  // What does not say whether it turns is given time to come to rest.
  dialog_->drain(profile_->status || !notReady() ? milliseconds(50) : seconds(1), pulse);
  if (profile_->status) {
    auto first = dialog_->askStatus(kAnswer, pulse);
    const auto isLocked = [](TableState state) {
      return state == TableState::Held || state == TableState::Door || state == TableState::Check ||
             state == TableState::Sleep;
    };
    if (!first || isLocked(first->state)) static_cast<void>(motion_->reset(kAnswer, pulse));
    StatusReport now = report(pulse);
    unlock(now, pulse);
    const auto end = TableDialog::Clock::now() + kRest;
    while ((now.state == TableState::Moving || now.state == TableState::Homing) && TableDialog::Clock::now() < end)
      now = report(pulse);
    if (isLocked(now.state) || now.state == TableState::Alarm || now.state == TableState::Moving)
      throw DeviceError("cannot be made ready (state " + now.word +
                        "); close its door, release its emergency stop, or switch it off and on, then connect again");
    readSettings(pulse);
  }
  for (const std::string& command : profile_->begin) {
    const auto answer = dialog_->command(command, kAnswer, pulse);
    if (!answer && !dialog_->heardWithin(kAnswer)) throw DeviceError("does not answer to " + command);
  }
  dialog_->drain(milliseconds(50), pulse);
  dialog_->expectRestart(false);
  know(TableState::Idle, profile_->status ? report(pulse).position : known_.position.value_or(0.0));
}

void SerialTurntable::countFromHere(const TableDialog::Pulse& pulse) {
  const double here = profile_->status ? report(pulse).position.value_or(0.0) : 0.0;
  origin_ = here;
  const std::lock_guard lock(mutex_);
  known_.state = TableState::Idle;
  known_.position = here;
  known_.lost.reset();
}

void SerialTurntable::findIndex(const TableDialog::Pulse& pulse) {
  if (profile_->index.empty() || !hasIndex_) return;
  know(TableState::Homing, std::nullopt);
  const auto answer = dialog_->command(profile_->index, kIndex, pulse);
  if (!answer) throw PositionLost("has not found its index within 120 s; see its switch");
  if (answer->kind == MessageKind::Error)
    throw DeviceError("refused to look for its index (" + dialog_->takeError().value_or(answer->text) + ")");
}

void SerialTurntable::home(const Progress& progress) {
  needOpen();
  guarded(progress, [&](const TableDialog::Pulse& pulse) {
    try {
      finishStop(pulse);
    } catch (const PositionLost&) {
      // A new reference is what is asked for.
    }
    makeReady(pulse);
    findIndex(pulse);
    countFromHere(pulse);
  });
}

}  // namespace vantage
