#include "layers/model_layer.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

namespace vantage {
namespace {

constexpr double kBoundaryWidth = 2.0;
constexpr double kBoundaryInFront = 4.0;

// The inside of a surface, which no scanner has seen, is darker and colder.
vtkSmartPointer<vtkProperty> insideOf(const QColor& surface) {
  auto inside = vtkSmartPointer<vtkProperty>::New();
  inside->SetColor(0.55 * surface.redF(), 0.60 * surface.greenF(), 0.75 * surface.blueF());
  inside->SetAmbient(0.2);
  inside->SetDiffuse(0.8);
  return inside;
}

}  // namespace

ModelLayer::ModelLayer(Scene& scene) : surface_(makeActor()), coarse_(makeActor()), boundary_(makeActor()) {
  scene.add(*surface_);
  scene.add(*coarse_);
  scene.addLines(*boundary_, kBoundaryWidth);
  setUnlit(*boundary_);
  setInFront(*boundary_, kBoundaryInFront);
  setTheme(lightTheme());
  update();
}

void ModelLayer::set(std::shared_ptr<const ModelGeometry> geometry, ModelColouring colouring, std::size_t views) {
  geometry_ = std::move(geometry);
  setData(*surface_, geometry_ ? geometry_->coloured(colouring, views).Get() : nullptr);
  setData(*coarse_, geometry_ ? geometry_->colouredCoarse(colouring, views).Get() : nullptr);
  setData(*boundary_, geometry_ ? geometry_->boundary.Get() : nullptr);
  update();
}

void ModelLayer::setVisible(bool surface, bool boundary) {
  surfaceVisible_ = surface;
  boundaryVisible_ = boundary;
  update();
}

void ModelLayer::setMoving(bool moving) {
  moving_ = moving;
  update();
}

void ModelLayer::update() {
  const bool useCoarse = moving_ && geometry_ && geometry_->coarse != nullptr;
  surface_->SetVisibility(geometry_ && surfaceVisible_ && !useCoarse);
  coarse_->SetVisibility(surfaceVisible_ && useCoarse);
  boundary_->SetVisibility(geometry_ && boundaryVisible_);
}

void ModelLayer::setTheme(const Theme& theme) {
  for (vtkActor* actor : {surface_.Get(), coarse_.Get()}) {
    setColour(*actor, toRgb(theme.surface));
    actor->SetBackfaceProperty(insideOf(theme.surface));
  }
  setColour(*boundary_, toRgb(theme.boundary));
}

void ModelLayer::setOpacity(double opacity) {
  for (vtkActor* actor : {surface_.Get(), coarse_.Get()}) actor->GetProperty()->SetOpacity(opacity);
}

}  // namespace vantage
