#include "help/manual_browser.h"

#include <QImageReader>
#include <QTextBlock>
#include <QTextTable>
#include <algorithm>

#include "help/manual.h"

namespace vantage {
namespace {

constexpr int kWidestPicture = 640;  // pixels that do not depend on the screen
constexpr qreal kMargin = 16.0;

// The Markdown reader gives headings no anchors.
void anchorHeading(const QTextBlock& block) {
  QTextCursor cursor(block);
  cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor);
  QTextCharFormat format;
  format.setAnchor(true);
  format.setAnchorNames({anchorOf(block.text())});
  cursor.mergeCharFormat(format);
}

void fitPictures(const QTextBlock& block, const QUrl& page) {
  for (auto part = block.begin(); !part.atEnd(); ++part) {
    QTextImageFormat picture = part.fragment().charFormat().toImageFormat();
    if (!picture.isValid() || picture.width() > 0.0) continue;
    const QSize size = QImageReader(page.resolved(QUrl(picture.name())).toLocalFile()).size();
    if (size.width() <= kWidestPicture) continue;
    picture.setWidth(kWidestPicture);
    picture.setHeight(static_cast<qreal>(kWidestPicture) * size.height() / size.width());
    QTextCursor cursor(block);
    cursor.setPosition(part.fragment().position());
    cursor.setPosition(part.fragment().position() + part.fragment().length(), QTextCursor::KeepAnchor);
    cursor.setCharFormat(picture);
    return fitPictures(block, page);
  }
}

void ruleTable(QTextTable& table, const QPalette& palette) {
  QTextTableFormat format = table.format();
  format.setBorder(1.0);
  format.setBorderCollapse(true);
  format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
  format.setBorderBrush(palette.mid());
  format.setCellPadding(5.0);
  format.setCellSpacing(0.0);
  format.setTopMargin(4.0);
  format.setBottomMargin(10.0);
  table.setFormat(format);
}

}  // namespace

ManualBrowser::ManualBrowser(QWidget* parent) : QTextBrowser(parent) {
  setObjectName(QStringLiteral("manualPage"));
  setAccessibleName(tr("Page of the manual"));
  setFrameShape(QFrame::NoFrame);
  connect(this, &QTextBrowser::sourceChanged, this, &ManualBrowser::dress);
}

// The history, and with it source(), changes only after the page did.
void ManualBrowser::dress(const QUrl& page) {
  document()->setDocumentMargin(kMargin);
  QTextCursor all(document());
  all.beginEditBlock();
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() > 0) anchorHeading(block);
    fitPictures(block, page);
  }
  for (QTextFrame* frame : document()->rootFrame()->childFrames())
    if (auto* table = qobject_cast<QTextTable*>(frame)) ruleTable(*table, palette());
  all.endEditBlock();
  if (page.hasFragment()) scrollToAnchor(page.fragment());
  mark();
}

void ManualBrowser::markWords(const QStringList& words) {
  words_ = words;
  mark();
}

void ManualBrowser::mark() {
  QList<ExtraSelection> places;
  QTextCharFormat format;
  format.setBackground(palette().highlight());
  format.setForeground(palette().highlightedText());
  for (const QString& word : words_)
    for (QTextCursor at = document()->find(word, 0); !at.isNull(); at = document()->find(word, at))
      places.push_back({at, format});
  setExtraSelections(places);
}

bool ManualBrowser::findNext(bool backwards) {
  const QList<ExtraSelection> places = extraSelections();
  if (places.isEmpty()) return false;
  const auto order = [](const ExtraSelection& a, const ExtraSelection& b) { return a.cursor < b.cursor; };
  QList<ExtraSelection> sorted = places;
  std::sort(sorted.begin(), sorted.end(), order);
  const int here = backwards ? textCursor().selectionStart() : textCursor().selectionEnd();
  const ExtraSelection* chosen = backwards ? &sorted.back() : &sorted.front();
  if (backwards) {
    for (const ExtraSelection& place : sorted)
      if (place.cursor.selectionEnd() <= here) chosen = &place;
  } else {
    for (auto place = sorted.rbegin(); place != sorted.rend(); ++place)
      if (place->cursor.selectionStart() >= here && textCursor().hasSelection()) chosen = &*place;
  }
  QTextCursor cursor = textCursor();
  cursor.setPosition(chosen->cursor.selectionStart());
  cursor.setPosition(chosen->cursor.selectionEnd(), QTextCursor::KeepAnchor);
  setTextCursor(cursor);
  ensureCursorVisible();
  return true;
}

}  // namespace vantage
