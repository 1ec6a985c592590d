#include "screenshots/painted_text.h"

#include <QAbstractScrollArea>
#include <QFontMetricsF>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>

namespace vantage::testing {
namespace {

// So far ink may reach over an edge: glyphs are smoothed [pixels].
constexpr double kTolerance = 1.0;
// Farther than anything is scrolled [pixels].
constexpr double kBeyond = 1e6;

// Paints nothing and remembers the text.
class TextRecorder : public QPaintEngine {
 public:
  explicit TextRecorder(std::vector<PaintedText>& texts) : QPaintEngine(AllFeatures), texts_(texts) {}

  bool begin(QPaintDevice*) override { return true; }
  bool end() override { return true; }
  void updateState(const QPaintEngineState& now) override {
    if (now.state() & DirtyTransform) transform_ = now.transform();
  }
  void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
  void drawImage(const QRectF&, const QImage&, const QRectF&, Qt::ImageConversionFlags) override {}
  void drawPath(const QPainterPath&) override {}
  void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
  void drawTextItem(const QPointF& at, const QTextItem& item) override {
    if (item.text().trimmed().isEmpty()) return;
    const QRectF ink = QFontMetricsF(item.font()).tightBoundingRect(item.text()).translated(at);
    texts_.push_back({item.text(), transform_.mapRect(ink), {}, {}});
  }
  [[nodiscard]] Type type() const override { return User; }

 private:
  std::vector<PaintedText>& texts_;
  QTransform transform_;
};

// A sheet of the size of a widget.
class Sheet : public QPaintDevice {
 public:
  Sheet(const QWidget& widget, std::vector<PaintedText>& texts) : widget_(widget), recorder_(texts) {}
  [[nodiscard]] QPaintEngine* paintEngine() const override { return &recorder_; }

 protected:
  [[nodiscard]] int metric(PaintDeviceMetric metric) const override {
    switch (metric) {
      case PdmWidth:
        return widget_.width();
      case PdmHeight:
        return widget_.height();
      case PdmDevicePixelRatio:
        return 1;
      case PdmDevicePixelRatioScaled:
        return static_cast<int>(devicePixelRatioFScale());
      case PdmDpiX:
      case PdmPhysicalDpiX:
        return widget_.logicalDpiX();
      case PdmDpiY:
      case PdmPhysicalDpiY:
        return widget_.logicalDpiY();
      case PdmNumColors:
        return 0;
      case PdmDepth:
        return 32;
      case PdmWidthMM:
        return widget_.widthMM();
      case PdmHeightMM:
        return widget_.heightMM();
    }
    return 0;
  }

 private:
  const QWidget& widget_;
  mutable TextRecorder recorder_;
};

QRectF grown(const QRectF& rect, double by) {
  return rect.adjusted(-by, -by, by, by);
}

// What a widget may paint on. Lists paint their rows themselves, also those that are scrolled out of sight.
QRectF roomOf(const QWidget& widget) {
  const auto* area = qobject_cast<const QAbstractScrollArea*>(widget.parentWidget());
  const bool scrolls = area != nullptr && area->viewport() == &widget;
  return grown(widget.rect(), scrolls ? kBeyond : 0.0);
}

}  // namespace

std::vector<PaintedText> paintedText(QWidget& window) {
  std::vector<PaintedText> all;
  QList<QWidget*> widgets = window.findChildren<QWidget*>();
  widgets.prepend(&window);
  for (QWidget* widget : widgets) {
    if (!widget->isVisible() || widget->window() != &window) continue;
    std::vector<PaintedText> texts;
    Sheet sheet(*widget, texts);
    widget->render(&sheet, {}, {}, QWidget::RenderFlags());
    const QPointF corner = widget->mapTo(&window, QPoint(0, 0));
    const QRectF shown = QRectF(widget->visibleRegion().boundingRect()).translated(corner);
    for (PaintedText& text : texts) {
      text.place.translate(corner);
      text.room = roomOf(*widget).translated(corner);
      text.shown = text.place & shown;
      all.push_back(text);
    }
  }
  return all;
}

QStringList cutOff(const std::vector<PaintedText>& texts) {
  QStringList names;
  for (const PaintedText& t : texts)
    if (!grown(t.room, kTolerance).contains(t.place)) names << t.text;
  return names;
}

QStringList overlapping(const std::vector<PaintedText>& texts) {
  QStringList names;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const QRectF both = texts[i].shown & texts[j].shown;
      if (both.width() > kTolerance && both.height() > kTolerance && texts[i].text != texts[j].text)
        names << texts[j].text + QStringLiteral(" / ") + texts[i].text;
    }
  }
  return names;
}

}  // namespace vantage::testing
