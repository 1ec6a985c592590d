#include "views/geometry_loader.h"

#include <algorithm>

namespace vantage {

std::shared_ptr<const ModelGeometry> GeometryStore::find(const std::shared_ptr<const Model>& model) {
  const std::lock_guard lock(mutex_);
  std::shared_ptr<const ModelGeometry> found;
  for (const auto& weak : geometries_) {
    auto geometry = weak.lock();
    // One with a stand-in is newer than, and as good as, one without.
    if (geometry && geometry->model == model && (!found || geometry->coarse != nullptr)) found = geometry;
  }
  return found;
}

void GeometryStore::keep(const std::shared_ptr<const ModelGeometry>& geometry) {
  const std::lock_guard lock(mutex_);
  std::erase_if(geometries_, [](const auto& weak) { return weak.expired(); });
  geometries_.push_back(geometry);
}

GeometryLoader::GeometryLoader(std::shared_ptr<GeometryStore> store)
    : store_(store ? std::move(store) : std::make_shared<GeometryStore>()) {}

void GeometryLoader::load(const std::shared_ptr<const AcquisitionState>& state, const Show& show,
                          const BackgroundWork::Failed& failed) {
  work_.cancel();
  if (state == nullptr || state->model == nullptr) return show(nullptr);
  const std::shared_ptr<const Model> model = state->model;
  const auto ready = store_->find(model);
  const bool complete = ready && (ready->coarse != nullptr || !needsStandIn(*model));
  if (ready) show(ready);
  if (complete) return;
  work_.start(
      [state, model, show, store = store_](const Progress& progress, const BackgroundWork::Deliver& deliver) {
        const auto present = [&](const std::shared_ptr<const ModelGeometry>& geometry) {
          deliver([show, geometry] { show(geometry); });
        };
        const std::lock_guard turn(store->turn());
        progress.checkpoint(0.0);
        auto geometry = store->find(model);
        if (!geometry) {
          geometry = prepareSurface(model);
          if (needsStandIn(*model)) present(geometry);
          geometry = withColours(geometry, *state, progress.part(0.1, 0.2));
          geometry = withPicking(geometry, progress.part(0.2, 0.3));
          store->keep(geometry);
        }
        present(geometry);
        if (geometry->coarse != nullptr || !needsStandIn(*model)) return;
        geometry = withStandIn(geometry, {}, progress.part(0.3, 1.0));
        store->keep(geometry);
        present(geometry);
      },
      failed);
}

}  // namespace vantage
