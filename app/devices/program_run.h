#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "base/progress.h"

namespace vantage {

/// What a program that has ended left.
struct ProgramEnd {
  int exitCode = 0;    ///< 128 + the signal that ended it
  std::string output;  ///< the end of what it wrote to stdout, at most 64 KiB
  std::string errors;  ///< likewise of stderr
};

/// Runs a program, without a shell: the first of `run` is its name, searched in PATH when it has no slash, the others
/// its arguments. It reads nothing from stdin. With everything it started it is a process group of its own.
/// @param doing what the progress says, for instance "scanning with gphoto2"
/// @throws DeviceError when it cannot be started, and when it has not ended in time: then it and all that it started
/// have been killed; the message has the end of its output. Cancelled likewise.
[[nodiscard]] ProgramEnd runProgram(const std::vector<std::string>& run, std::chrono::milliseconds timeout,
                                    const std::string& doing, const Progress& progress);

/// The arguments with {key} replaced by its value, for every key. @throws InvalidInput for a {word} that is no key
[[nodiscard]] std::vector<std::string> filledIn(const std::vector<std::string>& run,
                                                const std::map<std::string, std::string>& values);

/// Whether {key} stands in the arguments.
[[nodiscard]] bool names(const std::vector<std::string>& run, const std::string& key);

/// What it said last, as the end of a message: "; it said: ..." or "; it said nothing".
[[nodiscard]] std::string saidLast(const ProgramEnd& end);

/// A number of an argument: decimal point, at most four digits behind it.
[[nodiscard]] std::string argumentText(double value);

}  // namespace vantage
