#include "cli/person_at_table.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <utility>

#include "cli/text.h"
#include "scanner/table_turn.h"

namespace vantage {
namespace {

constexpr int kPollMs = 100;

// One that says what goes on at another.
class ToldSensor final : public RangeSensor {
 public:
  ToldSensor(std::shared_ptr<RangeSensor> sensor, PersonAtTable& person)
      : sensor_(std::move(sensor)), person_(person) {}

  [[nodiscard]] std::string identity() const override { return sensor_->identity(); }
  void open(const Progress& progress) override { sensor_->open(progress); }
  void close() noexcept override { sensor_->close(); }
  [[nodiscard]] std::optional<std::string> notReady() const override { return sensor_->notReady(); }
  void announceMove() override { sensor_->announceMove(); }
  void standAt(const ReachedPose& pose) override { sensor_->standAt(pose); }
  [[nodiscard]] RangeImage capture(const Progress& progress) override {
    person_.tell({{"event", "waiting"}, {"for", sensor_->identity()}});
    RangeImage image = sensor_->capture(progress);
    person_.tell({{"event", "scan"}, {"samples", image.sampleCount()}});
    return image;
  }

 private:
  std::shared_ptr<RangeSensor> sensor_;
  PersonAtTable& person_;
};

// Degrees to a tenth, without a minus before zero.
double rounded(double angle) {
  return std::round(10.0 * degrees(angle)) / 10.0 + 0.0;
}

}  // namespace

// Where the scanner goes round the object the table turns the other way.
PersonAtTable::PersonAtTable(std::shared_ptr<const ScannerProfile> profile, const TableStand& stand, bool events,
                             CommandContext& context)
    : profile_(std::move(profile)),
      events_(events),
      context_(context),
      angle_(turnBetween(profile_->workspace, 0, stand.position).angle - stand.counted - stand.farther) {
  if (events) context.keepForEvents();
}

void PersonAtTable::tell(const nlohmann::ordered_json& event) {
  if (!events_) return;
  const std::string line = event.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  if (std::fwrite(line.data(), 1, line.size(), stdout) != line.size() || std::fflush(stdout) != 0)
    throw IoError("standard output", "cannot be written: nobody hears what is to be turned");
}

Rig PersonAtTable::told(Rig rig) {
  if (events_) rig.sensor = std::make_shared<ToldSensor>(rig.sensor, *this);
  return rig;
}

void PersonAtTable::ask(int position, const Progress& progress) {
  if (skipped_.contains(position))
    throw PositionSkipped("position " + std::to_string(position) + " was skipped before");
  const double angle = turnBetween(profile_->workspace, 0, position).angle;
  const double to = rounded(angle);
  const double by = rounded(std::remainder(angle - angle_, 2.0 * kPi));
  if (events_) {
    tell({{"event", "turn"}, {"position", position}, {"table_deg", to}, {"by_deg", by}});
  } else {
    context_.note("turn the table by " + number(std::abs(by), 1) + " degrees " +
                  (by < 0.0 ? "clockwise" : "counter-clockwise") + " as seen from above, to " + number(to, 1) +
                  " degrees (position " + std::to_string(position) +
                  "), and press Enter; 'skip' for another position, 'stop' to end here" +
                  (offered_.empty() ? "" : "; 'take' to take " + offered_));
  }
  const std::string said = answer(progress);
  const std::string offered = std::exchange(offered_, {});
  if (said == "take") throw TakenAsFrom("taking " + offered);
  if (said == "skip") {
    skipped_.insert(position);
    throw PositionSkipped("position " + std::to_string(position) + " was skipped");
  }
  if (said == "stop") throw EndedByPerson("ended here");
  angle_ = angle;
}

void PersonAtTable::offerTurn(std::int64_t scan, double tableDeg) {
  offered_ = "scan " + std::to_string(scan) + " as from " + number(tableDeg, 1) + " degrees";
}

std::string PersonAtTable::answer(const Progress& progress) {
  for (;;) {
    if (const std::size_t end = typed_.find('\n'); end != std::string::npos) {
      std::string line = typed_.substr(0, end);
      typed_.erase(0, end + 1);
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (line.empty() || line == "done" || line == "skip" || line == "stop") return line;
      if (line == "take" && !offered_.empty()) return line;
      const std::string ways = offered_.empty() ? "" : ", take";
      tell({{"event", "problem"}, {"text", "the answer is not known: done, skip" + ways + " or stop is expected"}});
      if (!events_)
        context_.note(offered_.empty() ? "please answer with Enter, 'skip' or 'stop'"
                                       : "please answer with Enter, 'take', 'skip' or 'stop'");
      continue;
    }
    progress.checkpoint(0.0);
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (poll(&input, 1, kPollMs) <= 0) continue;
    std::array<char, 256> bytes{};
    const ssize_t got = read(STDIN_FILENO, bytes.data(), bytes.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw EndedByPerson("standard input has ended: nobody is there who turns the table");
    typed_.append(bytes.data(), static_cast<std::size_t>(got));
    if (typed_.size() > 10'000) typed_.clear();
  }
}

}  // namespace vantage
