#include "settings/settings_dialog.h"

#include <QDialogButtonBox>
#include <QVBoxLayout>

#include "form_parts.h"
#include "help/help_topic.h"
#include "settings/field_form.h"

namespace vantage {

SettingsDialog::SettingsDialog(const Preferences& preferences, QWidget* parent)
    : QDialog(parent), before_(preferences), edited_(preferences) {
  setHelpTopic(*this, QStringLiteral("settings"));
  setWindowTitle(tr("Settings"));
  auto* layout = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  auto* later = makeLabel(tr("The window speaks it after it was closed and opened again."), "muted");
  later->setObjectName(QStringLiteral("languageLater"));
  fillForm(*form, preferenceFields(), edited_, [this, later] {
    later->setVisible(edited_.language != before_.language);
    emit edited(edited_);
  });
  layout->addLayout(form);
  layout->addWidget(later);
  later->hide();
  layout->addStretch();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(this, &QDialog::rejected, this, &SettingsDialog::takeBack);
  setMinimumWidth(360);
}

void SettingsDialog::takeBack() {
  edited_ = before_;
  emit edited(edited_);
}

}  // namespace vantage
