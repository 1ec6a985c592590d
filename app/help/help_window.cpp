#include "help/help_window.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include "form_parts.h"
#include "help/help_topic.h"
#include "help/manual_browser.h"

namespace vantage {
namespace {

constexpr int kTopic = Qt::UserRole;

QListWidgetItem* addTopic(QListWidget& list, const QString& text, const QString& topic) {
  auto* item = new QListWidgetItem(text, &list);
  item->setData(kTopic, topic);
  return item;
}

}  // namespace

HelpWindow::HelpWindow(const QString& folder)
    : manual_(folder), words_(new QLineEdit), list_(new QListWidget), page_(new ManualBrowser) {
  setWindowTitle(tr("Manual – Vantage"));
  setObjectName(QStringLiteral("helpWindow"));
  setAttribute(Qt::WA_QuitOnClose, false);
  setHelpTopic(*this, QStringLiteral("contents"));
  build();
  addKeys();
  listContents();
  if (manual_.pages().empty())
    page_->setPlainText(
        tr("The manual is not there: %1 cannot be read. On Debian it comes with the package vantage-data.")
            .arg(folder));
  resize(1040, 720);
}

void HelpWindow::build() {
  auto* back = makeButton(tr("&Back"), QStringLiteral("helpBack"), tr("The page before (Alt+Left)."));
  auto* forward = makeButton(tr("&Forward"), QStringLiteral("helpForward"), tr("The page after (Alt+Right)."));
  auto* contents = makeButton(tr("&Contents"), QStringLiteral("helpContents"), tr("All chapters (Alt+Home)."));
  connect(back, &QPushButton::clicked, page_, &QTextBrowser::backward);
  connect(forward, &QPushButton::clicked, page_, &QTextBrowser::forward);
  connect(contents, &QPushButton::clicked, this, [this] {
    words_->clear();
    open(QStringLiteral("contents"));
  });
  const auto allowBoth = [this, back, forward] {
    allow(*back, page_->isBackwardAvailable() ? QString() : tr("No page was shown before."));
    allow(*forward, page_->isForwardAvailable() ? QString() : tr("No page comes after."));
  };
  connect(page_, &QTextBrowser::historyChanged, this, allowBoth);
  allowBoth();
  words_->setObjectName(QStringLiteral("helpWords"));
  words_->setPlaceholderText(tr("Search all pages (Ctrl+F)"));
  words_->setAccessibleName(tr("Words to search for in all pages"));
  words_->setClearButtonEnabled(true);
  connect(words_, &QLineEdit::textChanged, this, &HelpWindow::search);
  connect(words_, &QLineEdit::returnPressed, this, [this] {
    if (list_->count() > 0 && !words_->text().isEmpty()) {
      if (list_->currentRow() < 0) list_->setCurrentRow(0);
      page_->findNext();
    }
  });
  list_->setObjectName(QStringLiteral("helpList"));
  list_->setAccessibleName(tr("Chapters, or what was found"));
  list_->setWordWrap(true);
  connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item != nullptr) followList(*item);
  });
  connect(list_, &QListWidget::itemClicked, this, [this](const QListWidgetItem* item) { followList(*item); });

  auto* top = new QHBoxLayout;
  for (QWidget* part : {static_cast<QWidget*>(back), static_cast<QWidget*>(forward), static_cast<QWidget*>(contents)})
    top->addWidget(part);
  top->addWidget(words_, 1);
  auto* both = new QSplitter;
  both->addWidget(list_);
  both->addWidget(page_);
  both->setStretchFactor(1, 1);
  both->setSizes({280, 760});
  both->setChildrenCollapsible(false);
  auto* column = new QVBoxLayout(this);
  column->addLayout(top);
  column->addWidget(both, 1);
}

void HelpWindow::addKeys() {
  const auto key = [this](const QKeySequence& keys, auto run) {
    auto* shortcut = new QShortcut(keys, this);
    connect(shortcut, &QShortcut::activated, this, run);
  };
  key(QKeySequence(Qt::ALT | Qt::Key_Left), [this] { page_->backward(); });
  key(QKeySequence(Qt::ALT | Qt::Key_Right), [this] { page_->forward(); });
  key(QKeySequence(Qt::ALT | Qt::Key_Home), [this] { open(QStringLiteral("contents")); });
  key(QKeySequence::Find, [this] {
    words_->setFocus(Qt::ShortcutFocusReason);
    words_->selectAll();
  });
  key(QKeySequence(Qt::Key_F3), [this] { page_->findNext(); });
  key(QKeySequence(Qt::SHIFT | Qt::Key_F3), [this] { page_->findNext(true); });
  key(QKeySequence::ZoomIn, [this] { page_->zoomIn(); });
  key(QKeySequence::ZoomOut, [this] { page_->zoomOut(); });
}

void HelpWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    close();
    return;
  }
  QWidget::keyPressEvent(event);
}

void HelpWindow::listContents() {
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (const ManualPage& page : manual_.pages()) addTopic(*list_, page.title, page.key);
}

void HelpWindow::search(const QString& words) {
  page_->markWords(searchWords(words));
  if (searchWords(words).isEmpty()) return listContents();
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (const ManualHit& hit : manual_.find(words))
    addTopic(*list_, hit.page == hit.heading ? hit.page : hit.heading + QStringLiteral("\n    ") + hit.page, hit.topic);
  if (list_->count() == 0) {
    auto* none = new QListWidgetItem(tr("No section of the manual has these words."), list_);
    none->setFlags(Qt::NoItemFlags);
  }
}

void HelpWindow::followList(const QListWidgetItem& item) {
  if (const QString topic = item.data(kTopic).toString(); !topic.isEmpty()) open(topic);
}

void HelpWindow::open(const QString& topic) {
  const QString known = manual_.has(topic) ? topic : QStringLiteral("contents");
  const ManualPage* page = manual_.pageOf(known);
  if (page == nullptr) return;
  QUrl place = QUrl::fromLocalFile(page->file);
  if (const QString anchor = known.section(QLatin1Char('#'), 1); !anchor.isEmpty()) place.setFragment(anchor);
  if (place != page_->source()) page_->setSource(place);
  if (!words_->text().isEmpty()) return;
  const QSignalBlocker quiet(list_);
  for (int row = 0; row < list_->count(); ++row)
    if (list_->item(row)->data(kTopic).toString() == page->key) list_->setCurrentRow(row);
}

void HelpWindow::showTopic(const QString& topic) {
  words_->clear();
  open(topic);
  show();
  if (isMinimized()) showNormal();
  raise();
  activateWindow();
  page_->setFocus(Qt::OtherFocusReason);
}

}  // namespace vantage
