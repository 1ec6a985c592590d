#pragma once

#include <optional>

#include "geometry/vectors.h"

namespace vantage {

/// One way in which the object stands on the table. The object's frame is that of the table in the first stand.
struct Stand {
  std::optional<Pose> T_object_table;  ///< nothing as long as nobody knows how the object was turned over
};

}  // namespace vantage
