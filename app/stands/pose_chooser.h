#pragma once

#include <QWidget>

#include "stands/stand_inspector.h"
#include "vtk/navigation.h"
#include "vtk/render_surface.h"

class QListWidget;
class QPushButton;

namespace vantage {

class CompositeView;

/// The poses that were found of a stand: small pictures with their numbers, the one that is chosen over the object in
/// the view beside them.
class PoseChooser final : public QWidget {
  Q_OBJECT

 public:
  PoseChooser(const SurfaceMaker& surfaces, const Theme& theme, NavigationScheme navigation, QWidget* parent = nullptr);

  void showSurfaces(const ComparedStand& stand);
  /// The best pose is shown, or the one in use. Null: none was looked for yet.
  void setAlignment(const std::shared_ptr<const StandAlignment>& alignment);
  void setLook(int pose, const PoseLook& look);
  /// Why no pose can be used now; empty: one can.
  void setWhyNot(const QString& whyNot);

  /// The pose that is shown; nothing without any.
  [[nodiscard]] std::optional<int> current() const;

 signals:
  void useRequested(int pose, bool despite);

 private:
  void build();
  void showCurrent();
  void refreshUse();

  const Theme& theme_;
  CompositeView* view_;
  QListWidget* list_;
  QPushButton* use_;
  std::shared_ptr<const StandAlignment> alignment_;
  std::vector<PoseLook> looks_;
  QString whyNot_;
};

}  // namespace vantage
