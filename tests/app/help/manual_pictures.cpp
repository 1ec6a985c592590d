// Makes the pictures of the operator's manual anew, of the window as it is: the target manual_pictures runs it.
#include <gtest/gtest.h>

#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QLineEdit>
#include <QPainter>
#include <QSpinBox>
#include <algorithm>

#include "app/desk.h"
#include "docks/model_pane.h"
#include "docks/why_panel.h"
#include "wizard/wizard.h"

namespace vantage {
namespace {

using testing::Desk;

constexpr qint64 kLargest = 150'000;  // bytes
constexpr int kWidest = 820;

// No wider than the manual needs it, with 32 levels of every colour: shading takes a third of the room then.
QImage small(const QImage& image) {
  QImage reduced = (image.width() > kWidest ? image.scaledToWidth(kWidest, Qt::SmoothTransformation) : image)
                       .convertToFormat(QImage::Format_RGB32);
  for (int y = 0; y < reduced.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(reduced.scanLine(y));
    const auto coarse = [](int value) { return (value & 0xf8) | (value >> 5); };
    for (int x = 0; x < reduced.width(); ++x)
      line[x] = qRgb(coarse(qRed(line[x])), coarse(qGreen(line[x])), coarse(qBlue(line[x])));
  }
  return reduced;
}

class ManualPictures : public ::testing::Test {
 protected:
  void keep(const QImage& image, const QString& name) {
    const QDir folder(qEnvironmentVariable("VANTAGE_MANUAL_PICTURES"));
    ASSERT_TRUE(folder.exists()) << "VANTAGE_MANUAL_PICTURES names the folder that they are written to";
    const QString file = folder.filePath(name + QStringLiteral(".png"));
    ASSERT_TRUE(small(image).save(file, "PNG", 0)) << file.toStdString();
    EXPECT_LT(QFileInfo(file).size(), kLargest) << file.toStdString();
  }
  void keepPart(QWidget& part, const QString& name) {
    desk_.window().views().model().view().finishLoading();
    Desk::settle();
    keep(part.grab().toImage(), name);
  }
  void keepPage(const QString& name) { keepPart(desk_.window().wizard(), name); }
  QWidget& dock(const char* name) { return *desk_.window().findChild<QDockWidget*>(name); }

  Desk desk_{{1280, 800}, false};
};

TEST_F(ManualPictures, AreMade) {
  auto* folder = desk_.window().findChild<QLineEdit*>("folder");
  folder->setText(QStringLiteral("/home/me/Documents/Vantage/mug"));
  desk_.window().findChild<QSpinBox*>("max_views")->setValue(40);
  keepPage("choose");
  folder->setText(Desk::folder());
  desk_.next();
  desk_.controller().testTurn();
  keepPage("check");
  desk_.next();
  for (int i = 0; i < 3; ++i) desk_.controller().step();
  keepPage("acquire");
  keepPart(desk_.window().views().model(), "model");
  dock("spaceDock").raise();
  Desk::settle();
  keepPart(dock("spaceDock"), "space");
  dock("objectiveDock").raise();
  Desk::settle();
  const QImage objective = dock("objectiveDock").grab().toImage();
  const QImage why = dock("whyDock").grab().toImage();
  QImage both(std::max(objective.width(), why.width()), objective.height() + why.height(), QImage::Format_RGB32);
  both.fill(Qt::white);
  QPainter painter(&both);
  painter.drawImage(0, 0, objective);
  painter.drawImage(0, objective.height(), why);
  painter.end();
  keep(both, "why");
  desk_.controller().run();
  keep(desk_.picture("manual"), "window");
  keepPage("review");
}

}  // namespace
}  // namespace vantage
