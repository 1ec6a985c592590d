#include "devices/serial/port_holder.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <optional>

#include "base/plain_text.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

std::string described(const std::string& process) {
  std::string program;
  std::getline(std::ifstream("/proc/" + process + "/comm"), program);
  if (program.empty()) program = "a program";
  return plainText(program) + " (process " + process + ")";
}

bool hasOpen(const fs::path& process, const fs::path& device) {
  std::error_code refused;
  for (fs::directory_iterator files(process / "fd", refused), end; !refused && files != end; files.increment(refused)) {
    std::error_code gone;
    if (fs::read_symlink(files->path(), gone) == device && !gone) return true;
  }
  return false;
}

// The lock that terminal programs have agreed on: a file with the number of the process.
std::string lockedBy(const fs::path& device) {
  std::ifstream lock("/run/lock/LCK.." + device.filename().string());
  pid_t process = 0;
  if (!(lock >> process) || process <= 0 || process == ::getpid()) return {};
  if (::kill(process, 0) != 0 && errno == ESRCH) return {};
  return described(std::to_string(process));
}

}  // namespace

std::string holderOf(const std::string& path) {
  std::error_code failed;
  const fs::path device = fs::canonical(path, failed);
  if (failed) return {};
  const std::string own = std::to_string(::getpid());
  for (fs::directory_iterator processes("/proc", failed), end; !failed && processes != end;
       processes.increment(failed)) {
    const std::string process = processes->path().filename().string();
    if (process.find_first_not_of("0123456789") != std::string::npos || process == own) continue;
    if (hasOpen(processes->path(), device)) return described(process);
  }
  return lockedBy(device);
}

}  // namespace vantage
