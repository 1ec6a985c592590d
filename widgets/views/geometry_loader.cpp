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

void GeometryLoader::load(const std::shared_ptr<const Model>& model, const Show& show,
                          const BackgroundWork::Failed& failed) {
  work_.cancel();
  if (model == nullptr) return show(nullptr);
  const auto ready = store_->find(model);
  const bool complete = ready && (ready->coarse != nullptr || !needsStandIn(*model));
  if (ready) show(ready);
  if (complete) return;
  work_.start(
      [model, show, ready, store = store_](const Progress& progress, const BackgroundWork::Deliver& deliver) {
        auto geometry = ready ? ready : prepareModelGeometry(model, progress.part(0.0, 0.2));
        if (!ready) {
          store->keep(geometry);
          deliver([show, geometry] { show(geometry); });
        }
        const auto withCoarse = withStandIn(geometry, {}, progress.part(0.2, 1.0));
        if (withCoarse == geometry) return;
        store->keep(withCoarse);
        deliver([show, withCoarse] { show(withCoarse); });
      },
      failed);
}

}  // namespace vantage
