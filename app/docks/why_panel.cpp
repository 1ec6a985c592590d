#include "docks/why_panel.h"

#include <QVBoxLayout>

#include "form_parts.h"
#include "views/scanner_picture_view.h"
#include "why_card.h"

namespace vantage {
namespace {

constexpr int kLeastWidth = 240;

}  // namespace

WhyPanel::WhyPanel(PositionInspector& inspector, QWidget* parent)
    : QScrollArea(parent),
      inspector_(inspector),
      title_(makeLabel({}, "title")),
      verdict_(makeLabel({})),
      figures_(new FigureTable),
      sightsTitle_(makeLabel(tr("Unseen edges from there"), "section")),
      sights_(new FigureTable),
      comparison_(makeLabel({})),
      picture_(new ScannerPictureView) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  for (QWidget* part : {static_cast<QWidget*>(title_), static_cast<QWidget*>(verdict_), static_cast<QWidget*>(figures_),
                        static_cast<QWidget*>(comparison_), static_cast<QWidget*>(sightsTitle_),
                        static_cast<QWidget*>(sights_), static_cast<QWidget*>(picture_)})
    column->addWidget(part);
  column->addStretch();
  picture_->setMinimumHeight(220);
  setMinimumWidth(kLeastWidth);
  setWidget(content);
  connect(&inspector, &PositionInspector::changed, this, &WhyPanel::refresh);
  refresh();
}

void WhyPanel::setTheme(const Theme& theme) {
  picture_->setTheme(theme);
}

void WhyPanel::refresh() {
  figures_->clear();
  sights_->clear();
  const auto& insight = inspector_.insight();
  const bool told = insight.has_value();
  const bool computed = told && insight->sight;
  for (QWidget* part : {static_cast<QWidget*>(sightsTitle_), static_cast<QWidget*>(sights_)})
    part->setVisible(computed);
  picture_->setVisible(told && insight->picture);
  comparison_->setVisible(told);
  if (!told) {
    title_->setText(tr("No position yet"));
    verdict_->setText(
        tr("Once a view is planned it is explained here. Click any position in the objective to ask why it was not "
           "proposed."));
    return;
  }
  const WhyCard card = makeWhyCard(*insight);
  title_->setText(card.title);
  verdict_->setText(card.verdict);
  for (const WhyFigure& f : card.figures) figures_->add(f.name, f.value, f.remark);
  for (const WhyFigure& f : card.sights) sights_->add(f.name, f.value, f.remark);
  comparison_->setText(card.comparison);
  if (insight->picture)
    picture_->setPicture(insight->picture, tr("What the scanner would see from %1").arg(insight->why.position));
}

}  // namespace vantage
