#include "scanner/scan_reading.h"

#include <array>

namespace vantage {

std::string_view name(KnownBy knownBy) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(kLastKnownBy) + 1> kNames{"default", "evidence",
                                                                                            "file", "operator"};
  return kNames[static_cast<std::size_t>(knownBy)];
}

std::string_view name(NoSampleMark mark) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(kLastNoSampleMark) + 1> kNames{
      "none", "given", "zero", "repeated", "far_plane", "outlier"};
  return kNames[static_cast<std::size_t>(mark)];
}

std::string_view name(SightKind kind) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(kLastSightKind) + 1> kNames{"grid", "point",
                                                                                              "turntable", "profile"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view name(Axis axis) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(kLastAxis) + 1> kNames{"x", "y", "z"};
  return kNames[static_cast<std::size_t>(axis)];
}

Eigen::Matrix3d uprightTurn(Axis up) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  if (up == Axis::Y) turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  if (up == Axis::X) turn << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  return turn;
}

}  // namespace vantage
