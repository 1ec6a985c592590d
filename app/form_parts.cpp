#include "form_parts.h"

#include <QGridLayout>
#include <QStyle>

namespace vantage {
namespace {

constexpr const char* kHelp = "help";

}  // namespace

QLabel* makeLabel(const QString& text, const char* role) {
  auto* label = new QLabel(text);
  label->setProperty("role", QString::fromLatin1(role));
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setFocusPolicy(Qt::NoFocus);
  return label;
}

void setRole(QLabel& label, const char* role) {
  if (label.property("role").toString() == QLatin1String(role)) return;
  label.setProperty("role", role);
  // The style looks at the property only when it is applied.
  label.style()->unpolish(&label);
  label.style()->polish(&label);
}

QPushButton* makeButton(const QString& text, const QString& objectName, const QString& help, bool primary) {
  auto* button = new QPushButton(text);
  button->setObjectName(objectName);
  setHelp(*button, help);
  button->setAccessibleName(QString(text).remove(QLatin1Char('&')));
  button->setProperty("primary", primary);
  return button;
}

void setHelp(QWidget& control, const QString& help) {
  control.setProperty(kHelp, help);
  control.setToolTip(help);
  control.setAccessibleDescription(help);
}

// The help is what the tooltip said before it first said why not.
void allow(QWidget& control, const QString& whyNot) {
  if (!control.property(kHelp).isValid()) control.setProperty(kHelp, control.toolTip());
  control.setEnabled(whyNot.isEmpty());
  control.setToolTip(whyNot.isEmpty() ? control.property(kHelp).toString() : whyNot);
  control.setAccessibleDescription(control.toolTip());
}

FigureTable::FigureTable(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(10);
  grid_->setVerticalSpacing(3);
  grid_->setColumnStretch(0, 1);
}

void FigureTable::clear() {
  while (QLayoutItem* item = grid_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  rows_ = 0;
}

QLabel* FigureTable::add(const QString& name, const QString& value, const QString& remark) {
  QLabel* nameLabel = makeLabel(name);
  QLabel* valueLabel = makeLabel(value, "section");
  valueLabel->setWordWrap(false);
  valueLabel->setAlignment(Qt::AlignRight | Qt::AlignTop);
  grid_->addWidget(nameLabel, rows_, 0, Qt::AlignTop);
  grid_->addWidget(valueLabel, rows_++, 1, Qt::AlignTop);
  if (!remark.isEmpty()) grid_->addWidget(makeLabel(remark, "muted"), rows_++, 0, 1, 2);
  return nameLabel;
}

}  // namespace vantage
