#include "wizard/print_dialog.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <cmath>

#include "print_text.h"

namespace vantage {
namespace {

TEST(PrintDialog, BeginsWithWhatMakesAPrintableModel) {
  const PrintDialog dialog;
  const HandOver how = dialog.choice();
  ASSERT_TRUE(how.finishing.close.has_value());
  EXPECT_FALSE(how.finishing.close->maxWidth.has_value());
  ASSERT_TRUE(how.finishing.leaveOut.has_value());
  EXPECT_TRUE(std::isinf(*how.finishing.leaveOut));
  EXPECT_TRUE(how.finishing.repair);
  EXPECT_FALSE(how.finishing.simplify.has_value());
  EXPECT_EQ(how.unit, LengthUnit::Millimetre);
  EXPECT_TRUE(how.onlyPrintable);
}

TEST(PrintDialog, AsksForNumbersOnlyWhereTheyCount) {
  PrintDialog dialog;
  auto* width = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("closeWidth"));
  auto* error = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("coarserError"));
  auto* close = dialog.findChild<QComboBox*>(QStringLiteral("closeOpenings"));
  auto* coarser = dialog.findChild<QCheckBox*>(QStringLiteral("coarser"));
  EXPECT_FALSE(width->isEnabled());
  EXPECT_FALSE(error->isEnabled());
  close->setCurrentIndex(1);
  coarser->setChecked(true);
  EXPECT_TRUE(width->isEnabled());
  EXPECT_TRUE(error->isEnabled());
  width->setValue(12.5);
  error->setValue(0.125);
  dialog.findChild<QComboBox*>(QStringLiteral("unit"))->setCurrentIndex(1);
  const HandOver how = dialog.choice();
  EXPECT_EQ(how.finishing.close->maxWidth, 12.5);
  EXPECT_EQ(how.finishing.simplify->maxError, 0.125);
  EXPECT_EQ(how.unit, LengthUnit::Inch);
  close->setCurrentIndex(2);
  EXPECT_FALSE(dialog.choice().finishing.close.has_value());
}

TEST(PrintText, GivesEveryReasonALine) {
  PrintCheck check;
  EXPECT_TRUE(whyNotPrintable(check).isEmpty());
  check.openings = 3;
  check.widestOpening = 12.0;
  check.pieces = 2;
  check.faults = {PrintFault::Open, PrintFault::Pieces};
  const QString text = whyNotPrintable(check);
  EXPECT_EQ(text.count(QLatin1Char('\n')), 1);
  EXPECT_TRUE(text.contains(QStringLiteral("12")));
}

}  // namespace
}  // namespace vantage
