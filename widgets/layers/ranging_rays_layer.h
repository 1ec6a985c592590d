#pragma once

#include "layers/view_snapshot.h"
#include "vtk/scene.h"

namespace vantage {

/// Where a scanner stands: a choice of its ranging rays as far as they reach, the path of its light source and its
/// receivers, with their line of sight to the middle of what is scanned.
class RangingRaysLayer {
 public:
  explicit RangingRaysLayer(Scene& scene);

  /// Rays end where the view has measured, elsewhere at the far side of the viewing volume.
  void showView(const ScannerProfile& profile, const View& view);
  /// Rays end on the model, elsewhere at the far side of the viewing volume.
  void showPosition(const ScannerProfile& profile, int position, const RayCaster* model);
  void clear();
  void setColour(const QColor& colour);

 private:
  struct Drawing;
  void draw(const Drawing& drawing);

  Scene& scene_;
  vtkSmartPointer<vtkActor> rays_;
  vtkSmartPointer<vtkActor> head_;
  vtkSmartPointer<vtkActor> receivers_;
};

}  // namespace vantage
