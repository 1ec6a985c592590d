#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "composites/composite.h"
#include "composites/composite_model.h"
#include "geometry/mesh.h"
#include "geometry/ray_caster.h"
#include "scanner/profile.h"

namespace vantage {

/// In how many ways an object fits itself.
enum class Symmetry : std::uint8_t {
  None,
  Turns,   ///< in a few, or all around
  Slides,  ///< a plain cylinder
};

struct StandObject {
  std::string name;
  Symmetry symmetry = Symmetry::None;
  Mesh mesh;
};

/// Objects made in code, of about 100 mm: in turn two that are put together at random, a sample object, one that is
/// symmetric, two at random, a cylinder.
[[nodiscard]] StandObject standObject(int number);

/// One stand of an object as it was acquired.
struct SimulatedStand {
  Pose T_table_object = Pose::Identity();
  Composite composite;
  int rejected = 0;  ///< scans that did not find their place
};

/// Puts the object on one of its faces, turned about the vertical at random, and acquires it from `turns` turns evenly
/// around with noise of 0.1 mm and errors of 0.3 degrees and 0.3 mm per move.
/// @param face of those that it rests on for sure, the likeliest first; nothing when it has fewer
[[nodiscard]] std::optional<SimulatedStand> simulatedStand(const StandObject& object, std::size_t face, int turns,
                                                           std::uint64_t seed);

/// The small motion that brings a composite onto the true object, and how far off its points are then.
struct TrueFit {
  Pose T_object_composite = Pose::Identity();
  double rms = 0.0;  ///< [mm]
};
[[nodiscard]] TrueFit fittedTo(const RayCaster& object, const CompositeModel& composite,
                               const Pose& T_object_composite);

}  // namespace vantage
