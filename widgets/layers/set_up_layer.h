#pragma once

#include <vtkSmartPointer.h>

#include <memory>

#include "geometry/mesh.h"
#include "scanner/profile.h"
#include "vtk/scene.h"

namespace vantage {

/// What stands ready before the first scan: the viewing volume, and the object where that is known, as of glass.
class SetUpLayer {
 public:
  explicit SetUpLayer(Scene& scene);

  /// Both may be null.
  void set(const ScannerProfile* profile, const std::shared_ptr<const Mesh>& object);
  void setTheme(const Theme& theme);

 private:
  Scene& scene_;
  vtkSmartPointer<vtkActor> volume_;
  vtkSmartPointer<vtkActor> object_;
};

}  // namespace vantage
