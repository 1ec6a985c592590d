#pragma once

#include <QWidget>

#include "stands/picked_points.h"
#include "stands/stand_inspector.h"
#include "vtk/navigation.h"
#include "vtk/render_surface.h"

class QLabel;
class QPushButton;

namespace vantage {

class CompositeView;

/// Object and stand side by side, to click the same places on both.
class PointPicker final : public QWidget {
  Q_OBJECT

 public:
  PointPicker(const SurfaceMaker& surfaces, const Theme& theme, NavigationScheme navigation, QWidget* parent = nullptr);

  void showSurfaces(const ComparedStand& stand);
  /// Why nothing can be aligned now; empty: it can, once there are points enough.
  void setWhyNot(const QString& whyNot);
  /// What is wrong with the points; empty: nothing.
  void complain(const QString& why);

  [[nodiscard]] const PickedPoints& points() const { return points_; }
  [[nodiscard]] CompositeView& view(PickSide side) { return side == PickSide::Object ? *object_ : *stand_; }

 signals:
  void alignRequested(const vantage::PickedPairs& pairs);

 private:
  void build();
  void pick(PickSide side, const Vec3& point);
  void removeLast();
  void refresh();

  PickedPoints points_;
  CompositeView* object_;
  CompositeView* stand_;
  QLabel* next_;
  QLabel* complaint_;
  QPushButton* remove_;
  QPushButton* align_;
  QString whyNot_;
};

}  // namespace vantage
