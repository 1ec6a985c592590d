#pragma once

#include <QWidget>
#include <memory>

#include "look/theme.h"
#include "planning/scanner_picture.h"

namespace vantage {

/// What the scanner would see from a position, ray by ray. The picture is made by computeScannerPicture, beside the UI
/// thread.
class ScannerPictureView final : public QWidget {
  Q_OBJECT

 public:
  explicit ScannerPictureView(QWidget* parent = nullptr);

  /// @param picture null shows an empty view
  void setPicture(std::shared_ptr<const ScannerPicture> picture, const QString& title);
  void setTheme(const Theme& theme);

  [[nodiscard]] QSize sizeHint() const override { return {360, 300}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 160}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::shared_ptr<const ScannerPicture> picture_;
  QString title_;
  const Theme* theme_;
};

}  // namespace vantage
