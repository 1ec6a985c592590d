#include "planning/patch_outlook.h"

namespace vantage {

std::string_view name(EdgeReason reason) {
  switch (reason) {
    case EdgeReason::OutOfReach:
      return "out_of_reach";
    case EdgeReason::TooSteep:
      return "too_steep";
    case EdgeReason::LightBlocked:
      return "light_blocked";
    case EdgeReason::ReceiverBlocked:
      return "receiver_blocked";
    case EdgeReason::BelowThreshold:
      return "below_threshold";
    case EdgeReason::Answered:
      return "answered";
    case EdgeReason::Erased:
      return "erased";
  }
  return "";
}

}  // namespace vantage
