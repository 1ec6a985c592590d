#pragma once

#include <optional>
#include <vector>

#include "scanner/profile.h"
#include "vtk/scene.h"

namespace vantage {

/// The turntable as a disc on z = 0 with degrees on its rim and circles every 50 mm, and an arrow for either position.
class TurntableLayer {
 public:
  explicit TurntableLayer(Scene& scene);

  void set(const ScannerProfile* profile);  ///< null for none
  /// Azimuths [rad] of the last and the proposed view are marked on the rim; unset: no mark.
  void mark(std::optional<double> current, std::optional<double> proposed);
  void setVisible(bool visible);
  void setTheme(const Theme& theme);

 private:
  [[nodiscard]] std::vector<vtkActor*> actors() const;

  Scene& scene_;
  vtkSmartPointer<vtkActor> disc_;
  vtkSmartPointer<vtkActor> lines_;
  vtkSmartPointer<vtkActor> labels_;
  vtkSmartPointer<vtkActor> current_;
  vtkSmartPointer<vtkActor> proposed_;
  double radius_ = 0.0;
};

}  // namespace vantage
