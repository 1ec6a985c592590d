#include "look/figures.h"

#include <QLocale>

namespace vantage {

QString figureText(double value, int decimals) {
  constexpr qsizetype kFewest = 5;
  QString number = QLocale::c().toString(value, 'f', decimals);
  const qsizetype first = number.startsWith(QLatin1Char('-')) ? 1 : 0;
  const qsizetype point = number.indexOf(QLatin1Char('.'));
  const qsizetype end = point < 0 ? number.size() : point;
  if (point >= 0) number.replace(point, 1, QLocale().decimalPoint());
  if (end - first >= kFewest)
    for (qsizetype i = end - 3; i > first; i -= 3) number.insert(i, QChar(0x202F));
  return number;
}

}  // namespace vantage
