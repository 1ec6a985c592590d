#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "geometry/vectors.h"

namespace vantage {

/// Why something about a file is taken for true.
enum class KnownBy : std::uint8_t {
  Default,   ///< nothing tells: it is what such files usually have
  Evidence,  ///< the numbers of the file, or of all files together, tell
  File,      ///< the file, or its format, says so
  Operator,  ///< an option says so
};
inline constexpr KnownBy kLastKnownBy = KnownBy::Operator;
/// "default", "evidence", "file", "operator".
[[nodiscard]] std::string_view name(KnownBy knownBy);

/// What stands in cells of a range file where nothing was measured.
enum class NoSampleMark : std::uint8_t {
  None,      ///< nothing, or no number
  Given,     ///< the value that an option names
  Zero,      ///< the point (0, 0, 0)
  Repeated,  ///< one and the same point
  FarPlane,  ///< points of one constant depth before or behind everything else
  Outlier,   ///< numbers out of all proportion
};
inline constexpr NoSampleMark kLastNoSampleMark = NoSampleMark::Outlier;
/// "none", "given", "zero", "repeated", "far_plane", "outlier".
[[nodiscard]] std::string_view name(NoSampleMark mark);

/// How the lines of sight of a range file lie.
enum class SightKind : std::uint8_t {
  Grid,       ///< about along one direction, as the samples of the grid tell
  Point,      ///< from one point, in all directions
  Turntable,  ///< towards an axis, all around
  Profile,    ///< as the profile of the scanner says
};
inline constexpr SightKind kLastSightKind = SightKind::Profile;
/// "grid", "point", "turntable", "profile".
[[nodiscard]] std::string_view name(SightKind kind);

/// An axis of coordinates.
enum class Axis : std::uint8_t { X, Y, Z };
inline constexpr Axis kLastAxis = Axis::Z;
/// "x", "y", "z".
[[nodiscard]] std::string_view name(Axis axis);

/// As what a recorded scan was read: what its file does not say, or says otherwise, and why it was taken so.
struct ScanReading {
  double unit = 1.0;  ///< millimetres per unit of the file
  KnownBy unitKnownBy = KnownBy::Default;
  SightKind sightKind = SightKind::Grid;
  Vec3 sight = -Vec3::UnitZ();  ///< where the scanner looks, in the axes of the file, unit
  KnownBy sightKnownBy = KnownBy::Default;
  NoSampleMark noSample = NoSampleMark::None;
  std::size_t dropped = 0;     ///< cells that carried the mark
  bool exchanged = false;      ///< rows and columns are the other way round than the file says
  bool placed = false;         ///< the points are in the object's coordinates: a pose was not applied
  Vec3 offset = Vec3::Zero();  ///< [mm] what was taken off: p_world = p_object + offset
  double poseUnit = 1.0;       ///< millimetres per unit of the list of poses
  KnownBy poseUnitKnownBy = KnownBy::Default;
  Axis up = Axis::Z;               ///< the axis of the world that became z
  std::optional<Axis> turnsAbout;  ///< the axis of the object that the poses turn about
};

/// The rotation that brings an axis to z; the identity for z.
[[nodiscard]] Eigen::Matrix3d uprightTurn(Axis up);

}  // namespace vantage
