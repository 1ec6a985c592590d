#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// How a ranging ray classifies a boundary edge (Pito 1999, 4.3.1). `Rim`: the edge lies on the border of what the
/// scanner samples at all; beside it no ray was shot.
enum class EdgeClass : std::uint8_t { OuterJump, InnerJump, LineOfSightJump, Regular, Rim };
inline constexpr std::size_t kEdgeClasses = 5;

/// "outer_jump", "inner_jump", "line_of_sight_jump", "regular", "rim".
[[nodiscard]] std::string_view name(EdgeClass edgeClass);

/// A small rectangle attached to a boundary edge of the model, on the border between seen and unseen space
/// (Pito 1999, 4.3). Object coordinates.
struct VoidPatch {
  std::uint32_t from = 0;  ///< vertices of the model's boundary edge e, directed as in its triangle
  std::uint32_t to = 0;
  std::uint32_t triangle = 0;  ///< e_T, the model's triangle at the edge
  Vec3 centre = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  ///< unit, toward the free side
  /// Counter-clockwise seen from the free side; the first two are to and from.
  std::array<Vec3, 4> corners = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  double width = 0.0;                        ///< length of e [mm]
  double depth = 0.0;                        ///< local sample spacing [mm]
  double weight = 0.0;                       ///< [mm^2]
  double angle = 0.0;                        ///< theta_v in the frame of the edge [rad]
  EdgeClass edgeClass = EdgeClass::Regular;  ///< by the ray that sampled the edge
  bool bridged = false;                      ///< theta_v jumps over a thin wedge that no ray has confirmed to be free
  std::uint32_t view = 0;                    ///< the view whose ray sampled the edge
};

/// The void near the boundary of the model.
struct VoidSurface {
  std::vector<VoidPatch> patches;                  ///< in the order of MeshTopology::boundaryEdges
  std::array<std::size_t, kEdgeClasses> counts{};  ///< patches per edge class
  std::size_t bridged = 0;                         ///< patches that rest on a bridged wedge

  [[nodiscard]] std::size_t count(EdgeClass edgeClass) const { return counts[static_cast<std::size_t>(edgeClass)]; }
};

}  // namespace vantage
