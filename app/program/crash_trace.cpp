#include "program/crash_trace.h"

#include <execinfo.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <fstream>
#include <iterator>
#include <string_view>

#include "program/version.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

struct FatalSignal {
  int number;
  const char* name;
};
constexpr std::array<FatalSignal, 5> kFatal{
    {{SIGSEGV, "SIGSEGV"}, {SIGBUS, "SIGBUS"}, {SIGFPE, "SIGFPE"}, {SIGILL, "SIGILL"}, {SIGABRT, "SIGABRT"}}};

constexpr std::size_t kPathLength = 4096;
constexpr std::size_t kMostFrames = 128;
constexpr std::size_t kStackOfHandler = std::size_t{1} << 17;
constexpr std::size_t kMostRead = std::size_t{1} << 20;
constexpr std::string_view kUntold = ".new";  // ending of a trace that nobody was told of
constexpr std::string_view kTold = ".txt";
constexpr std::string_view kSessionLine = "session: ";

// What the handler reads: all of it was made before the crash.
std::array<char, kPathLength> traceFile{};
std::array<char, 512> programLines{};
std::array<std::array<char, kPathLength>, 2> sessions{};
std::atomic<int> session{0};
std::array<char, 1024> exceptionText{};
std::array<char, kStackOfHandler> handlerStack{};
std::atomic_flag crashing = ATOMIC_FLAG_INIT;
std::terminate_handler usualTerminate = nullptr;

template <std::size_t N>
void keep(std::array<char, N>& buffer, const std::string& text) {
  const std::size_t length = std::min(text.size(), N - 1);
  std::memcpy(buffer.data(), text.data(), length);
  buffer[length] = '\0';
}

// From here to the handler: nothing but what POSIX allows in a handler of signals.
void put(int file, const char* text) {
  std::size_t left = std::strlen(text);
  while (left > 0) {
    const ssize_t written = ::write(file, text, left);
    if (written <= 0) return;
    text += written;
    left -= static_cast<std::size_t>(written);
  }
}

void putNumber(int file, std::uintptr_t value, unsigned base) {
  std::array<char, 2 * sizeof value + 8> digits{};
  std::size_t at = digits.size() - 1;
  do {
    digits[--at] = "0123456789abcdef"[value % base];
    value /= base;
  } while (value > 0);
  put(file, digits.data() + at);
}

void putFile(int file, const char* path) {
  const int from = ::open(path, O_RDONLY | O_CLOEXEC);
  if (from < 0) return;
  std::array<char, 4096> buffer{};
  for (ssize_t got = 0; (got = ::read(from, buffer.data(), buffer.size() - 1)) > 0;) {
    buffer[static_cast<std::size_t>(got)] = '\0';
    put(file, buffer.data());
  }
  ::close(from);
}

// The folders above a file, whose path comes back as it was.
void makeFoldersAbove(char* path) {
  for (char* at = path + 1; *path != '\0' && *at != '\0'; ++at) {
    if (*at != '/') continue;
    *at = '\0';
    ::mkdir(path, 0700);
    *at = '/';
  }
}

void putLine(int file, const char* label, const char* text) {
  if (*text == '\0') return;
  put(file, label);
  put(file, text);
  put(file, "\n");
}

void writeTrace(int file, int number, const siginfo_t* info) {
  put(file, programLines.data());
  put(file, "signal: ");
  for (const FatalSignal& fatal : kFatal)
    if (fatal.number == number) put(file, fatal.name);
  if (number != SIGABRT) {
    put(file, " at 0x");
    putNumber(file, reinterpret_cast<std::uintptr_t>(info->si_addr), 16);
  }
  put(file, "\n");
  putLine(file, kSessionLine.data(), sessions[static_cast<std::size_t>(session.load())].data());
  putLine(file, "exception: ", exceptionText.data());
  put(file, "stack:\n");
  std::array<void*, kMostFrames> frames{};
  ::backtrace_symbols_fd(frames.data(), ::backtrace(frames.data(), kMostFrames), file);
  put(file, "memory:\n");
  putFile(file, "/proc/self/maps");
}

