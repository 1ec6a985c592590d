#include "fuzz/scratch_file.h"

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace vantage::testing {
namespace {

std::filesystem::path scratchFolder() {
  const std::filesystem::path memory = "/dev/shm";
  return std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
}

}  // namespace

ScratchFile::ScratchFile(const std::string& ending) {
  static std::atomic<int> count = 0;
  path_ = (scratchFolder() / ("vantage_fuzz_" + std::to_string(getpid()) + "_" + std::to_string(count++) + ending))
              .string();
}

ScratchFile::~ScratchFile() {
  std::error_code ignored;
  for (const char* suffix : {"", "-wal", "-shm", ".lock"}) std::filesystem::remove(path_ + suffix, ignored);
}

void ScratchFile::write(std::string_view bytes) const {
  std::ofstream(path_, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string ScratchFile::read() const {
  std::ostringstream bytes;
  bytes << std::ifstream(path_, std::ios::binary).rdbuf();
  return bytes.str();
}

}  // namespace vantage::testing
