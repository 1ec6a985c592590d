#pragma once

#include <QList>
#include <QObject>

#include "layers/model_options.h"

class QAction;
class QLabel;
class QMenu;
class QPushButton;

namespace vantage {

class ModelPane;
class SectionBar;

/// The tools of the model view as actions, for a menu and the tool bar: how the surface is drawn, how it is projected,
/// a cut, and measuring. What a tool needs to be told stands in a bar above the view while it is on.
class ViewActions final : public QObject {
  Q_OBJECT

 public:
  /// @param pane outlives this
  explicit ViewActions(ModelPane& pane);

  void addTo(QMenu& menu);

  QAction* wireframe;
  QAction* points;
  QAction* backFaces;
  QAction* parallel;
  QAction* section;
  QAction* measure;

 private:
  QAction* add(const QString& text, const QString& key, const QString& help);
  void apply();
  void cut();
  void tellMeasure();

  ModelPane& pane_;
  QList<QAction*> all_;
  SectionBar* sectionBar_;
  QWidget* measureBar_;
  QLabel* measured_;
  QPushButton* again_;
};

}  // namespace vantage
