#include "planning/plan.h"

namespace vantage {

std::string_view name(PlanOutcome outcome) {
  switch (outcome) {
    case PlanOutcome::Found:
      return "found";
    case PlanOutcome::Finished:
      return "finished";
    case PlanOutcome::NoOverlap:
      return "no_overlap";
  }
  return "";
}

std::string_view name(Constraint constraint) {
  switch (constraint) {
    case Constraint::Chosen:
      return "chosen";
    case Constraint::Outscored:
      return "outscored";
    case Constraint::BelowThreshold:
      return "below_threshold";
    case Constraint::OverlapShort:
      return "overlap_short";
    case Constraint::PoseUncertain:
      return "pose_uncertain";
  }
  return "";
}

}  // namespace vantage
