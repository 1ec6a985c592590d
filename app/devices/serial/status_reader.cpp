#include "devices/serial/status_reader.h"

#include <charconv>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr double kInch = 25.4;  // [mm]

// "1.5,-2,3"; empty when one of them is no number.
std::vector<double> numbersOf(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (;;) {
    if (at != end && *at == '+') ++at;
    double number = 0.0;
    const auto [rest, error] = std::from_chars(at, end, number);
    if (error != std::errc()) return {};
    numbers.push_back(number);
    if (rest == end) return numbers;
    if (*rest != ',') return {};
    at = rest + 1;
  }
}

}  // namespace

std::optional<double> StatusReader::field(const std::optional<MessagePattern>& pattern,
                                          const std::string& message) const {
  if (!pattern) return std::nullopt;
  const auto groups = pattern->groups(message);
  if (!groups || groups->empty()) return std::nullopt;
  const std::vector<double> numbers = numbersOf(groups->front());
  if (numbers.empty()) return std::nullopt;
  const std::size_t index = numbers.size() == 1 ? 0 : profile_.axes.find(profile_.axis);
  if (index >= numbers.size())
    throw DeviceError("the table reports " + std::to_string(numbers.size()) + " axes, but none is " + profile_.axis +
                      "; set the axis of the profile to the one that turns the table");
  return numbers[index];
}

std::optional<StatusReport> StatusReader::read(const std::string& message) {
  const StatusProfile& status = *profile_.status;
  if (!status.report.matches(message)) return std::nullopt;
  StatusReport report;
  if (status.state) {
    const auto word = status.state->groups(message);
    if (!word || word->empty()) return std::nullopt;
    report.word = word->front();
    const auto known = status.states.find(report.word);
    if (known != status.states.end()) report.state = known->second;
  }
  if (const auto offset = field(status.offset, message)) offset_ = offset;
  report.position = field(status.machine, message);
  if (const auto work = field(status.work, message); !report.position && work && offset_)
    report.position = *work + *offset_;
  if (inches_ && report.position) *report.position *= kInch;
  report.count = field(status.count, message);
  return report;
}

}  // namespace vantage
