#pragma once

#include <QWidget>

#include "views/model_view.h"

class QComboBox;
class QLayout;
class QToolButton;
class QVBoxLayout;

namespace vantage {

/// The model view with what it can show: colours, layers, camera.
class ModelPane final : public QWidget {
  Q_OBJECT

 public:
  ModelPane(const SurfaceMaker& surfaces, const std::shared_ptr<GeometryStore>& store, QWidget* parent = nullptr);

  [[nodiscard]] ModelView& view() { return *view_; }
  /// Shows it; offers the colours of its scans where they saw some, and its stands where there are several.
  void setSnapshot(const SharedSnapshot& snapshot);
  /// A line over the view, for instance that an earlier moment is shown; empty hides it.
  void setNotice(const QString& text);
  /// A row of its own between the bar and the view, which becomes the pane's.
  void addRow(QWidget& row);

 signals:
  void eraseWanted();
  void noticeClicked();

 private:
  QComboBox* addChoice(QLayout& bar, const QString& name, const QStringList& options,
                       const std::function<void(ModelViewOptions&, int)>& apply);
  void addSwitch(QLayout& bar, const QString& text, const QString& help, bool ModelViewOptions::*value);
  void addCamera(QLayout& bar);
  void addErase(QLayout& bar);
  void offer(ModelColouring colouring, const QString& text, bool offered);
  void showColouring();

  ModelView* view_;
  QComboBox* colouring_ = nullptr;
  QToolButton* notice_;
  QVBoxLayout* column_;
};

}  // namespace vantage
