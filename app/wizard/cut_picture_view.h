#pragma once

#include <QImage>
#include <QWidget>

namespace vantage {

/// The picture of a scan in the width of its page, with the colours of what is cut explained below.
class CutPictureView final : public QWidget {
  Q_OBJECT

 public:
  explicit CutPictureView(QWidget* parent = nullptr);

  void show(const QImage& picture);
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override { return {280, heightForWidth(280)}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage picture_;
};

}  // namespace vantage
