#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "calibration/screw_motion.h"
#include "registration/view_network.h"

namespace vantage {

/// How firmly a fit is held to where it began.
struct ScrewPrior {
  double lean = radians(6.0);   ///< sigma of the axis's direction [rad]
  double shift = 20.0;          ///< and of its place [mm]
  double angle = radians(6.0);  ///< and of the angle of every scan [rad]
};

/// How distances shrink from coarse to fine while a motion is fitted.
struct ScrewSchedule {
  double firstGate = 10.0;  ///< largest distance of a pair at the beginning [mm]
  double lastGate = 1.0;    ///< and at the end [mm]
  double depth = 10.0;      ///< surface farther behind counts as hidden [mm]
  int maxIterations = 30;
  double tolerance = 1e-3;  ///< settled when nothing moves by more [mm]
};

struct ScrewFit {
  ScrewMotion motion;
  std::vector<ViewLink> links;  ///< with the pairs of the last round
  double sigma = 0.0;           ///< robust deviation of the pairs' distances [mm]
  /// Inverse covariance by the pairs alone, of: lean of the axis about and shift of it along the two vectors across it
  /// [rad, mm], where it passes `motion.point`; then the angles of all scans but the first [rad].
  Eigen::MatrixXd information;
  bool settled = false;
};

/// Fits one axis and the angles of all scans to pairs of points of linked views: the symmetric point-to-plane distances
/// of registerView, but the views may only turn about one common axis (pure rotation). Gauss-Newton with gates from
/// coarse to fine and Geman-McClure weights. Motions that noise of the normals pretends to hold are not held.
/// @param links whose pairs are looked up; those of them that never overlap contribute nothing
/// @param prior nothing: only the links hold
/// @throws Cancelled
[[nodiscard]] ScrewFit fitScrew(std::span<const PreparedView> views, const ScrewMotion& start,
                                std::vector<ViewLink> links, const ScrewSchedule& schedule,
                                const std::optional<ScrewPrior>& prior, const Progress& progress);

/// What the pairs say about how far each view turned, whatever its place [1/rad^2]: a round thing beside the axis has a
/// place and no turn. One per scan.
[[nodiscard]] std::vector<double> turnInformation(const ScrewFit& fit);

/// How badly the views of the links lie, 0 to 1: the mean over all points that should have a partner of the squared
/// distance over that of the gate, 1 beyond it, where the scanner looked through and where normals disagree. Views that
/// barely overlap lie badly.
[[nodiscard]] double misfit(std::span<const ViewLink> links, double gate);

}  // namespace vantage
