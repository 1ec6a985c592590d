#pragma once

#include <QLayout>
#include <QList>

namespace vantage {

/// Lays widgets out in a line from the left, and in further lines where one has no room for all of them: as narrow as
/// its widest widget.
class FlowLayout final : public QLayout {
 public:
  /// @param spacing between widgets and between lines, in device-independent pixels
  explicit FlowLayout(int spacing, QWidget* parent = nullptr);
  ~FlowLayout() override;

  void addItem(QLayoutItem* item) override { items_ << item; }
  [[nodiscard]] int count() const override { return static_cast<int>(items_.size()); }
  [[nodiscard]] QLayoutItem* itemAt(int index) const override { return items_.value(index); }
  QLayoutItem* takeAt(int index) override;
  [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override { return place(QRect(0, 0, width, 0), false); }
  [[nodiscard]] QSize minimumSize() const override;
  [[nodiscard]] QSize sizeHint() const override { return minimumSize(); }
  void setGeometry(const QRect& area) override;

 private:
  /// @return the height that it takes
  int place(const QRect& area, bool move) const;

  QList<QLayoutItem*> items_;
};

}  // namespace vantage
