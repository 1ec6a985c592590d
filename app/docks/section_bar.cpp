#include "docks/section_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>
#include <utility>

namespace vantage {
namespace {

constexpr int kSectionSteps = 400;  // of the slider

}  // namespace

SectionBar::SectionBar(QWidget* parent)
    : QWidget(parent),
      axis_(new QComboBox),
      slider_(new QSlider(Qt::Horizontal)),
      at_(new QDoubleSpinBox),
      flipped_(new QCheckBox(tr("Other side"))) {
  setObjectName(QStringLiteral("sectionBar"));
  for (const char* axis : {"x", "y", "z"}) axis_->addItem(tr("Cut across %1").arg(QLatin1String(axis)));
  axis_->setAccessibleName(tr("Axis of the cut"));
  axis_->setToolTip(tr("The axis that the plane of the cut stands across."));
  slider_->setRange(0, kSectionSteps);
  slider_->setPageStep(kSectionSteps / 20);
  slider_->setMinimumWidth(60);
  slider_->setAccessibleName(tr("Place of the cut"));
  slider_->setToolTip(tr("Where the cut is; the arrow keys move it, too."));
  at_->setDecimals(1);
  at_->setSuffix(tr(" mm"));
  at_->setAccessibleName(tr("Place of the cut in millimetres"));
  at_->setToolTip(tr("Where on the axis the cut is."));
  flipped_->setToolTip(tr("Take away what is below the cut, not what is above."));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 0, 6, 4);
  row->addWidget(axis_);
  row->addWidget(slider_, 1);
  row->addWidget(at_);
  row->addWidget(flipped_);
  connect(axis_, &QComboBox::currentIndexChanged, this, [this] {
    fitRange(true);
    emit edited();
  });
  connect(slider_, &QSlider::valueChanged, this, &SectionBar::slide);
  connect(at_, &QDoubleSpinBox::valueChanged, this, &SectionBar::place);
  connect(flipped_, &QCheckBox::toggled, this, &SectionBar::edited);
}

void SectionBar::setBox(const BoundingBox& box) {
  if (box.min == box_.min && box.max == box_.max) return;
  box_ = box;
  fitRange(!std::exchange(placed_, true));
  emit edited();
}

Section SectionBar::section() const {
  return {axis_->currentIndex(), at_->value(), flipped_->isChecked()};
}

void SectionBar::fitRange(bool toMiddle) {
  const int axis = axis_->currentIndex();
  const double least = box_.min[axis];
  const double most = box_.max[axis];
  const QSignalBlocker quietPlace(at_);
  at_->setRange(std::floor(10.0 * least) / 10.0, std::ceil(10.0 * most) / 10.0);
  at_->setSingleStep(std::max(0.1, (most - least) / 100.0));
  if (toMiddle) at_->setValue(0.5 * (least + most));
  place(at_->value());
}

void SectionBar::slide(int step) {
  const double share = static_cast<double>(step) / kSectionSteps;
  at_->setValue(at_->minimum() + share * (at_->maximum() - at_->minimum()));
}

void SectionBar::place(double at) {
  const QSignalBlocker quiet(slider_);
  const double range = at_->maximum() - at_->minimum();
  slider_->setValue(range > 0.0 ? static_cast<int>(std::lround(kSectionSteps * (at - at_->minimum()) / range)) : 0);
  if (!at_->signalsBlocked()) emit edited();
}

}  // namespace vantage
