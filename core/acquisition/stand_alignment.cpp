#include "acquisition/stand_alignment.h"

#include <array>

namespace vantage {

std::string_view name(PoseChoice choice) {
  constexpr std::array<std::string_view, 3> kNames{"evidence", "operator", "despite"};
  return kNames.at(static_cast<std::size_t>(choice));
}

}  // namespace vantage