void onFatalSignal(int number, siginfo_t* info, void* /*context*/) {
  // What breaks while the trace is written, and other threads that break meanwhile.
  if (crashing.test_and_set()) {
    std::signal(number, SIG_DFL);
    ::raise(number);
    return;
  }
  makeFoldersAbove(traceFile.data());
  const int file = ::open(traceFile.data(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (file >= 0) {
    writeTrace(file, number, info);
    ::close(file);
    put(STDERR_FILENO, "The program broke; what it was doing is in ");
    put(STDERR_FILENO, traceFile.data());
    put(STDERR_FILENO, "\n");
  }
  std::signal(number, SIG_DFL);
  ::raise(number);
}
// Up to here.

// An exception that nobody caught says what it is before the abort.
[[noreturn]] void onTerminate() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::exception& e) {
    keep(exceptionText, e.what());
  } catch (...) {
    keep(exceptionText, "of an unknown type");
  }
  if (usualTerminate != nullptr) usualTerminate();
  std::abort();
}

std::string startTime() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y%m%dT%H%M%SZ", &parts);
  return text.data();
}

std::vector<fs::path> untoldTraces(const std::string& program, const fs::path& folder) {
  std::vector<fs::path> traces;
  std::error_code unknown;
  fs::directory_iterator entry(folder, unknown);
  for (; !unknown && entry != fs::directory_iterator(); entry.increment(unknown)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(program + "-2") && name.ends_with(kUntold)) traces.push_back(entry->path());
  }
  std::sort(traces.begin(), traces.end());
  return traces;
}

std::string textOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text(kMostRead, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

std::string sessionIn(const std::string& text) {
  std::string line("\n");
  line += kSessionLine;
  const std::size_t found = text.find(line);
  const std::size_t stack = text.find("\nstack:");
  if (found == std::string::npos || found > stack) return {};
  const std::size_t begin = found + line.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace

fs::path leaveCrashTraces(const std::string& program, const fs::path& folder) {
  if (kSanitized) return {};
  const std::string file =
      (folder / (program + "-" + startTime() + "-" + std::to_string(::getpid()) + std::string(kUntold))).string();
  keep(traceFile, file);
  keep(programLines, "program: " + program + " " + programVersion() + "\ncommit: " + programCommit() + "\n");
  // The unwinder is loaded now, for it could not be in a handler.
  std::array<void*, 2> frames{};
  static_cast<void>(::backtrace(frames.data(), static_cast<int>(frames.size())));
  usualTerminate = std::set_terminate(onTerminate);
  stack_t stack{};
  stack.ss_sp = handlerStack.data();
  stack.ss_size = handlerStack.size();
  ::sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_sigaction = onFatalSignal;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
  ::sigemptyset(&action.sa_mask);
  for (const FatalSignal& fatal : kFatal) ::sigaction(fatal.number, &action, nullptr);
  return file;
}

void nameSessionInCrashTraces(const std::string& path) {
  const int other = 1 - session.load();
  keep(sessions[static_cast<std::size_t>(other)], path);
  session.store(other);
}

std::optional<CrashTrace> untoldCrash(const std::string& program, const fs::path& folder) {
  const std::vector<fs::path> traces = untoldTraces(program, folder);
  if (traces.empty()) return std::nullopt;
  std::string text = textOf(traces.back());
  std::string sessionOpen = sessionIn(text);
  return CrashTrace{traces.back(), std::move(sessionOpen), std::move(text)};
}

void tellCrashes(const std::string& program, const fs::path& folder) {
  for (const fs::path& trace : untoldTraces(program, folder)) {
    std::error_code failed;  // then it is told once more
    fs::rename(trace, fs::path(trace).replace_extension(kTold), failed);
  }
}

}  // namespace vantage
