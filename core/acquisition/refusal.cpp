#include "acquisition/refusal.h"

#include <array>

namespace vantage {

std::string_view name(RefusalReason reason) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(kLastRefusalReason) + 1> kNames{
      "no_profile",           "no_such_position",   "no_such_stand",    "stand_known",
      "not_a_view",           "only_view",          "not_left_out",     "scan_used",
      "scans_before",         "no_scans",           "already_ended",    "not_ended",
      "nothing_left",         "limit_reached",      "nothing_scanned",  "meshes_made",
      "contradiction",        "not_replayable",     "nothing_to_undo",  "nothing_to_redo",
      "nothing_to_scan_with", "fits_no_other_turn", "nothing_to_align", "not_aligned",
      "no_such_pose",         "pose_contradicted",  "stands_together",  "other_stand",
      "stand_not_in_work",    "not_erased"};
  return kNames[static_cast<std::size_t>(reason)];
}

}  // namespace vantage
