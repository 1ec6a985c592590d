#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "registration/icp.h"
#include "registration/view_network.h"

namespace vantage {

/// Two views that fit each other where they are, without any third.
using ViewTie = std::pair<std::size_t, std::size_t>;

/// The ties among views at these poses: pairs of which one, registered with the other alone, fits and stays within the
/// spacing of the samples of where it is. It may slide on the other: what a loop leaves open the sigmas of a refinement
/// of all views tell.
/// @param options without a prior: surface alone ties
/// @param wanted one per view: nothing is tied to those without
/// @throws Cancelled
[[nodiscard]] std::vector<ViewTie> tiesAmong(std::span<const PreparedView> views, std::span<const Pose> poses,
                                             const std::vector<bool>& wanted, const IcpOptions& options,
                                             const Progress& progress);

/// Which views closed loops hold together: two of the same number have two ways of ties between them that have no tie
/// in common, so that an error of one tie would keep a loop from closing.
/// @param known one per view; all of them count as one place
/// @return one number per view, 0 for the known ones and what is held with them
[[nodiscard]] std::vector<std::size_t> heldTogether(std::span<const ViewTie> ties, const std::vector<bool>& known);

}  // namespace vantage
