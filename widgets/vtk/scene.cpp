#include "vtk/scene.h"

#include <vtkActor.h>
#include <vtkAutoInit.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>

// Without it VTK makes renderers and mappers that draw nothing.
VTK_MODULE_INIT(vtkRenderingOpenGL2)

namespace vantage {
namespace {

std::array<double, 3> components(const QColor& colour) {
  return {colour.redF(), colour.greenF(), colour.blueF()};
}

// Lights that go with the camera: one from above its left, a weaker one from its right so that no side is black.
void addLight(vtkRenderer& renderer, const std::array<double, 3>& position, double intensity) {
  const auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToCameraLight();
  light->SetPosition(position.data());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(intensity);
  renderer.AddLight(light);
}

}  // namespace

Scene::Scene() : renderer_(vtkSmartPointer<vtkRenderer>::New()) {
  renderer_->SetAutomaticLightCreation(false);
  addLight(*renderer_, {-0.4, 0.6, 1.0}, 0.85);
  addLight(*renderer_, {0.9, -0.2, 0.6}, 0.3);
  renderer_->SetGradientBackground(true);
  renderer_->SetUseFXAA(true);
  setTheme(lightTheme());
  setCamera(camera_);
}

Scene::~Scene() = default;

vtkRenderer& Scene::renderer() {
  return *renderer_;
}

void Scene::add(vtkProp& prop) {
  renderer_->AddViewProp(&prop);
}

void Scene::addLines(vtkActor& actor, double width) {
  lines_.push_back({&actor, width});
  add(actor);
}

void Scene::setMoving(bool moving) {
  renderer_->SetUseFXAA(!moving);
}

void Scene::setTheme(const Theme& theme) {
  renderer_->SetBackground(components(theme.backgroundBottom).data());
  renderer_->SetBackground2(components(theme.backgroundTop).data());
}

void Scene::setCamera(const Camera& camera) {
  camera_ = camera;
  vtkCamera& shown = *renderer_->GetActiveCamera();
  shown.SetPosition(camera.eye.data());
  shown.SetFocalPoint(camera.target.data());
  shown.SetViewUp(camera.up.data());
  shown.SetViewAngle(degrees(camera.viewAngle));
}

void Scene::prepare(double pixelRatio) {
  for (const Line& line : lines_) line.actor->GetProperty()->SetLineWidth(static_cast<float>(line.width * pixelRatio));
  renderer_->ResetCameraClippingRange();
}

}  // namespace vantage
