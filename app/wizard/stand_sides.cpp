#include "wizard/stand_sides.h"

#include <QIcon>
#include <QPixmap>
#include <QScrollBar>
#include <QSignalBlocker>

#include "why_card.h"

namespace vantage {
namespace {

constexpr QSize kPicture{84, 63};
constexpr int kAround = 8;  // of a picture, within its cell

}  // namespace

StandSides::StandSides(QWidget* parent) : QListWidget(parent) {
  setViewMode(QListView::IconMode);
  setMovement(QListView::Static);
  setFlow(QListView::LeftToRight);
  setWrapping(false);
  setUniformItemSizes(true);
  setIconSize(kPicture);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  setObjectName(QStringLiteral("sides"));
  setAccessibleName(tr("Sides that the object can rest on, the best first"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row >= 0) emit sideChosen(row);
  });
}

QSize StandSides::sizeHint() const {
  const int cell = kPicture.height() + fontMetrics().height() + 2 * kAround;
  return {200, cell + horizontalScrollBar()->sizeHint().height() + 2 * frameWidth()};
}

void StandSides::setSides(const std::vector<StandAdvice>& sides) {
  const QSignalBlocker quiet(this);
  clear();
  for (const StandAdvice& side : sides) {
    const QString share = tr("%1 %").arg(figureText(100.0 * side.share));
    auto* item = new QListWidgetItem(side.isNew ? share : tr("%1 · again").arg(share), this);
    item->setToolTip(tr("%1 of what is still unseen, %2 of what is left. It tilts by %3 before it falls over.")
                         .arg(areaText(side.gain), share, angleText(side.margin)) +
                     (side.isNew ? QString() : QLatin1Char(' ') + tr("It stood like this already.")));
    item->setSizeHint(kPicture + QSize(kAround, fontMetrics().height() + kAround));
    item->setData(Qt::AccessibleTextRole, item->toolTip());
  }
  setCurrentRow(sides.empty() ? -1 : 0);
}

void StandSides::setPictures(const std::vector<QImage>& pictures) {
  for (int i = 0; i < count() && i < static_cast<int>(pictures.size()); ++i) {
    const QImage& picture = pictures[static_cast<std::size_t>(i)];
    if (picture.isNull()) continue;
    const QSize pixels = (QSizeF(kPicture) * devicePixelRatioF()).toSize();
    const QImage scaled = picture.scaled(pixels, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    QRect middle(QPoint(), pixels);
    middle.moveCenter(scaled.rect().center());
    QPixmap small = QPixmap::fromImage(scaled.copy(middle));
    small.setDevicePixelRatio(devicePixelRatioF());
    item(i)->setIcon(QIcon(small));
  }
}

}  // namespace vantage
