#include "views/scanner_picture_view.h"

#include <QPainter>

#include "charts/axis.h"
#include "charts/scanner_picture_chart.h"

namespace vantage {

ScannerPictureView::ScannerPictureView(QWidget* parent) : QWidget(parent), theme_(&lightTheme()) {
  setAccessibleName(tr("What the scanner would see"));
}

void ScannerPictureView::setPicture(std::shared_ptr<const ScannerPicture> picture, const QString& title) {
  picture_ = std::move(picture);
  title_ = title;
  setAccessibleDescription(title);
  update();
}

void ScannerPictureView::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void ScannerPictureView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (picture_) return paintScannerPicture(painter, rect(), *picture_, title_, *theme_);
  painter.fillRect(rect(), theme_->panel);
  paintText(painter, QRectF(rect()).center(), Qt::AlignHCenter | Qt::AlignVCenter, tr("No position chosen"),
            theme_->mutedText, 13.0);
}

}  // namespace vantage
