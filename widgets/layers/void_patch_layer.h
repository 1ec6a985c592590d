#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "layers/model_options.h"
#include "planning/plan.h"
#include "vtk/camera.h"
#include "vtk/scene.h"

namespace vantage {

/// The void patches of a plan in a scene.
class VoidPatchLayer {
 public:
  explicit VoidPatchLayer(Scene& scene);

  void set(std::shared_ptr<const Plan> plan, VoidColouring colouring);  ///< null for none
  void setVisible(bool visible);
  /// Takes away what is before a plane; nothing takes nothing away.
  void setSection(const std::optional<Section>& section);
  void setTheme(const Theme& theme);
  void highlight(const std::vector<std::uint32_t>& patches);

  /// The patch that a line meets first, and how far along [mm].
  struct Pick {
    std::uint32_t patch;
    double distance;
  };
  [[nodiscard]] std::optional<Pick> pick(const SightLine& line) const;

 private:
  Scene& scene_;
  std::shared_ptr<const Plan> plan_;
  VoidColouring colouring_ = VoidColouring::EdgeClass;
  vtkSmartPointer<vtkActor> patches_;
  vtkSmartPointer<vtkActor> highlighted_;
  std::optional<Section> section_;
  bool visible_ = true;
};

}  // namespace vantage
