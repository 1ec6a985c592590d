#include "program/installed_files.h"

#include <unistd.h>

#include <cstdlib>

namespace vantage {
namespace {

namespace fs = std::filesystem;

std::string environmentText(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? std::string() : std::string(text);
}

fs::path fromProgram(const fs::path& program, const char* relative) {
  return (program.parent_path() / relative).lexically_normal();
}

fs::path resourceRoot(const fs::path& program, const std::string& named) {
  if (!named.empty()) return named;
  std::error_code unknown;
  fs::path installed = fromProgram(program, VANTAGE_RESOURCES_FROM_PROGRAM);
  return fs::is_directory(installed, unknown) ? installed : program.parent_path() / "resources";
}

}  // namespace

fs::path programFile() {
  std::error_code unknown;
  fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  return unknown ? fs::path() : program;
}

std::string resourceFolder(const std::string& name, const fs::path& program, const std::string& named) {
  const fs::path root = resourceRoot(program, named);
  return (name.empty() ? root : root / name).string();
}

std::string resourceFolder(const std::string& name) {
  return resourceFolder(name, programFile(), environmentText("VANTAGE_RESOURCES"));
}

std::optional<fs::path> helperProgram(const std::string& name, const fs::path& program) {
  for (const fs::path& file :
       {fromProgram(program, VANTAGE_HELPERS_FROM_PROGRAM) / name, program.parent_path() / name}) {
    std::error_code unknown;
    if (fs::is_regular_file(file, unknown) && ::access(file.c_str(), X_OK) == 0) return file;
  }
  return std::nullopt;
}

std::optional<fs::path> helperProgram(const std::string& name) {
  return helperProgram(name, programFile());
}

}  // namespace vantage
