#include <gtest/gtest.h>

#include <QApplication>
#include <QLocale>

#include "look/legend.h"

// No display: Qt draws into memory, VTK through OSMesa.
int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  ::testing::InitGoogleTest(&argc, argv);
  const QApplication app(argc, argv);
  QLocale::setDefault(QLocale::c());
  QApplication::setStyle(QStringLiteral("Fusion"));
  QApplication::setFont(vantage::pictureFont(13.0));
  return RUN_ALL_TESTS();
}
