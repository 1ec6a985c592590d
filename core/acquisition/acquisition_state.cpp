#include "acquisition/acquisition_state.h"

namespace vantage {

std::string_view name(Termination termination) {
  switch (termination) {
    case Termination::Running:
      return "running";
    case Termination::Finished:
      return "finished";
    case Termination::NoOverlap:
      return "no_overlap";
    case Termination::MaxViews:
      return "max_views";
    case Termination::RegistrationFailed:
      return "registration_failed";
    case Termination::Cancelled:
      return "cancelled";
  }
  return "";
}

std::shared_ptr<const Plan> currentPlan(const AcquisitionState& state) {
  return state.records.empty() ? nullptr : state.records.back().plan;
}

}  // namespace vantage
