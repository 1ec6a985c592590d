#pragma once

#include <vtkSmartPointer.h>

#include <vector>

#include "look/theme.h"
#include "vtk/scene.h"

class vtkFollower;

namespace vantage {

/// Numbered places in a scene: balls with their number beside them, always upright.
class MarkerLayer {
 public:
  static constexpr std::size_t kMost = 12;  ///< places that are shown

  explicit MarkerLayer(Scene& scene);

  /// @param places in the scene; the first has the number 1 @param size of a ball [mm]
  void set(const std::vector<Vec3>& places, double size);
  void setTheme(const Theme& theme);

 private:
  Scene& scene_;
  vtkSmartPointer<vtkActor> balls_;
  std::vector<vtkSmartPointer<vtkFollower>> numbers_;
};

}  // namespace vantage
