#include "window/flow_layout.h"

#include <algorithm>

namespace vantage {

FlowLayout::FlowLayout(int spacing, QWidget* parent) : QLayout(parent) {
  setSpacing(spacing);
}

FlowLayout::~FlowLayout() {
  qDeleteAll(items_);
}

QLayoutItem* FlowLayout::takeAt(int index) {
  return index >= 0 && index < count() ? items_.takeAt(index) : nullptr;
}

QSize FlowLayout::minimumSize() const {
  QSize size;
  for (const QLayoutItem* item : items_)
    if (!item->isEmpty()) size = size.expandedTo(item->minimumSize().expandedTo(item->sizeHint()));
  const QMargins margins = contentsMargins();
  return size + QSize(margins.left() + margins.right(), margins.top() + margins.bottom());
}

void FlowLayout::setGeometry(const QRect& area) {
  QLayout::setGeometry(area);
  place(area, true);
}

int FlowLayout::place(const QRect& area, bool move) const {
  const QRect room = area.marginsRemoved(contentsMargins());
  QList<std::pair<QLayoutItem*, QRect>> line;
  int x = room.x();
  int y = room.y();
  int height = 0;
  // Those of a line stand on one middle.
  const auto endLine = [&] {
    for (const auto& [item, rect] : line)
      if (move) item->setGeometry(rect.translated(0, (height - rect.height()) / 2));
    line.clear();
  };
  for (QLayoutItem* item : items_) {
    if (item->isEmpty()) continue;
    const QSize size = item->sizeHint();
    if (x > room.x() && x + size.width() > room.x() + room.width()) {
      endLine();
      x = room.x();
      y += height + spacing();
      height = 0;
    }
    line << std::pair(item, QRect(QPoint(x, y), size));
    x += size.width() + spacing();
    height = std::max(height, size.height());
  }
  endLine();
  const QMargins margins = contentsMargins();
  return y + height - area.y() + margins.bottom();
}

}  // namespace vantage
