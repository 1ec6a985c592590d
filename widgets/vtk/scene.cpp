#include "vtk/scene.h"

#include <vtkActor.h>
#include <vtkAutoInit.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

Scene::Scene() : renderer_(vtkSmartPointer<vtkRenderer>::New()), theme_(&lightTheme()) {
  renderer_->SetAutomaticLightCreation(false);
  addLight(*renderer_, {-0.4, 0.6, 1.0}, 0.85);
  addLight(*renderer_, {0.9, -0.2, 0.6}, 0.3);
  renderer_->SetGradientBackground(true);
  renderer_->SetUseFXAA(true);
  setTheme(lightTheme());
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

void Scene::change(Change change) {
  if (!deferred_) return change();
  const std::lock_guard lock(mutex_);
  waiting_.push_back(std::move(change));
}

void Scene::deferChanges(bool defer) {
  deferred_ = defer;
  if (!defer) carryOutChanges();
}

// Taken out first: nobody waits for the lock while they are carried out.
void Scene::carryOutChanges() {
  std::vector<Change> changes;
  {
    const std::lock_guard lock(mutex_);
    changes.swap(waiting_);
  }
  for (const Change& change : changes) change();
}

void Scene::setMoving(bool moving) {
  change([this, moving] { renderer_->SetUseFXAA(!moving); });
}

void Scene::setTheme(const Theme& theme) {
  theme_ = &theme;
  change([this, &theme] {
    renderer_->SetBackground(components(theme.backgroundBottom).data());
    renderer_->SetBackground2(components(theme.backgroundTop).data());
  });
}

void Scene::prepare(const Camera& camera, double pixelRatio) {
  carryOutChanges();
  vtkCamera& shown = *renderer_->GetActiveCamera();
  shown.SetParallelProjection(camera.parallel);
  shown.SetParallelScale(camera.distance() * std::tan(0.5 * camera.viewAngle));
  const Vec3 eye = camera.parallel ? Vec3(camera.target - parallelStart(camera) * camera.forward()) : camera.eye;
  shown.SetPosition(eye.data());
  shown.SetFocalPoint(camera.target.data());
  shown.SetViewUp(camera.up.data());
  shown.SetViewAngle(degrees(camera.viewAngle));
  for (const Line& line : lines_) line.actor->GetProperty()->SetLineWidth(static_cast<float>(line.width * pixelRatio));
  renderer_->ResetCameraClippingRange();
}

}  // namespace vantage
