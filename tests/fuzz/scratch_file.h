#pragma once

#include <string>
#include <string_view>

namespace vantage::testing {

/// A file in memory (or in the temporary folder) that is overwritten for every input and removed at the end.
class ScratchFile {
 public:
  /// @param ending with the dot.
  explicit ScratchFile(const std::string& ending);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  void write(std::string_view bytes) const;
  [[nodiscard]] std::string read() const;

 private:
  std::string path_;
};

}  // namespace vantage::testing
