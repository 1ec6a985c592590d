#include "wizard/wizard.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "form_parts.h"
#include "help/help_topic.h"
#include "window/page_scroll.h"

namespace vantage {
namespace {

constexpr int kLeastWidth = 300;

}  // namespace

Wizard::Wizard(SessionController& controller, StandDesk& stands, const SurfaceMaker& surfaces, const QString& resources,
               QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      choose_(new ChoosePage(controller, resources)),
      acquire_(new AcquirePage(controller, stands)),
      turnOver_(new TurnOverPage(controller, stands, surfaces)),
      review_(new ReviewPage(controller)),
      finish_(new FinishPage(controller)),
      where_(makeLabel({}, "muted")),
      title_(makeLabel({}, "title")),
      whatNext_(makeLabel({})),
      stack_(new QStackedWidget),
      back_(makeButton(tr("&Back"), QStringLiteral("back"), tr("The page before; nothing is lost."))),
      next_(makeButton({}, QStringLiteral("next"), {}, true)) {
  // Whoever goes by the keyboard comes by the page before the buttons below it.
  for (WizardPage* page :
       {static_cast<WizardPage*>(choose_), static_cast<WizardPage*>(new CheckPage(controller)),
        static_cast<WizardPage*>(new CalibratePage(controller)), static_cast<WizardPage*>(acquire_),
        static_cast<WizardPage*>(turnOver_), static_cast<WizardPage*>(review_), static_cast<WizardPage*>(finish_)})
    addPage(page);
  build();
  setHelpTopic(*this, helpTopicOf(&page()));
  connect(back_, &QPushButton::clicked, this, &Wizard::goBack);
  connect(next_, &QPushButton::clicked, this, &Wizard::goOn);
  connect(&controller, &SessionController::sessionChanged, this, &Wizard::reopen);
  refresh();
}

void Wizard::setTheme(const Theme& theme) {
  turnOver_->setTheme(theme);
}

void Wizard::build() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* head = new QVBoxLayout;
  head->setContentsMargins(12, 10, 12, 0);
  head->setSpacing(0);
  head->addWidget(where_);
  head->addWidget(title_);
  column->addLayout(head);
  column->addWidget(stack_, 1);
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(12, 4, 12, 10);
  auto* line = new QFrame;
  line->setFrameShape(QFrame::HLine);
  line->setFrameShadow(QFrame::Sunken);
  foot->addWidget(line);
  foot->addWidget(makeLabel(tr("What happens next"), "muted"));
  foot->addWidget(whatNext_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(back_);
  buttons->addWidget(next_, 1);
  foot->addLayout(buttons);
  column->addLayout(foot);
  // The buttons below may need more: what they say depends on the language.
  stack_->setMinimumWidth(kLeastWidth);
}

void Wizard::addPage(WizardPage* page) {
  stack_->addWidget(new PageScroll(page));
  pages_.push_back(page);
  connect(page, &WizardPage::changed, this, &Wizard::refresh);
  connect(page, &WizardPage::wanted, this, [this, page](const QString& key) {
    if (pages_[static_cast<std::size_t>(index_)] == page) goTo(key);
  });
  connect(page, &WizardPage::finished, this, [this, page] {
    if (pages_[static_cast<std::size_t>(index_)] == page)
      if (const auto next = pageFrom(index_, 1)) goTo(*next);
  });
}

void Wizard::goTo(int index) {
  if (index < 0 || index >= pageCount()) return;
  index_ = index;
  stack_->setCurrentIndex(index);
  controller_.rememberPage(page().key());
  setHelpTopic(*this, helpTopicOf(&page()));
  pages_[static_cast<std::size_t>(index)]->entered();
  refresh();
}

void Wizard::goTo(const QString& key) {
  for (int i = 0; i < pageCount(); ++i)
    if (pages_[static_cast<std::size_t>(i)]->key() == key) return goTo(i);
}

void Wizard::goOn() {
  if (!page().complete()) return;
  pages_[static_cast<std::size_t>(index_)]->leaving();
  goTo(pageFrom(index_, 1).value_or(0));
}

void Wizard::takeKeyboard() {
  for (QWidget* widget = stack_->currentWidget(); widget != nullptr; widget = widget->nextInFocusChain()) {
    const bool takes = (widget->focusPolicy() & Qt::TabFocus) == Qt::TabFocus && widget->isEnabled() &&
                       widget->isVisible() && qobject_cast<QScrollArea*>(widget) == nullptr;
    if (takes) return widget->setFocus(Qt::TabFocusReason);
    if (widget == next_) return;
  }
}

void Wizard::turnPage() {
  if (pageFrom(index_, 1)) goOn();
}

void Wizard::goBack() {
  if (const auto before = pageFrom(index_, -1)) goTo(*before);
}

std::optional<int> Wizard::pageFrom(int index, int step) const {
  for (int i = index + step; i >= 0 && i < pageCount(); i += step)
    if (pages_[static_cast<std::size_t>(i)]->applies()) return i;
  return std::nullopt;
}

// A session that was opened shows the page it was left at; one that was just begun stays where it is.
void Wizard::reopen() {
  const bool opened = controller_.hasSession() && !hadSession_;
  hadSession_ = controller_.hasSession();
  if (!hadSession_) return refresh();
  if (controller_.page().isEmpty())
    controller_.rememberPage(page().key());
  else if (opened)
    goTo(controller_.page());
  refresh();
}

void Wizard::refresh() {
  const auto applying = [](const WizardPage* page) { return page->applies(); };
  const auto here = pages_.begin() + index_;
  const auto before = std::count_if(pages_.begin(), here, applying);
  const auto after = std::count_if(here + 1, pages_.end(), applying);
  where_->setText(page().applies()
                      ? tr("Step %1 of %2").arg(before + 1).arg(before + 1 + after)
                      : tr("Between step %1 and step %2 of %3").arg(before).arg(before + 1).arg(before + after));
  title_->setText(page().title());
  whatNext_->setText(page().whatNext());
  allow(*back_, index_ > 0 ? QString() : tr("This is the first page."));
  next_->setText(page().nextText());
  next_->setAccessibleName(QString(page().nextText()).remove(QLatin1Char('&')));
  setHelp(*next_, page().whatNext());
  allow(*next_, page().whyNotNext());
}

}  // namespace vantage
