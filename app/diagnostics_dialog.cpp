#include "diagnostics_dialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "form_parts.h"
#include "help/help_topic.h"

namespace vantage {

DiagnosticsDialog::DiagnosticsDialog(Diagnostics diagnostics, QWidget* parent)
    : QDialog(parent),
      diagnostics_(std::move(diagnostics)),
      text_(new QPlainTextEdit),
      withFiles_(new QCheckBox(tr("With the names of &files and folders"))) {
  setHelpTopic(*this, QStringLiteral("messages#when-something-is-wrong-with-vantage-itself"));
  setWindowTitle(tr("Diagnostics"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(makeLabel(tr("For somebody who is to help. It is sent to nobody: copy it to where it is wanted.")));
  text_->setReadOnly(true);
  text_->setLineWrapMode(QPlainTextEdit::NoWrap);
  text_->setAccessibleName(tr("Diagnostics"));
  text_->setObjectName(QStringLiteral("diagnostics"));
  layout->addWidget(text_, 1);
  withFiles_->setObjectName(QStringLiteral("withFiles"));
  setHelp(*withFiles_, tr("Without them every name of a file is replaced by <file>."));
  layout->addWidget(withFiles_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QPushButton* copyButton =
      makeButton(tr("&Copy"), QStringLiteral("copyDiagnostics"), tr("Put the text into the clipboard."), true);
  buttons->addButton(copyButton, QDialogButtonBox::ActionRole);
  layout->addWidget(buttons);
  connect(copyButton, &QPushButton::clicked, this, &DiagnosticsDialog::copy);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(withFiles_, &QCheckBox::toggled, this, &DiagnosticsDialog::refresh);
  resize(640, 480);
  refresh();
}

void DiagnosticsDialog::refresh() {
  text_->setPlainText(textOf(diagnostics_, withFiles_->isChecked()));
}

void DiagnosticsDialog::copy() {
  QGuiApplication::clipboard()->setText(text_->toPlainText());
}

}  // namespace vantage
