#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vantage {

/// From now on a crash (a fault of memory or arithmetic, an abort, an exception that nobody caught) leaves a file in a
/// folder, which is made then: program, commit, signal, session, what the exception said, the stack of the thread and
/// where libraries lie in memory. The program then ends by that signal as it would have. What is done in the moment of
/// the crash allocates nothing and takes no lock. Programs with a sanitizer leave that to it.
/// @param program its name, the first part of the file's
/// @return the file that a crash would leave; empty when none is left
std::filesystem::path leaveCrashTraces(const std::string& program, const std::filesystem::path& folder);

/// The session that a trace names from now on; empty: none. To be called from one thread.
void nameSessionInCrashTraces(const std::string& session);

/// A trace that a crash left.
struct CrashTrace {
  std::filesystem::path file;
  std::string session;  ///< that was open; may be empty
  std::string text;     ///< at most 1 MiB of it
};

/// The latest trace of a program that nobody was told of yet.
[[nodiscard]] std::optional<CrashTrace> untoldCrash(const std::string& program, const std::filesystem::path& folder);

/// All traces of a program there are are known now: untoldCrash does not give them again. They stay.
void tellCrashes(const std::string& program, const std::filesystem::path& folder);

}  // namespace vantage
