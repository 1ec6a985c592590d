#pragma once

#include <QDialog>

#include "stands/picked_points.h"
#include "stands/stand_inspector.h"
#include "vtk/navigation.h"
#include "vtk/render_surface.h"

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace vantage {

class PointPicker;
class PoseChooser;
class SessionController;

/// What the views of the dialog are made with.
struct StandLook {
  SurfaceMaker surfaces;
  const Theme& theme;
  NavigationScheme navigation = NavigationScheme::MeshLab;
};

/// How the stands lie in each other: the poses that were found of a stand that is not in place yet, to look at and to
/// choose from; or points picked on both, to align from. Everything that is done is a step of the session.
class StandDialog final : public QDialog {
  Q_OBJECT

 public:
  /// @param stand that is shown first
  StandDialog(SessionController& controller, JobRunner& jobs, const StandLook& look, int stand,
              QWidget* parent = nullptr);

  /// Goes back from picking; stops what is under way; closes only when nothing is.
  void reject() override;

  [[nodiscard]] StandInspector& inspector() { return *inspector_; }
  [[nodiscard]] PoseChooser& poses() { return *poses_; }
  [[nodiscard]] PointPicker& picker() { return *picker_; }

 private:
  void build(JobRunner& jobs);
  void connectParts();
  void showStand(int stand);
  void showAlignment();
  void showPicking(bool picking);
  void alignFrom(const PickedPairs& pairs);
  void refresh();
  [[nodiscard]] bool isKnown() const;
  [[nodiscard]] std::shared_ptr<const StandAlignment> alignment() const;
  [[nodiscard]] QString whyNot() const;

  SessionController& controller_;
  JobRunner& jobs_;
  const Theme& theme_;
  int stand_;
  std::shared_ptr<const StandAlignment> shown_;
  StandInspector* inspector_;
  QComboBox* choice_;
  QLabel* verdict_;
  QLabel* complaint_;
  QStackedWidget* pages_;
  PoseChooser* poses_;
  PointPicker* picker_;
  QPushButton* search_;
  QPushButton* pick_;
  QPushButton* close_;
};

}  // namespace vantage
