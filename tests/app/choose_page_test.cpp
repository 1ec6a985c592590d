#include "wizard/choose_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QTemporaryDir>
#include <fstream>

#include "io/mesh_writer.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// The page over a folder of resources with one scanner and one object.
class ChoosePageTest : public ::testing::Test {
 protected:
  ChoosePageTest() {
    QDir(folder_.path()).mkpath("scanners");
    QDir(folder_.path()).mkpath("objects");
    std::ofstream(path("scanners/rotating_stripe.json")) << testing::smallProfileSource().text;
    exportMesh(testing::smallObject(), path("objects/mug.ply"));
    page_ = std::make_unique<ChoosePage>(controller_, folder_.path());
    object_ = page_->findChild<QComboBox*>("object");
  }

  [[nodiscard]] std::string path(const QString& name) const { return folder_.filePath(name).toStdString(); }

  QTemporaryDir folder_;
  SynchronousJobRunner jobs_;
  SessionController controller_{jobs_, ""};
  std::unique_ptr<ChoosePage> page_;
  QComboBox* object_ = nullptr;
};

TEST_F(ChoosePageTest, AsksForTheObjectOfTheSimulatedScanner) {
  EXPECT_TRUE(page_->complete());
  object_->setCurrentIndex(-1);
  EXPECT_FALSE(page_->complete());
}

TEST_F(ChoosePageTest, ShowsNoObjectForASessionOfRecordedScansAndOneAgainAfterIt) {
  static_cast<void>(Session::create(path("recorded.vantage"), {std::nullopt, {}, nullptr}));
  controller_.open(folder_.filePath("recorded.vantage"));
  ASSERT_TRUE(controller_.hasSession());
  EXPECT_TRUE(object_->currentText().isEmpty()) << object_->currentText().toStdString();
  EXPECT_TRUE(page_->complete());
  controller_.close();
  EXPECT_TRUE(object_->currentData().toString().endsWith("mug.ply"));
  EXPECT_TRUE(page_->complete());
}

}  // namespace
}  // namespace vantage
