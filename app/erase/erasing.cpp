#include "erase/erasing.h"

namespace vantage {

Erasing::Erasing(SessionController& controller, JobRunner& jobs, ModelPane& pane, QObject* parent)
    : QObject(parent), desk_(controller, jobs, pane.view()), bar_(new EraseBar(desk_, pane.view(), &pane)) {
  pane.addRow(*bar_);
  connect(&pane, &ModelPane::eraseWanted, this, [this] {
    if (const QString why = start(); !why.isEmpty()) emit refused(why);
  });
}

QString Erasing::start() {
  if (QString why = desk_.whyNot(); !why.isEmpty()) return why;
  bar_->begin();
  return {};
}

}  // namespace vantage
