#pragma once

#include <optional>

#include "acquisition/stand_advice.h"
#include "vtk/render_surface.h"
#include "wizard/wizard_page.h"

class QLabel;
class QPushButton;

namespace vantage {

class FigureTable;
class StandDesk;
class StandSides;
class StandView;
struct StandProspect;
struct Theme;

/// Turning the object over: the side to put it on next, what that would show, and what to mind. No step of the way
/// through the wizard: one comes here from acquiring or reviewing, and goes on acquiring.
class TurnOverPage final : public WizardPage {
  Q_OBJECT

 public:
  TurnOverPage(SessionController& controller, StandDesk& desk, const SurfaceMaker& surfaces, QWidget* parent = nullptr);

  [[nodiscard]] QString key() const override { return QStringLiteral("turn_over"); }
  [[nodiscard]] QString title() const override { return tr("Turn the object over"); }
  [[nodiscard]] QString whatNext() const override;
  [[nodiscard]] QString nextText() const override { return tr("&Next: review"); }
  [[nodiscard]] bool complete() const override;
  [[nodiscard]] bool applies() const override { return false; }
  void entered() override;

  void setTheme(const Theme& theme);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void build();
  void look();
  void refresh();
  void showProspect();
  void showSide(int side);
  void takePictures();
  [[nodiscard]] std::optional<StandAdvice> side() const;
  [[nodiscard]] QString summary() const;
  [[nodiscard]] QString toMind() const;

  StandDesk& desk_;
  QLabel* summary_;
  QPushButton* again_;
  StandView* view_;
  QLabel* sidesTitle_;
  StandSides* sides_;
  FigureTable* figures_;
  QLabel* mind_;
  QPushButton* turned_;
  std::shared_ptr<const StandProspect> pictured_;
};

}  // namespace vantage
