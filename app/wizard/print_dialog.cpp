#include "wizard/print_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <limits>

#include "form_parts.h"
#include "help/help_topic.h"

namespace vantage {
namespace {

// In the order of the list.
enum class Closing { All, UpTo, None };

QDoubleSpinBox* makeLength(const QString& name, const QString& title, double most, int decimals, double value) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setAccessibleName(title);
  box->setDecimals(decimals);
  box->setRange(decimals > 1 ? 0.001 : 0.1, most);
  box->setValue(value);
  box->setSuffix(PrintDialog::tr(" mm"));
  return box;
}

QCheckBox* makeCheck(const QString& text, const QString& name, const QString& help, bool checked) {
  auto* check = new QCheckBox(text);
  check->setObjectName(name);
  check->setChecked(checked);
  setHelp(*check, help);
  return check;
}

}  // namespace

PrintDialog::PrintDialog(QWidget* parent)
    : QDialog(parent),
      close_(new QComboBox),
      width_(makeLength(QStringLiteral("closeWidth"), tr("Widest opening that is closed"), 10'000.0, 1, 8.0)),
      largest_(makeCheck(tr("Leave loose pieces out"), QStringLiteral("largestPiece"),
                         tr("Only the largest piece of the surface is written."), true)),
      coarser_(makeCheck(tr("Fewer triangles, no farther from the model than"), QStringLiteral("coarser"),
                         tr("The distance is measured afterwards, from both surfaces."), false)),
      error_(makeLength(QStringLiteral("coarserError"), tr("Greatest distance from the model"), 100.0, 3, 0.05)),
      unit_(new QComboBox),
      printable_(
          makeCheck(tr("Only write what can be printed"), QStringLiteral("onlyPrintable"),
                    tr("One closed surface in one piece that passes nowhere through itself. Otherwise nothing is "
                       "written, and you learn why."),
                    true)) {
  setHelpTopic(*this, QStringLiteral("finish#ready-to-print"));
  setObjectName(QStringLiteral("printDialog"));
  setWindowTitle(tr("Ready to print"));
  close_->setObjectName(QStringLiteral("closeOpenings"));
  close_->setAccessibleName(tr("Close openings"));
  close_->addItems({tr("all"), tr("up to a width"), tr("none")});
  unit_->setObjectName(QStringLiteral("unit"));
  unit_->setAccessibleName(tr("Unit of the file"));
  unit_->addItems({tr("millimetres"), tr("inches")});
  auto* form = new QFormLayout;
  form->addRow(tr("Close &openings:"), close_);
  form->addRow(tr("&Width:"), width_);
  form->addRow(largest_);
  form->addRow(coarser_);
  form->addRow(tr("&Distance:"), error_);
  form->addRow(tr("&Unit:"), unit_);
  form->addRow(printable_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  QPushButton* go = buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole);
  go->setObjectName(QStringLiteral("exportPrint"));
  go->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(
      makeLabel(tr("What closes an opening is made up: nobody measured it. PLY and 3MF mark it; STL and OBJ "
                   "cannot. The session stays as it is.")));
  layout->addLayout(form);
  layout->addWidget(buttons);
  connect(close_, &QComboBox::currentIndexChanged, this, &PrintDialog::refresh);
  connect(coarser_, &QCheckBox::toggled, this, &PrintDialog::refresh);
  refresh();
}

HandOver PrintDialog::choice() const {
  HandOver choice;
  const auto closing = static_cast<Closing>(close_->currentIndex());
  if (closing != Closing::None) choice.finishing.close.emplace();
  if (closing == Closing::UpTo) choice.finishing.close->maxWidth = width_->value();
  if (largest_->isChecked()) choice.finishing.leaveOut = std::numeric_limits<double>::infinity();
  if (coarser_->isChecked()) choice.finishing.simplify = SimplificationOptions{.maxError = error_->value()};
  choice.finishing.repair = printable_->isChecked();
  choice.unit = unit_->currentIndex() == 0 ? LengthUnit::Millimetre : LengthUnit::Inch;
  choice.onlyPrintable = printable_->isChecked();
  return choice;
}

void PrintDialog::refresh() {
  width_->setEnabled(static_cast<Closing>(close_->currentIndex()) == Closing::UpTo);
  error_->setEnabled(coarser_->isChecked());
}

}  // namespace vantage
