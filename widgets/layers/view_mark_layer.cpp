#include "layers/view_mark_layer.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include "vtk/poly_data.h"

namespace vantage {
namespace {

constexpr double kInFront = 2.0;
constexpr double kOpacity = 0.75;

}  // namespace

Mesh surfaceOfView(const Model& model, std::uint32_t view) {
  Mesh surface;
  std::vector<std::uint32_t> of(model.mesh.vertices.size(), kNoIndex);
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
    if (model.triangleView[t] != view) continue;
    Triangle triangle = model.mesh.triangles[t];
    for (std::uint32_t& corner : triangle) {
      std::uint32_t& index = of[corner];
      if (index == kNoIndex) {
        index = static_cast<std::uint32_t>(surface.vertices.size());
        surface.vertices.push_back(model.mesh.vertices[corner]);
      }
      corner = index;
    }
    surface.triangles.push_back(triangle);
  }
  return surface;
}

ViewMarkLayer::ViewMarkLayer(Scene& scene) : scene_(scene), surface_(makeActor()) {
  scene.add(*surface_);
  surface_->GetProperty()->SetOpacity(kOpacity);
  setInFront(*surface_, kInFront);
  setTheme(lightTheme());
}

void ViewMarkLayer::set(const std::shared_ptr<const ModelGeometry>& geometry, std::optional<std::uint32_t> view) {
  scene_.change([this, geometry, view] { show(geometry && view ? surfaceOfView(*geometry->model, *view) : Mesh{}); });
}

void ViewMarkLayer::setPart(const std::shared_ptr<const Mesh>& part) {
  scene_.change([this, part] { show(part ? *part : Mesh{}); });
}

void ViewMarkLayer::show(const Mesh& marked) {
  setData(*surface_, marked.triangles.empty() ? nullptr : toPolyData(marked, true).Get());
  surface_->SetVisibility(!marked.triangles.empty());
}

void ViewMarkLayer::setColour(const Rgb& colour) {
  scene_.change([this, colour] { vantage::setColour(*surface_, colour); });
}

void ViewMarkLayer::setTheme(const Theme& theme) {
  setColour(toRgb(theme.examined));
}

}  // namespace vantage
