#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace vantage::testing {

/// A program that runs beside the test; what it prints goes to a file. Killed when it still runs at the end.
class ChildProgram {
 public:
  ChildProgram(const std::vector<std::string>& command, const std::string& log);
  ~ChildProgram();
  ChildProgram(ChildProgram&& other) noexcept;
  ChildProgram& operator=(ChildProgram&&) = delete;

  /// Waits for its end. @return the exit code; -1 when a signal ended it
  int wait();
  /// kill -9. @return whether it was still running
  bool kill();

 private:
  pid_t process_ = -1;
};

}  // namespace vantage::testing
