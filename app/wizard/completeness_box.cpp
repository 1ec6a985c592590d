#include "wizard/completeness_box.h"

#include <QProgressBar>
#include <QVBoxLayout>
#include <cmath>

#include "completeness_text.h"
#include "form_parts.h"

namespace vantage {

CompletenessBox::CompletenessBox(QWidget* parent)
    : QGroupBox(tr("How complete the model is"), parent),
      headline_(makeLabel({}, "section")),
      reached_(new QProgressBar),
      advice_(makeLabel({})),
      figures_(new FigureTable) {
  setObjectName(QStringLiteral("completeness"));
  advice_->setObjectName(QStringLiteral("completenessAdvice"));
  reached_->setObjectName(QStringLiteral("reachedShare"));
  reached_->setRange(0, 1000);
  reached_->setTextVisible(false);
  reached_->setMaximumHeight(10);
  reached_->setAccessibleName(tr("Covered of what the scanner reaches"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(headline_);
  column->addWidget(reached_);
  column->addWidget(advice_);
  column->addWidget(figures_);
}

void CompletenessBox::show(const CompletenessCard& card) {
  headline_->setText(card.headline);
  setRole(*headline_, card.good ? "good" : "section");
  reached_->setVisible(card.reached.has_value());
  reached_->setValue(static_cast<int>(std::lround(1000.0 * card.reached.value_or(0.0))));
  advice_->setText(card.advice);
  figures_->clear();
  for (const WhyFigure& figure : card.figures) figures_->add(figure.name, figure.value, figure.remark);
}

}  // namespace vantage
