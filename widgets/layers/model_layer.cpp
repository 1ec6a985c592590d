#include "layers/model_layer.h"

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

namespace vantage {
namespace {

constexpr double kBoundaryWidth = 2.0;
constexpr double kBoundaryInFront = 4.0;
constexpr float kPointSize = 3.0F;
constexpr Rgb kBackFace{0xC8, 0x24, 0x2C};

// The inside of a surface, which no scanner has seen, is darker and colder.
vtkSmartPointer<vtkProperty> insideOf(const QColor& surface) {
  auto inside = vtkSmartPointer<vtkProperty>::New();
  inside->SetColor(0.55 * surface.redF(), 0.60 * surface.greenF(), 0.75 * surface.blueF());
  inside->SetAmbient(0.2);
  inside->SetDiffuse(0.8);
  return inside;
}

}  // namespace

ModelLayer::ModelLayer(Scene& scene)
    : scene_(scene), surface_(makeActor()), coarse_(makeActor()), inside_(makeActor()), boundary_(makeActor()) {
  scene.add(*surface_);
  scene.add(*coarse_);
  scene.add(*inside_);
  inside_->GetMapper()->SetScalarVisibility(false);
  inside_->GetProperty()->SetFrontfaceCulling(true);
  setColour(*inside_, kBackFace);
  scene.addLines(*boundary_, kBoundaryWidth);
  setUnlit(*boundary_);
  setInFront(*boundary_, kBoundaryInFront);
  setTheme(lightTheme());
  update();
}

void ModelLayer::set(std::shared_ptr<const ModelGeometry> geometry, ModelColouring colouring, std::vector<int> stands) {
  if (geometry == geometry_ && colouring == colouring_ && stands == stands_) return;
  geometry_ = std::move(geometry);
  colouring_ = colouring;
  stands_ = std::move(stands);
  scene_.change([this, colouring, stands = stands_, shown = geometry_] {
    setData(*surface_, shown ? shown->coloured(colouring, stands).Get() : nullptr);
    setData(*inside_, shown ? shown->surface.Get() : nullptr);
    setData(*coarse_, shown ? shown->colouredCoarse(colouring, stands).Get() : nullptr);
    setData(*boundary_, shown ? shown->boundary.Get() : nullptr);
  });
  update();
}

void ModelLayer::setPose(const Pose& T_scene_model) {
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix->SetElement(row, column, T_scene_model.matrix()(row, column));
  scene_.change([this, matrix] {
    for (vtkActor* actor : {surface_.Get(), coarse_.Get(), inside_.Get(), boundary_.Get()})
      actor->SetUserMatrix(matrix);
  });
}

void ModelLayer::setVisible(bool surface, bool boundary) {
  surfaceVisible_ = surface;
  boundaryVisible_ = boundary;
  update();
}

void ModelLayer::setStyle(SurfaceStyle style, bool backFaces) {
  backFaces_ = backFaces;
  scene_.change([this, style, backFaces] {
    for (vtkActor* actor : {surface_.Get(), coarse_.Get(), inside_.Get()}) {
      vtkProperty& look = *actor->GetProperty();
      look.SetPointSize(kPointSize);
      if (style == SurfaceStyle::Wireframe)
        look.SetRepresentationToWireframe();
      else if (style == SurfaceStyle::Points)
        look.SetRepresentationToPoints();
      else
        look.SetRepresentationToSurface();
    }
    surface_->GetProperty()->SetBackfaceCulling(backFaces);
  });
  update();
}

void ModelLayer::setSection(const std::optional<Section>& section) {
  scene_.change([this, section] {
    for (vtkActor* actor : {surface_.Get(), coarse_.Get(), inside_.Get(), boundary_.Get()})
      setClip(*actor, section ? std::optional(section->plane()) : std::nullopt);
  });
}

void ModelLayer::setMoving(bool moving) {
  moving_ = moving;
  update();
}

void ModelLayer::update() {
  const bool useCoarse = moving_ && geometry_ && geometry_->coarse != nullptr;
  const bool surface = geometry_ && surfaceVisible_ && !useCoarse;
  const bool coarse = surfaceVisible_ && useCoarse;
  const bool boundary = geometry_ && boundaryVisible_;
  const bool inside = surface && backFaces_;
  scene_.change([this, surface, coarse, inside, boundary] {
    inside_->SetVisibility(inside);
    surface_->SetVisibility(surface);
    coarse_->SetVisibility(coarse);
    boundary_->SetVisibility(boundary);
  });
}

void ModelLayer::setTheme(const Theme& theme) {
  scene_.change([this, &theme] {
    for (vtkActor* actor : {surface_.Get(), coarse_.Get()}) {
      setColour(*actor, toRgb(theme.surface));
      actor->SetBackfaceProperty(insideOf(theme.surface));
    }
    setColour(*boundary_, toRgb(theme.boundary));
  });
}

}  // namespace vantage
