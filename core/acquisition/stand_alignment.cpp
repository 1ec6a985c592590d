#include "acquisition/stand_alignment.h"

#include <array>

namespace vantage {

std::string_view name(AlignmentVerdict verdict) {
  constexpr std::array<std::string_view, 3> kNames{"good", "ambiguous", "failed"};
  return kNames.at(static_cast<std::size_t>(verdict));
}

std::string_view name(AlignmentReason reason) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(kLastAlignmentReason) + 1> kNames{
      "one_pose", "slides", "several_poses", "contradiction", "too_little_overlap", "bent_composite", "other_object"};
  return kNames.at(static_cast<std::size_t>(reason));
}

std::string_view name(PoseChoice choice) {
  constexpr std::array<std::string_view, 3> kNames{"evidence", "operator", "despite"};
  return kNames.at(static_cast<std::size_t>(choice));
}

}  // namespace vantage
