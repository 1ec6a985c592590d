#include "stands/point_picker.h"

#include <QHBoxLayout>
#include <QKeySequence>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "form_parts.h"
#include "layers/marker_layer.h"
#include "views/composite_view.h"

namespace vantage {
namespace {

constexpr std::size_t kLeastPairs = 3;

}  // namespace

PointPicker::PointPicker(const SurfaceMaker& surfaces, const Theme& theme, NavigationScheme navigation, QWidget* parent)
    : QWidget(parent),
      object_(new CompositeView(surfaces, tr("Object, to pick points on"))),
      stand_(new CompositeView(surfaces, tr("Stand, to pick points on"))),
      next_(makeLabel({}, "section")),
      complaint_(makeLabel({}, "warning")),
      remove_(makeButton(tr("&Remove last"), QStringLiteral("removePoint"),
                         tr("Takes back the point or pair that was picked last (Backspace)."))),
      align_(makeButton(tr("&Align from the points"), QStringLiteral("alignPicked"),
                        tr("The points are where the alignment begins. What it finds is checked as always."), true)) {
  for (CompositeView* view : {object_, stand_}) {
    view->setTheme(theme);
    view->setNavigation(navigation);
  }
  object_->setObjectName(QStringLiteral("pickObject"));
  stand_->setObjectName(QStringLiteral("pickStand"));
  object_->setTitle(tr("Object"));
  stand_->setTitle(tr("Stand"));
  remove_->setShortcut(QKeySequence(Qt::Key_Backspace));
  build();
  connect(object_, &CompositeView::surfacePicked, this, [this](const Vec3& p) { pick(PickSide::Object, p); });
  connect(stand_, &CompositeView::surfacePicked, this, [this](const Vec3& p) { pick(PickSide::Stand, p); });
  connect(remove_, &QPushButton::clicked, this, &PointPicker::removeLast);
  connect(align_, &QPushButton::clicked, this, [this] { emit alignRequested(points_.pairs()); });
  refresh();
}

void PointPicker::build() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(next_);
  auto* views = new QHBoxLayout;
  views->addWidget(object_, 1);
  views->addWidget(stand_, 1);
  column->addLayout(views, 1);
  complaint_->setObjectName(QStringLiteral("pickComplaint"));
  complaint_->hide();
  column->addWidget(complaint_);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(remove_);
  buttons->addWidget(align_);
  column->addLayout(buttons);
}

void PointPicker::showSurfaces(const ComparedStand& stand) {
  points_.clear();
  object_->showSurfaces(stand.object, nullptr);
  stand_->showSurfaces(nullptr, stand.stand);
  refresh();
}

void PointPicker::setWhyNot(const QString& whyNot) {
  whyNot_ = whyNot;
  refresh();
}

void PointPicker::complain(const QString& why) {
  complaint_->setText(why);
  complaint_->setVisible(!why.isEmpty());
}

void PointPicker::pick(PickSide side, const Vec3& point) {
  if (points_.on(side).size() >= MarkerLayer::kMost && points_.awaited() != side) return;
  points_.pick(side, point);
  complain({});
  refresh();
}

void PointPicker::removeLast() {
  points_.removeLast();
  complain({});
  refresh();
}

void PointPicker::refresh() {
  object_->setMarkers(points_.on(PickSide::Object));
  stand_->setMarkers(points_.on(PickSide::Stand));
  const std::size_t pairs = points_.pairs().size();
  const QString number = QString::number(pairs + 1);
  if (const auto awaited = points_.awaited())
    next_->setText(
        (*awaited == PickSide::Object ? tr("Click place %1 on the object.") : tr("Click place %1 on the stand."))
            .arg(number));
  else if (pairs < kLeastPairs)
    next_->setText(
        tr("Click place %1 on the object, then the same place on the stand. Three places or more are needed, "
           "far from each other.")
            .arg(number));
  else
    next_->setText(tr("%1 places are picked. Align from them, or click further ones.").arg(pairs));
  allow(*remove_, points_.isEmpty() ? tr("No point was picked yet.") : QString());
  allow(*align_, !whyNot_.isEmpty()    ? whyNot_
                 : pairs < kLeastPairs ? tr("Three places on both are needed, %1 are picked.").arg(pairs)
                                       : QString());
}

}  // namespace vantage
