#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "docks/model_pane.h"
#include "docks/positional_pane.h"
#include "layers/positional_links.h"
#include "position_inspector.h"
#include "session_controller.h"
#include "views/objective_view.h"
#include "views/unrolled_map_view.h"

namespace vantage {

/// The views of a session, kept on the moment that the controller shows, and linked: a cell of positional space lights
/// up the patches seen through it, a patch its cells, a position of the objective is explained.
class SessionViews final : public QObject {
  Q_OBJECT

 public:
  SessionViews(SessionController& controller, PositionInspector& inspector, JobRunner& jobs,
               const SurfaceMaker& surfaces, QObject* parent = nullptr);

  [[nodiscard]] ModelPane& model() { return *model_; }
  [[nodiscard]] PositionalPane& space() { return *space_; }
  [[nodiscard]] UnrolledMapView& map() { return *map_; }
  [[nodiscard]] ObjectiveView& objective() { return *objective_; }

  void setTheme(const Theme& theme);
  void setNavigation(NavigationScheme scheme);
  /// Lights up what a scan brought to the model, and asks about its position; unset for none.
  void showScan(std::optional<std::int64_t> scan);
  /// Lights up the void patches that are left for a reason.
  void showEdges(EdgeReason reason);
  /// Asks about a position; unset for none.
  void examine(std::optional<int> position);

 signals:
  void positionExamined(int position);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void connectViews();
  void refresh();
  void showSnapshot(const SharedSnapshot& snapshot);
  void requestImages();
  void pickCell(const vantage::MapCell& cell);
  void pickPatch(std::uint32_t patch);

  SessionController& controller_;
  PositionInspector& inspector_;
  JobRunner& jobs_;
  std::shared_ptr<GeometryStore> geometries_;
  ModelPane* model_;
  PositionalPane* space_;
  UnrolledMapView* map_;
  ObjectiveView* objective_;
  SharedSnapshot snapshot_;
  std::shared_ptr<const PositionalLinks> links_;
  JobRunner::Id imagesJob_ = 0;
  int question_ = 0;
};

}  // namespace vantage
