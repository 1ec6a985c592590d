#include "window/stroke_icon.h"

#include <QDir>
#include <QFile>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

#include "base/errors.h"

// Resources of a static library are there once this was called, outside of every namespace.
static void takeIconsIn() {
  Q_INIT_RESOURCE(icons);
}

namespace vantage {
namespace {

constexpr QLatin1String kIcons(":/icons");
constexpr int kIconSizes[] = {16, 24, 32, 48, 72};  // [px]

QByteArray drawingOf(const QString& name, const QColor& colour) {
  takeIconsIn();
  QFile file(kIcons + QLatin1Char('/') + name + QStringLiteral(".svg"));
  if (!file.open(QIODevice::ReadOnly)) throw InvalidInput("there is no icon " + name.toStdString());
  return file.readAll().replace("currentColor", colour.name().toLatin1());
}

QPixmap drawn(const QByteArray& drawing, int pixels) {
  QSvgRenderer renderer(drawing);
  QPixmap pixmap(pixels, pixels);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  renderer.render(&painter);
  return pixmap;
}

}  // namespace

QStringList strokeIconNames() {
  takeIconsIn();
  QStringList names;
  for (const QString& file : QDir(kIcons).entryList({QStringLiteral("*.svg")}, QDir::Files, QDir::Name))
    names << file.chopped(4);
  return names;
}

QPixmap strokePixmap(const QString& name, const QColor& colour, int pixels) {
  return drawn(drawingOf(name, colour), pixels);
}

QIcon strokeIcon(const QString& name, const QColor& normal, const QColor& disabled) {
  const QByteArray drawing = drawingOf(name, normal);
  const QByteArray pale = drawingOf(name, disabled);
  QIcon icon;
  for (const int pixels : kIconSizes) {
    icon.addPixmap(drawn(drawing, pixels), QIcon::Normal);
    icon.addPixmap(drawn(pale, pixels), QIcon::Disabled);
  }
  return icon;
}

}  // namespace vantage
