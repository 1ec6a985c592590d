#include "wizard/wizard_page.h"

#include <QVBoxLayout>

#include "form_parts.h"

namespace vantage {

WizardPage::WizardPage(SessionController& controller, QWidget* parent)
    : QWidget(parent), controller_(controller), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(12, 8, 12, 8);
  column_->setSpacing(8);
}

QString WizardPage::whyNotNext() const {
  if (complete()) return {};
  if (!controller_.idle()) return tr("Something else is under way.");
  return controller_.setUp() ? tr("Nothing has been scanned yet.") : tr("Scanner and object are not read yet.");
}

void WizardPage::addSection(const QString& text) {
  column_->addSpacing(4);
  column_->addWidget(makeLabel(text, "section"));
}

void WizardPage::addErase() {
  QPushButton* button = makeButton(tr("E&rase what is not the object…"), QStringLiteral("eraseWanted"),
                                   tr("Take putty, a clamp, the table or loose pieces out of the model."));
  column_->addWidget(button);
  connect(button, &QPushButton::clicked, this, &WizardPage::eraseWanted);
  const auto refresh = [this, button] {
    const bool now = controller_.showsNow();
    vantage::allow(*button, now ? controller_.permissions().whyNotErase()
                                : tr("An earlier moment is shown: go back to now first."));
  };
  connect(&controller_, &SessionController::stateChanged, button, refresh);
  connect(&controller_, &SessionController::shownChanged, button, refresh);
  connect(&controller_, &SessionController::activityChanged, button, refresh);
  refresh();
}

}  // namespace vantage
