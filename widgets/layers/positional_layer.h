#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "layers/cell_field.h"
#include "vtk/scene.h"

namespace vantage {

/// The surface of positional space in a scene, its cells in the colours of a field. The far half is seen from inside,
/// the half toward the eye is a veil.
class PositionalLayer {
 public:
  explicit PositionalLayer(Scene& scene);

  /// @param grid null for none; @param field null leaves the cells empty
  void set(const PositionalSpaceGrid* grid, const CellField* field);
  void highlight(const std::vector<std::uint32_t>& cells);  ///< row * columns + column
  void setTheme(const Theme& theme);

  /// The cell that is seen under a line: of the far half.
  [[nodiscard]] std::optional<MapCell> pick(const SightLine& line) const;

 private:
  Scene& scene_;
  std::vector<std::array<Vec3, 4>> quads_;
  int columns_ = 0;
  vtkSmartPointer<vtkActor> far_;
  vtkSmartPointer<vtkActor> near_;
  vtkSmartPointer<vtkActor> highlighted_;
};

}  // namespace vantage
