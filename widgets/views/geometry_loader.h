#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "layers/model_geometry.h"
#include "views/background_work.h"

namespace vantage {

/// Models made ready to be drawn and picked, as long as somebody uses them: views that show the same model share it.
/// May be used from any thread.
class GeometryStore {
 public:
  [[nodiscard]] std::shared_ptr<const ModelGeometry> find(const std::shared_ptr<const Model>& model);
  void keep(const std::shared_ptr<const ModelGeometry>& geometry);
  /// To be held while a model is made ready: of views that show the same model one does it, the others find it then.
  [[nodiscard]] std::mutex& turn() { return turn_; }

 private:
  std::mutex turn_;
  std::mutex mutex_;
  std::vector<std::weak_ptr<const ModelGeometry>> geometries_;
};

/// Makes the models of a view ready beside the UI thread.
class GeometryLoader {
 public:
  using Show = std::function<void(const std::shared_ptr<const ModelGeometry>&)>;

  explicit GeometryLoader(std::shared_ptr<GeometryStore> store);

  /// Calls `show` when the model is ready, at once where it is already. A large model is shown as soon as it can be
  /// drawn, again when it has its colours and can be picked, and again when it has its stand-in.
  /// @param state whose model; null, or without one, shows nothing
  void load(const std::shared_ptr<const AcquisitionState>& state, const Show& show,
            const BackgroundWork::Failed& failed);
  void finish() { work_.finish(); }

 private:
  std::shared_ptr<GeometryStore> store_;
  BackgroundWork work_;
};

}  // namespace vantage
