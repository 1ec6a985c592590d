#include "devices/serial/table_dialog.h"

#include <algorithm>

#include "scanner/profile_reader.h"

namespace vantage {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kSlice{20};
constexpr milliseconds kBeat{1000};
constexpr milliseconds kTalking{2000};
// Before an answer is asked for again: at once obeyed, or in turn.
constexpr milliseconds kImmediateAnswer{300}, kQueuedAnswer{1500};

// The first group that has a part in the match.
std::string codeOf(const MessagePattern& pattern, const std::string& text) {
  const auto groups = pattern.groups(text);
  return groups && !groups->empty() ? groups->front() : std::string();
}

bool matches(const std::optional<MessagePattern>& pattern, const std::string& text) {
  return pattern && pattern->matches(text);
}

}  // namespace

TableDialog::TableDialog(SerialLine& line, const TableProfile& profile)
    : line_(line),
      profile_(profile),
      stream_(profile.messageEnds, profile.prompt, profile.heartbeat),
      reader_(profile),
      heard_(Clock::now()) {}

void TableDialog::send(const std::string& command) {
  acknowledged_ = false;
  sent_ = command;
  line_.write(command + profile_.lineEnd);
}

TableMessage TableDialog::classify(const std::string& text) {
  if (matches(profile_.greeting, text)) return {MessageKind::Greeting, text, {}};
  if (matches(profile_.alarm, text)) return {MessageKind::Alarm, text, codeOf(*profile_.alarm, text)};
  if (profile_.echo && text == sent_) return {MessageKind::Echo, text, {}};
  if (profile_.status) {
    if (auto report = reader_.read(text)) {
      report_ = std::move(report);
      return {MessageKind::Status, text, {}};
    }
  }
  if (matches(profile_.done, text)) return {MessageKind::Done, text, {}};
  if (matches(profile_.ok, text)) return {MessageKind::Ok, text, {}};
  if (matches(profile_.error, text)) return {MessageKind::Error, text, codeOf(*profile_.error, text)};
  return {MessageKind::Other, text, {}};
}

std::string TableDialog::meaning(const std::string& kind, const std::string& code) const {
  std::string text = kind + ":" + code;
  const auto known = profile_.meanings.find(text);
  if (code.find_first_not_of("0123456789") != std::string::npos) text = kind + ": " + shownText(code);
  return known == profile_.meanings.end() ? text : text + ": " + known->second;
}

void TableDialog::handle(const TableMessage& message) {
  switch (message.kind) {
    case MessageKind::Greeting:
      greeted_ = true;
      reader_.forget();
      if (!restartExpected_) throw PositionLost("has restarted by itself, so that where it stands is not known");
      break;
    case MessageKind::Alarm:
      if (!restartExpected_)
        throw PositionLost("raised an alarm (" + meaning("alarm", message.code) +
                           "), so that where it stands is not known");
      break;
    case MessageKind::Ok:
      acknowledged_ = true;
      break;
    case MessageKind::Error:
      error_ = meaning("error", message.code);
      break;
    default:
      break;
  }
}

void TableDialog::beat() {
  if (profile_.heartbeat.empty() || Clock::now() - beaten_ < kBeat) return;
  beaten_ = Clock::now();
  line_.write(profile_.heartbeat);
}

std::optional<TableMessage> TableDialog::next(milliseconds patience, const Pulse& pulse) {
  const auto end = Clock::now() + patience;
  for (;;) {
    pulse();
    if (const auto text = stream_.next(Clock::now())) {
      last_ = *text;
      TableMessage message = classify(*text);
      handle(message);
      return message;
    }
    const auto left = std::chrono::duration_cast<milliseconds>(end - Clock::now());
    if (left.count() < 0) return std::nullopt;
    beat();
    const std::string bytes = line_.read(std::min(kSlice, left));
    if (bytes.empty()) continue;
    heard_ = Clock::now();
    stream_.feed(bytes, heard_);
  }
}

std::optional<TableMessage> TableDialog::command(const std::string& command, milliseconds patience,
                                                 const Pulse& pulse) {
  error_.reset();
  send(command);
  const auto end = Clock::now() + patience;
  while (Clock::now() < end) {
    const auto message = next(std::chrono::duration_cast<milliseconds>(end - Clock::now()), pulse);
    if (!message) break;
    if (message->kind == MessageKind::Ok || message->kind == MessageKind::Done || message->kind == MessageKind::Error)
      return message;
  }
  return std::nullopt;
}

std::optional<StatusReport> TableDialog::askStatus(milliseconds patience, const Pulse& pulse) {
  const StatusProfile& status = *profile_.status;
  const milliseconds again = status.immediate ? kImmediateAnswer : kQueuedAnswer;
  const auto end = Clock::now() + patience;
  report_.reset();
  while (Clock::now() < end) {
    line_.write(status.immediate ? status.ask : status.ask + profile_.lineEnd);
    // While bytes come, however slowly, an answer is on its way.
    const auto asked = Clock::now();
    while (Clock::now() < std::min(end, std::max(asked, heard_) + again)) {
      const auto message = next(kSlice, pulse);
      if (message && message->kind == MessageKind::Status) return report_;
    }
  }
  return std::nullopt;
}

void TableDialog::drain(milliseconds quiet, const Pulse& pulse) {
  // A board that talks without end is asked nevertheless.
  const auto end = Clock::now() + kTalking;
  while (Clock::now() < end && next(quiet, pulse)) {
  }
  error_.reset();
}

std::string TableDialog::lastHeard() const {
  return last_.empty() ? "nothing" : shownText(last_);
}

}  // namespace vantage
