#pragma once

#include <memory>

#include "geometry/vectors.h"
#include "scanner/range_image.h"
#include "scanner/triangulation.h"

namespace vantage {

/// A scan that has its place: what registration, integration and planning share of it. Pieces are immutable.
struct View {
  std::shared_ptr<const RangeImage> image;
  std::shared_ptr<const ViewMesh> mesh;
  Pose T_object_scanner = Pose::Identity();  ///< registered pose
};

}  // namespace vantage
