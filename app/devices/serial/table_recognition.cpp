#include "devices/serial/table_recognition.h"

#include <algorithm>
#include <numeric>

#include "devices/serial/message_stream.h"

namespace vantage {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr milliseconds kSlice{50};
// After a greeting more follows at once: locks, start-up lines.
constexpr milliseconds kQuiet{300}, kTalking{3000};
// What one question is given: as many times as it may be lost.
constexpr milliseconds kAnswer{1000};
constexpr int kTimes = 2;
constexpr std::size_t kKept = 200;

// The line as several firmwares would understand it.
class Listener {
 public:
  Listener(SerialLine& line, const std::vector<TableProfile>& profiles, const TableDialog::Pulse& pulse)
      : line_(line), profiles_(profiles), pulse_(pulse) {}

  // The one whose greeting comes, or whose heart beats.
  std::optional<std::size_t> greeting() {
    milliseconds longest{0};
    for (const TableProfile& profile : profiles_) longest = std::max(longest, profile.greetingWait);
    std::vector<MessageStream> streams;
    for (const TableProfile& p : profiles_) streams.emplace_back(p.messageEnds, p.prompt, p.heartbeat);
    const auto end = Clock::now() + longest;
    while (Clock::now() < end) {
      const std::string bytes = read();
      for (std::size_t i = 0; i < profiles_.size(); ++i)
        if (greets(profiles_[i], streams[i], bytes)) {
          const auto quiet = Clock::now() + kTalking;
          while (Clock::now() < quiet && !read(kQuiet).empty()) {
          }
          return i;
        }
    }
    return std::nullopt;
  }

  bool answers(const TableProfile& profile) {
    for (int time = 0; time < kTimes; ++time) {
      MessageStream stream(profile.messageEnds, profile.prompt, profile.heartbeat);
      line_.write(profile.identifyImmediate ? profile.identify : profile.lineEnd + profile.identify + profile.lineEnd);
      const auto asked = Clock::now();
      auto heard = asked;
      // While bytes come, however slowly, an answer is on its way.
      while (Clock::now() < std::min(asked + kTalking, heard + kAnswer)) {
        const std::string bytes = read();
        if (!bytes.empty()) heard = Clock::now();
        stream.feed(bytes, Clock::now());
        while (const auto message = stream.next(Clock::now()))
          if (profile.identity.matches(*message)) return true;
      }
    }
    return false;
  }

  [[nodiscard]] const std::string& heard() const { return heard_; }

 private:
  std::string read(milliseconds longest = kSlice) {
    const auto end = Clock::now() + longest;
    std::string bytes;
    do {
      pulse_();
      bytes = line_.read(kSlice);
    } while (bytes.empty() && Clock::now() < end);
    if (heard_.size() < kKept) heard_ += bytes.substr(0, kKept - heard_.size());
    return bytes;
  }

  bool greets(const TableProfile& profile, MessageStream& stream, const std::string& bytes) const {
    stream.feed(bytes, Clock::now());
    bool greeted = false;
    while (const auto message = stream.next(Clock::now()))
      greeted = greeted || (profile.greeting && profile.greeting->matches(*message));
    const bool beats = !profile.heartbeat.empty() && !heard_.empty() &&
                       heard_.find_first_not_of(profile.heartbeat) == std::string::npos;
    return greeted || beats;
  }

  SerialLine& line_;
  const std::vector<TableProfile>& profiles_;
  const TableDialog::Pulse& pulse_;
  std::string heard_;
};

}  // namespace

Recognition recognise(SerialLine& line, const std::vector<TableProfile>& profiles, const TableDialog::Pulse& pulse) {
  Listener listener(line, profiles, pulse);
  std::vector<std::size_t> order(profiles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (const auto first = listener.greeting())
    std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(*first),
                order.begin() + static_cast<std::ptrdiff_t>(*first) + 1);
  for (const std::size_t i : order)
    if (listener.answers(profiles[i])) return {i, listener.heard()};
  // A board that does not restart when its port is opened may be locked up by an alarm until it is reset.
  if (profiles.size() == 1 && !profiles.front().stopReset.empty()) {
    line.write(profiles.front().stopReset);
    static_cast<void>(listener.greeting());
    if (listener.answers(profiles.front())) return {0, listener.heard()};
  }
  return {std::nullopt, listener.heard()};
}

}  // namespace vantage
