#include "wizard/other_turn_box.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "acquisition/other_turn.h"
#include "form_parts.h"
#include "session_controller.h"

namespace vantage {

OtherTurnBox::OtherTurnBox(SessionController& controller, QWidget* parent)
    : QWidget(parent), controller_(controller), what_(makeLabel({})) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(what_);
  connect(&controller, &SessionController::stateChanged, this, &OtherTurnBox::refresh);
  connect(&controller, &SessionController::activityChanged, this, &OtherTurnBox::refresh);
  refresh();
}

void OtherTurnBox::refresh() {
  for (QPushButton* button : buttons_) {
    button->hide();
    button->deleteLater();
  }
  buttons_.clear();
  const SharedState& now = controller_.now();
  if (now && controller_.idle() && !now->scans.empty() && now->scans.back().status == ScanStatus::Rejected) {
    const KeptScan& scan = now->scans.back();
    what_->setText(
        tr("Scan %1 fits another turn of the table than was said. If the table stood there:").arg(scan.number));
    for (const double turn : turnsThatFit(*now, scan)) {
      const QString angle = QString::number(turn, 'f', 1) + QStringLiteral("°");
      auto* button = makeButton(tr("It was taken at %1").arg(angle), QStringLiteral("takeAsFrom"),
                                tr("Take the scan as one with the table at %1, counter-clockwise from its first "
                                   "position, seen from above: there it fits.")
                                    .arg(angle));
      allow(*button, controller_.permissions().whyNot(TakeAsFrom{scan.number, turn}));
      connect(button, &QPushButton::clicked, this,
              [this, number = scan.number, turn] { controller_.takeAsFrom(number, turn); });
      layout()->addWidget(button);
      button->show();
      buttons_.push_back(button);
    }
  }
  setVisible(!buttons_.empty());
}

}  // namespace vantage
