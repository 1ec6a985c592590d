#include "docks/stand_strip.h"

#include <QHelpEvent>
#include <QPainter>
#include <QScrollBar>
#include <QStringList>
#include <QToolTip>
#include <algorithm>
#include <utility>

namespace vantage {
namespace {

constexpr int kAround = 6;  // of a text, to the sides

// What the operator should look at.
bool isDoubtful(StandRole role) {
  return role != StandRole::Reference && role != StandRole::Aligned;
}

}  // namespace

std::vector<StandSpan> standSpans(const std::vector<Moment>& moments, int cursor) {
  std::vector<StandSpan> spans;
  for (int i = 0; i < static_cast<int>(moments.size()); ++i) {
    const Moment& moment = moments[static_cast<std::size_t>(i)];
    if (spans.empty() || spans.back().stand != moment.stand) spans.push_back({moment.stand, i, i, {}, {}, i > cursor});
    spans.back().last = i;
  }
  if (spans.size() < 2) return {};
  const std::vector<Stand>& now = moments[static_cast<std::size_t>(cursor)].outline->stands;
  for (StandSpan& span : spans) {
    const bool isNow = span.stand < static_cast<int>(now.size());
    const std::vector<Stand>& stands = isNow ? now : moments[static_cast<std::size_t>(span.last)].outline->stands;
    span.role = standRoleOf(stands, span.stand);
    span.sentence = standSentence(stands, span.stand);
  }
  return spans;
}

StandStrip::StandStrip(QListWidget& moments) : QWidget(&moments), moments_(moments) {
  setObjectName(QStringLiteral("standStrip"));
  setAccessibleName(tr("Stands of the object"));
  hide();
  connect(moments.horizontalScrollBar(), &QScrollBar::valueChanged, this, qOverload<>(&QWidget::update));
}

void StandStrip::setSpans(std::vector<StandSpan> spans) {
  spans_ = std::move(spans);
  QStringList texts;
  for (const StandSpan& span : spans_) texts << textOf(span);
  setAccessibleDescription(texts.join(QStringLiteral(", ")));
  setVisible(!isEmpty());
  update();
}

QString StandStrip::textOf(const StandSpan& span) const {
  const QString text = tr("Stand %1 · %2").arg(QString::number(span.stand), standRoleText(span.role));
  return span.undone ? tr("%1 (undone)").arg(text) : text;
}

QRect StandStrip::rectOf(const StandSpan& span) const {
  const QRect first = moments_.visualItemRect(moments_.item(span.first));
  const QRect last = moments_.visualItemRect(moments_.item(span.last));
  return {QPoint(first.left(), 1), QPoint(last.right(), height() - 2)};
}

void StandStrip::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  for (const StandSpan& span : spans_) {
    const QRect whole = rectOf(span);
    const QRect seen = whole & rect();
    if (seen.isEmpty()) continue;
    painter.fillRect(seen, palette().color(QPalette::Midlight));
    painter.fillRect(QRect(whole.left(), 0, 2, height()), palette().color(QPalette::Dark));
    QFont font = this->font();
    font.setBold(isDoubtful(span.role));
    font.setStrikeOut(span.undone);
    painter.setFont(font);
    painter.setPen(palette().color(span.undone ? QPalette::Disabled : QPalette::Active, QPalette::Text));
    // It stays in sight while its moments are scrolled by.
    const QRect room = seen.adjusted(kAround, 0, -kAround, 0);
    const QFontMetrics metrics(font);
    QString text = textOf(span);
    if (metrics.horizontalAdvance(text) > room.width()) text = tr("Stand %1").arg(span.stand);
    if (metrics.horizontalAdvance(text) > room.width()) text = QString::number(span.stand);
    if (metrics.horizontalAdvance(text) <= room.width()) painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, text);
  }
}

bool StandStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const auto under = std::find_if(spans_.begin(), spans_.end(),
                                  [&](const StandSpan& span) { return rectOf(span).contains(help->pos()); });
  if (under == spans_.end())
    QToolTip::hideText();
  else
    QToolTip::showText(help->globalPos(), under->sentence, this);
  return true;
}

}  // namespace vantage
