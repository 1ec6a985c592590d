#include "docks/time_line.h"

#include <QCoreApplication>

#include "docks/stand_strip.h"
#include "why_card.h"

namespace vantage {
namespace {

QString caption(const Moment& moment) {
  if (!moment.position) return moment.text + QStringLiteral("\n ");
  const QString position = QString::number(*moment.position);
  const QString scan = QString::number(moment.scan.value_or(0));
  if (moment.rejected)
    return QCoreApplication::translate("TimeLine", "Scan %1 · position %2\ndid not fit").arg(scan, position);
  return QCoreApplication::translate("TimeLine", "Scan %1 · position %2\n+%3")
      .arg(scan, position, areaText(moment.newArea));
}

}  // namespace

TimeLine::TimeLine(SessionController& controller, QWidget* parent)
    : QListWidget(parent), controller_(controller), stands_(new StandStrip(*this)) {
  setFlow(QListView::LeftToRight);
  setWrapping(false);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSpacing(3);
  setFrameShape(QFrame::NoFrame);
  setObjectName(QStringLiteral("timeLine"));
  setAccessibleName(tr("Moments of the session"));
  connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row >= 0 && row != controller_.shownMoment()) controller_.showMoment(row);
  });
  connect(&controller, &SessionController::stateChanged, this, &TimeLine::refresh);
  connect(&controller, &SessionController::shownChanged, this, &TimeLine::mark);
}

void TimeLine::setTheme(const Theme& theme) {
  theme_ = &theme;
  refresh();
}

void TimeLine::refresh() {
  const QSignalBlocker quiet(this);
  clear();
  for (const Moment& moment : controller_.present().moments()) {
    auto* item = new QListWidgetItem(caption(moment), this);
    item->setTextAlignment(Qt::AlignCenter);
    item->setToolTip(moment.undone ? tr("%1 (undone)").arg(moment.text) : moment.text);
    QFont font = item->font();
    font.setStrikeOut(moment.undone);
    item->setFont(font);
    item->setSizeHint(QFontMetrics(font).boundingRect(QRect(0, 0, 400, 100), Qt::AlignCenter, caption(moment)).size() +
                      QSize(20, 12));
    if (moment.rejected) item->setForeground(theme_->threshold);
    if (moment.undone) item->setForeground(palette().color(QPalette::Disabled, QPalette::Text));
  }
  stands_->setSpans(standSpans(controller_.present().moments(), controller_.present().cursor()));
  placeStrip();
  mark();
}

int TimeLine::stripHeight() const {
  return stands_->isEmpty() ? 0 : fontMetrics().height() + 6;
}

void TimeLine::placeStrip() {
  if (viewportMargins().top() != stripHeight()) {
    setViewportMargins(0, stripHeight(), 0, 0);
    updateGeometry();
  }
  stands_->setGeometry(viewport()->x(), viewport()->y() - stripHeight(), viewport()->width(), stripHeight());
}

void TimeLine::resizeEvent(QResizeEvent* event) {
  QListWidget::resizeEvent(event);
  placeStrip();
}

void TimeLine::mark() {
  const QSignalBlocker quiet(this);
  setCurrentRow(controller_.shownMoment());
  if (currentItem() != nullptr) scrollToItem(currentItem());
}

}  // namespace vantage
