#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace vantage {

/// What of a session file is damaged, or was done about it.
enum class LossKind : std::uint8_t {
  Copied,                ///< name: the copy that was made of the damaged file before anything was written to it
  TableDamaged,          ///< name: the table; number: how many of its rows were read
  RowsUnread,            ///< name: the table of which not all rows could be read; error
  RowDamaged,            ///< name: the table; number: the row; error
  LastStepLost,          ///< number: the step that the history ended at
  StepLost,              ///< number: the step
  StepIncomplete,        ///< number: the step, lost since not all of its views are there
  StepImpossible,        ///< number: the step, lost since it names a position or stand that there is not
  ScanDamaged,           ///< number: the scan; error
  ModelDamaged,          ///< number: the step whose model is made again; error
  ModelOfOtherViews,     ///< number: the step whose model is made again
  ModelOfOtherSamples,   ///< number: the step whose model is made again
  PlanDamaged,           ///< number: the step of the plan; error
  PlanOfOtherPositions,  ///< number: the step of the plan
  StateMadeAgain,        ///< number: the step that was not as it was written, and was carried out again
  StateUntrue,           ///< number: the step that is not as it was written, and cannot be made again
  FilesLost,             ///< number: how many of the profile's files are missing
  ObjectChanged,         ///< the object of the simulated scanner is not the one that was kept
  MoreDamaged,           ///< number: how many more of `name` are damaged, beyond those that are named
  StepsUnread,           ///< number: the first step that was read of a file that has very many
};
inline constexpr LossKind kLastLossKind = LossKind::StepsUnread;

/// One damage of a session, without words: those are in report/loss_wording.h.
struct Loss {
  LossKind kind = LossKind::StepLost;
  std::optional<std::int64_t> number;  ///< of what is lost, or how much is left, as the kind says
  std::string name;                    ///< of a table or a file
  std::string error;                   ///< what the reader says of it, with the session's path

  bool operator==(const Loss&) const = default;
};

/// So many rows or steps with the same kind of damage are named. Of the others there is a count.
inline constexpr std::int64_t kMostNamed = 100;

/// Whether it means that something is not as it was written.
[[nodiscard]] inline bool isDamage(const Loss& loss) {
  return loss.kind != LossKind::Copied && loss.kind != LossKind::StepsUnread;
}

}  // namespace vantage
