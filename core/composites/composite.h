#pragma once

#include <memory>
#include <vector>

#include "integration/model.h"
#include "registration/multi_view.h"
#include "scanner/view.h"

namespace vantage {

/// A plane that the object stood on: nothing of it is below. normal . x = height, composite coordinates.
struct TablePlane {
  Vec3 normal = Vec3::UnitZ();  ///< unit, up
  double height = 0.0;          ///< [mm]
};

/// What was acquired of an object in one stand (Pito 1999, 6.3), or in several that are aligned already: all in the
/// composite's own frame, which is the table's for a single stand.
struct Composite {
  std::vector<View> views;             ///< T_object_scanner leads to composite coordinates
  std::shared_ptr<const Model> model;  ///< made of the views, whose order its provenance names
  std::vector<TablePlane> tables;      ///< one per stand; none where it is not known
  std::vector<PoseTie> ties;           ///< of the mechanics, between views of one stand
};

}  // namespace vantage
