#include "wizard/cut_picture_view.h"

#include <QPainter>
#include <algorithm>

namespace vantage {
namespace {

constexpr int kHighest = 260;

}  // namespace

CutPictureView::CutPictureView(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("The test scan, with what is cut of it in colours"));
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void CutPictureView::show(const QImage& picture) {
  const bool other = picture.size() != picture_.size();
  picture_ = picture;
  if (other) updateGeometry();
  update();
}

int CutPictureView::heightForWidth(int width) const {
  if (picture_.isNull() || picture_.width() == 0) return 0;
  return std::min(kHighest, width * picture_.height() / picture_.width());
}

void CutPictureView::paintEvent(QPaintEvent* /*event*/) {
  if (picture_.isNull()) return;
  QPainter painter(this);
  const QSize size = picture_.size().scaled(this->size(), Qt::KeepAspectRatio);
  const QRect place(QPoint((width() - size.width()) / 2, 0), size);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, picture_.width() > size.width());
  painter.drawImage(place, picture_);
}

}  // namespace vantage
