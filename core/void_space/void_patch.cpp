#include "void_space/void_patch.h"

namespace vantage {

std::string_view name(EdgeClass edgeClass) {
  switch (edgeClass) {
    case EdgeClass::OuterJump:
      return "outer_jump";
    case EdgeClass::InnerJump:
      return "inner_jump";
    case EdgeClass::LineOfSightJump:
      return "line_of_sight_jump";
    case EdgeClass::Regular:
      return "regular";
    case EdgeClass::Rim:
      break;
  }
  return "rim";
}

}  // namespace vantage
