#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "acquisition/stand_alignment.h"
#include "geometry/region_probe.h"
#include "geometry/vectors.h"

namespace vantage {

/// Where the operator erased something that is not the object.
struct ErasedRegion {
  int number = 0;                             ///< of the erasure; one may concern several stands
  std::shared_ptr<const RegionProbe> region;  ///< in the frame of the table of its stand
};

/// One way in which the object stands on the table. The object's frame is that of the table in its reference, the first
/// of the stands whose pose is known.
struct Stand {
  std::optional<Pose> T_object_table;  ///< nothing as long as nobody knows how the object was turned over
  /// The side that it was to be put on: the unit vector that points down, coordinates of the table in the stand that
  /// was the reference then; nothing where none was advised.
  std::optional<Vec3> down = {};
  std::shared_ptr<const StandAlignment> alignment = nullptr;  ///< the last one; null before it and for the reference
  int reference = 0;                                          ///< the stand whose table's coordinates `down` is in
  std::vector<ErasedRegion> erased = {};                      ///< in the order in which they were erased
};

}  // namespace vantage
