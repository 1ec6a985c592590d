#include "devices/program_turntable.h"

#include <cmath>
#include <utility>

#include "base/errors.h"
#include "devices/program_run.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

// The last line, if it is a number.
std::optional<double> lastNumber(const std::string& output) {
  const std::size_t end = output.find_last_not_of(" \t\r\n");
  if (end == std::string::npos) return std::nullopt;
  const std::size_t lineEnd = output.find_last_of("\r\n", end);
  std::size_t begin = lineEnd == std::string::npos ? 0 : lineEnd + 1;
  begin = output.find_first_not_of(" \t", begin);
  const auto value = parseDecimal(std::string_view(output).substr(begin, end + 1 - begin));
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return value;
}

}  // namespace

ProgramTurntable::ProgramTurntable(ProgramDevice program) : program_(std::move(program)) {
  if (program_.run.empty()) throw InvalidInput("a turntable needs a program: the list of its arguments is empty");
  if (!names(program_.run, "angle") && !names(program_.run, "position"))
    throw InvalidInput("the arguments of " + program_.run.front() +
                       " have neither {angle} nor {position}: that is where the table is told to turn to");
  if (names(program_.run, "file") || names(program_.run, "tilt"))
    throw InvalidInput("the arguments of the turntable " + program_.run.front() +
                       " have {file} or {tilt}, expected {angle} or {position}");
  static_cast<void>(filledIn(program_.run, {{"angle", ""}, {"position", ""}}));
}

void ProgramTurntable::open(const Progress& progress) {
  progress.checkpoint(0.0);
  open_ = true;
}

std::optional<std::string> ProgramTurntable::notReady() const {
  if (!open_) return "it is not open";
  return std::nullopt;
}

TableAngle ProgramTurntable::turnTo(double degrees, const Progress& progress) {
  if (!open_) throw DeviceError(identity() + ": it is not open");
  if (!position_ && names(program_.run, "position"))
    throw DeviceError(identity() + ": its arguments have {position}, but it was told only an angle: use {angle}");
  const std::string position = std::to_string(position_.value_or(0));
  const std::vector<std::string> run =
      filledIn(program_.run, {{"angle", argumentText(degrees)}, {"position", position}});
  angle_.reset();
  const ProgramEnd end = runProgram(run, program_.timeout, "turning with " + program_.run.front(), progress);
  output_ = end.output + end.errors;
  if (end.exitCode != 0)
    throw DeviceError(identity() + ": it ended with exit code " + std::to_string(end.exitCode) +
                      " instead of turning to " + argumentText(degrees) + " degrees" + saidLast(end));
  const auto reported = lastNumber(end.output);
  angle_ = reported ? TableAngle{*reported, PoseSource::Reported} : TableAngle{degrees, PoseSource::Commanded};
  return *angle_;
}

void ProgramTurntable::home(const Progress& /*progress*/) {
  throw DeviceError(identity() + ": a table that a program turns has no home; turn it there with the program itself");
}

}  // namespace vantage
