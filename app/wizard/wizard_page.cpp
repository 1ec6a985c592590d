#include "wizard/wizard_page.h"

#include <QVBoxLayout>

#include "form_parts.h"

namespace vantage {

WizardPage::WizardPage(SessionController& controller, QWidget* parent)
    : QWidget(parent), controller_(controller), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(12, 8, 12, 8);
  column_->setSpacing(8);
}

void WizardPage::addSection(const QString& text) {
  column_->addSpacing(4);
  column_->addWidget(makeLabel(text, "section"));
}

}  // namespace vantage
