#include "docks/view_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>

#include "docks/model_pane.h"
#include "docks/section_bar.h"
#include "form_parts.h"
#include "scenes/tool_notes.h"

namespace vantage {

ViewActions::ViewActions(ModelPane& pane)
    : QObject(&pane),
      pane_(pane),
      sectionBar_(new SectionBar),
      measureBar_(new QWidget),
      measured_(makeLabel({})),
      again_(makeButton(tr("Measure anew"), QStringLiteral("measureAgain"), tr("Forgets both places."))) {
  wireframe = add(tr("&Wireframe"), tr("Ctrl+Shift+W"), tr("Only the edges of the triangles"));
  points = add(tr("&Points"), tr("Ctrl+Shift+P"), tr("Only the corners of the triangles"));
  backFaces = add(tr("&Back faces in red"), tr("Ctrl+Shift+B"), tr("Where a surface is seen from its inside"));
  parallel = add(tr("Parallel p&rojection"), tr("Ctrl+Shift+G"), tr("What is far is as large as what is near"));
  section = add(tr("&Cut by a plane"), tr("Ctrl+Shift+X"), tr("Takes away what is on one side of a plane"));
  measure = add(tr("&Measure between two places"), tr("Ctrl+M"), tr("Click two places on the surface"));
  auto* styles = new QActionGroup(this);
  styles->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  styles->addAction(wireframe);
  styles->addAction(points);
  auto* row = new QHBoxLayout(measureBar_);
  row->setContentsMargins(6, 0, 6, 4);
  row->addWidget(measured_, 1);
  row->addWidget(again_);
  measureBar_->setObjectName(QStringLiteral("measureBar"));
  measured_->setObjectName(QStringLiteral("measured"));
  for (QWidget* bar : {static_cast<QWidget*>(sectionBar_), measureBar_}) {
    bar->hide();
    pane.addRow(*bar);
  }
  for (QAction* action : {wireframe, points, backFaces, parallel})
    connect(action, &QAction::toggled, this, &ViewActions::apply);
  connect(section, &QAction::toggled, this, &ViewActions::cut);
  connect(sectionBar_, &SectionBar::edited, this, &ViewActions::apply);
  connect(measure, &QAction::toggled, this, [this](bool on) {
    measureBar_->setVisible(on);
    pane_.view().setMeasuring(on);
    if (on) pane_.view().setFocus();
  });
  connect(again_, &QPushButton::clicked, this, [this] { pane_.view().setMeasuring(true); });
  connect(&pane.view(), &ModelView::measuredChanged, this, &ViewActions::tellMeasure);
  connect(&pane.view(), &ModelView::loadingChanged, this, [this](bool loading) {
    if (!loading && section->isChecked()) sectionBar_->setBox(pane_.view().modelBox());
  });
  tellMeasure();
}

QAction* ViewActions::add(const QString& text, const QString& key, const QString& help) {
  auto* action = new QAction(text, this);
  action->setShortcut(key);
  action->setCheckable(true);
  action->setStatusTip(help);
  all_ << action;
  return action;
}

void ViewActions::addTo(QMenu& menu) {
  for (QAction* action : all_) {
    menu.addAction(action);
    if (action == points || action == parallel) menu.addSeparator();
  }
}

void ViewActions::apply() {
  ModelView& view = pane_.view();
  ModelViewOptions options = view.options();
  options.style = wireframe->isChecked() ? SurfaceStyle::Wireframe
                  : points->isChecked()  ? SurfaceStyle::Points
                                         : SurfaceStyle::Filled;
  options.backFaces = backFaces->isChecked();
  options.section = section->isChecked() ? std::optional(sectionBar_->section()) : std::nullopt;
  view.showParallel(parallel->isChecked());
  view.setOptions(options);
}

void ViewActions::cut() {
  if (section->isChecked()) sectionBar_->setBox(pane_.view().modelBox());
  sectionBar_->setVisible(section->isChecked());
  apply();
}

void ViewActions::tellMeasure() {
  const std::vector<Vec3>& places = pane_.view().measured();
  measured_->setText(places.size() == 2 ? tr("From 1 to 2: %1").arg(distanceText(places[0], places[1]))
                     : places.empty()   ? tr("Click the first place on the surface.")
                                        : tr("Click the second place on the surface."));
  allow(*again_, places.empty() ? tr("Nothing was measured yet.") : QString());
}

}  // namespace vantage
