#pragma once

#include <vector>

#include "layers/marker_layer.h"

namespace vantage {

/// Two places on a surface and the straight line between them.
class MeasureLayer {
 public:
  explicit MeasureLayer(Scene& scene);

  /// @param places none, one or two @param size of a marker [mm]
  void set(const std::vector<Vec3>& places, double size);
  void setTheme(const Theme& theme);

 private:
  Scene& scene_;
  vtkSmartPointer<vtkActor> line_;
  MarkerLayer markers_;
};

}  // namespace vantage
