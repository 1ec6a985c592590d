#include "wizard/stand_box.h"

#include <QGridLayout>
#include <QVBoxLayout>

#include "form_parts.h"
#include "stand_desk.h"

namespace vantage {

StandBox::StandBox(SessionController& controller, StandDesk& desk, QWidget* parent)
    : QWidget(parent),
      desk_(desk),
      sentence_(makeLabel({})),
      align_(makeButton(tr("Align no&w"), QStringLiteral("alignNow"),
                        tr("Find out how the object stands from what has been scanned of it so far."))),
      compare_(
          makeButton(tr("Compare poses…"), QStringLiteral("comparePoses"),
                     tr("See the stand over the object in every pose that was found, choose one, or pick points."))),
      turn_(makeButton(tr("Turn again…"), QStringLiteral("turnAgain"),
                       tr("Put the object on another side. The scans of this stand are kept, and tried again then."))),
      back_(makeButton({}, QStringLiteral("backToOneStand"),
                       tr("Undo this stand: what was scanned in it is left, and can be redone. To scan on then, the "
                          "object has to stand as if it had never been moved; else turn it over again."))) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(sentence_);
  auto* buttons = new QGridLayout;
  buttons->addWidget(align_, 0, 0);
  buttons->addWidget(turn_, 0, 1);
  buttons->addWidget(compare_, 1, 0, 1, 2);
  buttons->addWidget(back_, 2, 0, 1, 2);
  column->addLayout(buttons);
  sentence_->setObjectName(QStringLiteral("standSentence"));
  connect(align_, &QPushButton::clicked, &desk, &StandDesk::align);
  connect(compare_, &QPushButton::clicked, &desk, &StandDesk::comparisonWanted);
  connect(turn_, &QPushButton::clicked, this, &StandBox::turnWanted);
  connect(back_, &QPushButton::clicked, &desk, &StandDesk::goBack);
  connect(&desk, &StandDesk::sentenceChanged, this, &StandBox::refresh);
  connect(&controller, &SessionController::activityChanged, this, &StandBox::refresh);
  refresh();
}

void StandBox::refresh() {
  setVisible(desk_.stand() > 0);
  sentence_->setText(desk_.sentence());
  setRole(*sentence_, desk_.failedToAlign() ? "warning" : "");
  align_->setVisible(desk_.isOpen());
  compare_->setVisible(desk_.failedToAlign());
  back_->setText(desk_.stand() == 1 ? tr("Bac&k to one stand") : tr("Bac&k to %1 stands").arg(desk_.stand()));
  back_->setAccessibleName(QString(back_->text()).remove(QLatin1Char('&')));
  allow(*align_, desk_.whyNotAlign());
  allow(*compare_, desk_.whyNotAlign());
  allow(*turn_, desk_.whyNotTurn());
  allow(*back_, desk_.whyNotGoBack());
}

}  // namespace vantage
