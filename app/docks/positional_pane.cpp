#include "docks/positional_pane.h"

#include <QComboBox>
#include <QVBoxLayout>

#include "window/flow_layout.h"

namespace vantage {
namespace {

struct Direction {
  const char* text;
  double phi;  // [degrees]
  double psi;
};
// The directions that a cell can be looked at in; the first entry of the box is all of them.
constexpr Direction kDirections[] = {{QT_TRANSLATE_NOOP("vantage::PositionalPane", "Straight out"), 0, 0},
                                     {QT_TRANSLATE_NOOP("vantage::PositionalPane", "15° to the left"), 15, 0},
                                     {QT_TRANSLATE_NOOP("vantage::PositionalPane", "15° to the right"), -15, 0},
                                     {QT_TRANSLATE_NOOP("vantage::PositionalPane", "15° up"), 0, 15},
                                     {QT_TRANSLATE_NOOP("vantage::PositionalPane", "15° down"), 0, -15}};

}  // namespace

PositionalPane::PositionalPane(const SurfaceMaker& surfaces, const std::shared_ptr<GeometryStore>& store,
                               QWidget* parent)
    : QWidget(parent),
      view_(new PositionalSpaceView(surfaces, nullptr, store)),
      kind_(new QComboBox),
      direction_(new QComboBox) {
  kind_->addItems({tr("Void, P_v"), tr("Seen, P_s"), tr("Scanner, P_c")});
  kind_->setAccessibleName(tr("Image in positional space"));
  direction_->addItem(tr("All directions"));
  for (const Direction& direction : kDirections) direction_->addItem(tr(direction.text));
  direction_->setAccessibleName(tr("Direction"));
  auto* bar = new FlowLayout(6);
  bar->setContentsMargins(6, 4, 6, 4);
  bar->addWidget(kind_);
  bar->addWidget(direction_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(bar);
  column->addWidget(view_, 1);
  connect(kind_, &QComboBox::currentIndexChanged, this, &PositionalPane::apply);
  connect(direction_, &QComboBox::currentIndexChanged, this, &PositionalPane::apply);
}

void PositionalPane::setPosition(std::optional<int> position) {
  position_ = position;
  if (kind_->currentIndex() == static_cast<int>(PositionalImageKind::Scanner)) apply();
}

void PositionalPane::apply() {
  PositionalViewOptions options = view_->options();
  options.kind = static_cast<PositionalImageKind>(kind_->currentIndex());
  options.direction.reset();
  if (const int chosen = direction_->currentIndex() - 1; chosen >= 0)
    options.direction =
        DirectionWindow{radians(kDirections[chosen].phi), radians(kDirections[chosen].psi), radians(8.0)};
  options.position = position_;
  view_->setOptions(options);
  emit optionsChanged(options);
}

}  // namespace vantage
