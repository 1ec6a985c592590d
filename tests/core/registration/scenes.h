#pragma once

#include <memory>

#include "geometry/mesh.h"
#include "scanner/profile.h"
#include "scanner/view.h"

namespace vantage::testing {

/// A closed ball of about 60 mm with gentle relief in all directions, standing on z = 0: it holds every motion.
[[nodiscard]] Mesh makeBall();

/// An upright plate in x = 0 that faces +x, 120 mm wide and high, with bumps that repeat every 12 mm.
[[nodiscard]] Mesh makeEggTray();

/// A rotating stripe scanner of rows x columns rays on a turntable of 90 positions, without mechanical error.
[[nodiscard]] std::shared_ptr<const ScannerProfile> makeProfile(double rangeSigma, int rows = 130, int columns = 130);

/// A scan from a turntable position with its true pose, triangulated.
[[nodiscard]] View scanFrom(const Mesh& object, const std::shared_ptr<const ScannerProfile>& profile, int position,
                            unsigned seed = 1);

/// The same of a vase, a smooth surface of revolution about z that is open above and below: nothing holds its turns
/// about z. Not a mesh, whose facets would.
[[nodiscard]] View scanVase(const std::shared_ptr<const ScannerProfile>& profile, int position, unsigned seed = 1);

/// A turn by an angle [rad] about a random axis through `centre`, and a shift [mm] in a random direction.
[[nodiscard]] Pose randomMotion(unsigned seed, double angle, double shift, const Vec3& centre);

/// The view's centroid in object coordinates.
[[nodiscard]] Vec3 centroid(const View& view);

/// RMS distance between where two poses put the view's points [mm].
[[nodiscard]] double poseError(const View& view, const Pose& a, const Pose& b);

}  // namespace vantage::testing
