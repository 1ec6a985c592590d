#include "form_parts.h"

#include <QGridLayout>

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

QPushButton* makeButton(const QString& text, const QString& objectName, const QString& help, bool primary) {
  auto* button = new QPushButton(text);
  button->setObjectName(objectName);
  button->setToolTip(help);
  button->setProperty(kHelp, help);
  button->setAccessibleName(QString(text).remove(QLatin1Char('&')));
  button->setAccessibleDescription(help);
  button->setProperty("primary", primary);
  return button;
}

void allow(QPushButton& button, const QString& whyNot) {
  button.setEnabled(whyNot.isEmpty());
  button.setToolTip(whyNot.isEmpty() ? button.property(kHelp).toString() : whyNot);
  button.setAccessibleDescription(button.toolTip());
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

void FigureTable::add(const QString& name, const QString& value, const QString& remark) {
  QLabel* valueLabel = makeLabel(value, "section");
  valueLabel->setWordWrap(false);
  valueLabel->setAlignment(Qt::AlignRight | Qt::AlignTop);
  grid_->addWidget(makeLabel(name), rows_, 0, Qt::AlignTop);
  grid_->addWidget(valueLabel, rows_++, 1, Qt::AlignTop);
  if (!remark.isEmpty()) grid_->addWidget(makeLabel(remark, "muted"), rows_++, 0, 1, 2);
}

}  // namespace vantage
