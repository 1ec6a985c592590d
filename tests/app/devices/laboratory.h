#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "support/test_data.h"

namespace vantage::testing {

/// The folder with the stand-ins of the laboratory, which are not part of the project: the environment variable
/// VANTAGE_LAB. Nothing when it is absent.
[[nodiscard]] std::optional<std::filesystem::path> laboratoryFolder();

/// A turntable of the laboratory on a pseudo terminal, for as long as this lives.
class LaboratoryTable {
 public:
  /// @param faults as its documentation has them, a JSON list
  LaboratoryTable(const std::filesystem::path& laboratory, std::vector<std::string> options,
                  const std::string& faults = "[]");
  ~LaboratoryTable();
  LaboratoryTable(const LaboratoryTable&) = delete;
  LaboratoryTable& operator=(const LaboratoryTable&) = delete;

  [[nodiscard]] std::string port() const { return folder_.file("table"); }
  /// Where the plate really is [deg, counter-clockwise].
  [[nodiscard]] double truth() const;
  /// Whether it turns or trembles.
  [[nodiscard]] bool moving() const;
  /// What went over the wire.
  [[nodiscard]] std::string log() const;

 private:
  [[nodiscard]] std::string state() const;

  TemporaryFolder folder_;
  pid_t process_ = 0;
};

}  // namespace vantage::testing
