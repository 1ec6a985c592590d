#include "scenes/tool_notes.h"

#include <QCoreApplication>
#include <cmath>

#include "look/figures.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(ToolNotes)
};

QString millimetres(double value, int decimals) {
  return Text::tr("%1 mm").arg(figureText(value, decimals));
}

}  // namespace

QString distanceText(const Vec3& from, const Vec3& to) {
  const Vec3 d = to - from;
  return Text::tr("%1 (along x %2, y %3, z %4)")
      .arg(millimetres(d.norm(), 2), figureText(std::abs(d.x()), 2), figureText(std::abs(d.y()), 2),
           figureText(std::abs(d.z()), 2));
}

QString sectionPlaceText(const Section& section) {
  return QStringLiteral("%1 %2 %3")
      .arg(QString(QLatin1Char("xyz"[section.axis])), section.flipped ? QStringLiteral("≥") : QStringLiteral("≤"),
           millimetres(section.at, 1));
}

QString sectionText(const PlaneSection& section) {
  if (section.lines.empty()) return Text::tr("The plane cuts nothing.");
  const QString length = millimetres(section.length, 1);
  if (!section.area) return Text::tr("The outline is open, %1 long.").arg(length);
  return Text::tr("The outline is closed, %1 long, and encloses %2 mm².").arg(length, figureText(*section.area, 1));
}

QStringList toolNotes(const ModelViewOptions& options, const ViewTools& tools) {
  QStringList notes;
  if (options.section) {
    notes << Text::tr("Clipped: shown is what has %1").arg(sectionPlaceText(*options.section));
    if (tools.section) notes << sectionText(*tools.section);
  }
  if (options.style == SurfaceStyle::Wireframe) notes << Text::tr("As a wireframe");
  if (options.style == SurfaceStyle::Points) notes << Text::tr("As points");
  if (options.backFaces) notes << Text::tr("Back faces are red");
  if (tools.parallel) notes << Text::tr("In parallel projection");
  if (!tools.measuring) return notes;
  if (tools.measured.size() == 2)
    notes << Text::tr("1 to 2: %1").arg(distanceText(tools.measured[0], tools.measured[1]));
  else
    notes << Text::tr("Place %1: click the surface, or Enter takes the middle of the view")
                 .arg(tools.measured.size() + 1);
  return notes;
}

}  // namespace vantage
