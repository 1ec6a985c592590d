#pragma once

#include <QWidget>

#include "erase/erase_desk.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QShortcut;
class QToolButton;

namespace vantage {

class RegionDrawing;

/// The row over the model view in which the operator erases what is not the object: says how, draws it on the view,
/// sees what would go, and confirms it.
class EraseBar final : public QWidget {
  Q_OBJECT

 public:
  /// @param view that is drawn on; must outlive it
  /// @param pane that both are in
  EraseBar(EraseDesk& desk, ModelView& view, QWidget* pane);

  void begin(EraseTool tool);
  /// As it was left, or with the lasso.
  void begin() { begin(tool_); }
  void end();

 private:
  void choose(EraseTool tool);
  void ask();
  void refresh();
  [[nodiscard]] QString howTo() const;
  [[nodiscard]] QString answer() const;

  EraseDesk& desk_;
  RegionDrawing* drawing_;
  EraseTool tool_ = EraseTool::Lasso;
  QList<QToolButton*> tools_;
  QDoubleSpinBox* height_;
  QDoubleSpinBox* largest_;
  QCheckBox* front_;
  QLabel* said_;
  QPushButton* erase_;
  QPushButton* end_;
  QShortcut* escape_;
};

}  // namespace vantage
