#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace vantage {

/// A program that runs beside this one and writes into files. When it goes out of scope the program is killed, unless
/// it has ended.
class ChildProgram {
 public:
  struct Places {
    std::string folder;  ///< that it runs in
    std::string output;  ///< file for its stdout, begun anew
    std::string errors;  ///< file for its stderr, added to
  };

  /// @param run the program's file, then its arguments
  /// @throws IoError when it cannot be started
  ChildProgram(const std::vector<std::string>& run, const Places& places);
  ~ChildProgram();
  ChildProgram(ChildProgram&& other) noexcept;
  ChildProgram& operator=(ChildProgram&&) = delete;
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  /// Its exit code once it has ended, 128 + the signal when one ended it; nothing while it runs.
  [[nodiscard]] std::optional<int> ended();
  /// Asks it to end (SIGTERM).
  void askToEnd() const;

 private:
  pid_t process_ = 0;  // 0: none
  std::optional<int> exitCode_;
};

}  // namespace vantage
