#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "registration/known_surface.h"
#include "registration/view_network.h"

namespace vantage {

/// A scanner misses what is dark or in its receiver's shadow: emptiness speaks beyond this share only.
inline constexpr double kMayMiss = 0.4;

/// What two views say about each other: numbers of points of one that were looked up on the other.
struct Agreement {
  double paired = 0.0;   ///< surface lies where the other saw it
  double through = 0.0;  ///< the other looked through it
  double empty = 0.0;    ///< it faces the other and its receivers, which saw nothing there nor next to it
  double turned = 0.0;   ///< near, with another normal
  double behind = 0.0;   ///< a little behind the other's surface

  Agreement& operator+=(const Agreement& other);

  /// Points that the other should have seen, as it did or not.
  [[nodiscard]] double expected() const { return paired + through + empty + turned; }
  /// Share of those that contradict, 0..1; 0 where none are expected. Emptiness counts beyond the share `mayMiss`.
  [[nodiscard]] double contradiction(double mayMiss = kMayMiss) const;
};

/// What is known to hide points from the views: nothing, or surface in the frame of the poses.
struct Hiding {
  const KnownSurface* surface = nullptr;
  Pose T_surface_to = Pose::Identity();  ///< where the scanner of `to` is
};

/// Looks about `count` points of `from` up on `to`; through is what lies in front by more than the gate.
[[nodiscard]] Agreement agreementOf(const PreparedView& from, const PreparedView& to, const Pose& T_to_from,
                                    const PairGates& gates, std::size_t count, const Hiding& hiding = {});

/// Both directions of all pairs: [i * n + j] of points of i on j, zero for i = j. @throws Cancelled
[[nodiscard]] std::vector<Agreement> agreements(std::span<const PreparedView> views, std::span<const Pose> poses,
                                                const PairGates& gates, std::size_t count, const Progress& progress);

/// The views of the largest set found in which no two contradict each other by more than `most`: as long as two do, the
/// view goes that contradicts the most others, of those as many the one that is less trusted, then the one that
/// contradicts more, then the later one.
/// @param trust one per view; views with less than zero are not in the set
/// @return one per view: its contradiction with the views of the set, nothing for those in it
[[nodiscard]] std::vector<std::optional<double>> contradicting(std::span<const Agreement> agreements,
                                                               std::span<const int> trust, double most);

/// What one view and all others say about each other.
/// @param known what may hide points from them, or nothing @throws Cancelled
[[nodiscard]] Agreement agreementWithOthers(std::span<const PreparedView> views, std::span<const Pose> poses,
                                            std::size_t view, const PairGates& gates, std::size_t count,
                                            const KnownSurface* known, const Progress& progress);

/// Whether more than the share `most` of so many points contradicts, and plainly so.
[[nodiscard]] bool contradict(const Agreement& both, double most, double mayMiss = kMayMiss);

}  // namespace vantage
