#include "wizard/test_scan_box.h"

#include <QVBoxLayout>
#include <array>

#include "bench/cut_picture.h"
#include "form_parts.h"
#include "session_controller.h"
#include "settings/settings_form.h"
#include "why_card.h"
#include "wizard/cut_picture_view.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(TestScanBox)
};

QString nameOf(CutReason reason) {
  switch (reason) {
    case CutReason::Table:
      return Text::tr("Table");
    case CutReason::Outside:
      return Text::tr("Outside of the volume");
    case CutReason::Flying:
      return Text::tr("Flying samples");
    case CutReason::Isolated:
      return Text::tr("Isolated samples");
    case CutReason::Island:
      return Text::tr("Small pieces");
    case CutReason::Kept:
      return Text::tr("Used");
    case CutReason::NoSample:
      break;
  }
  return Text::tr("Without a sample");
}

constexpr std::array kShown{CutReason::Kept,   CutReason::Table,    CutReason::Outside,
                            CutReason::Flying, CutReason::Isolated, CutReason::Island};

// The name in the colour that the picture has it in.
QString keyOf(CutReason reason) {
  return QStringLiteral("<span style=\"color:%1\">■</span> %2")
      .arg(colourOf(reason).name(), nameOf(reason).toHtmlEscaped());
}

}  // namespace

TestScanBox::TestScanBox(SessionController& controller, QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      scan_(makeButton(tr("Take &a test scan"), QStringLiteral("testScan"),
                       tr("Scan once from the first position and look at what is used of it. The scan is not kept."))),
      picture_(new CutPictureView),
      verdict_(makeLabel({})),
      figures_(new FigureTable),
      form_(new SettingsForm("cut")) {
  verdict_->setObjectName(QStringLiteral("testScanVerdict"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(scan_);
  column->addWidget(verdict_);
  column->addWidget(picture_);
  column->addWidget(figures_);
  column->addWidget(form_);
  form_->setMinimumWidth(1);
  connect(scan_, &QPushButton::clicked, &controller, &SessionController::testScan);
  connect(form_, &SettingsForm::edited, this, [this] {
    if (form_->consistent()) controller_.setCut(form_->settings().cut);
  });
  connect(&controller.testScans(), &TestScans::scanChanged, this, &TestScanBox::refresh);
  connect(&controller, &SessionController::activityChanged, this, &TestScanBox::refresh);
  connect(&controller, &SessionController::setUpChanged, this, &TestScanBox::refreshCut);
  refresh();
  refreshCut();
}

// The options as they were chosen elsewhere; what is typed here stays as it is typed.
void TestScanBox::refreshCut() {
  const AcquisitionSettings& chosen = controller_.choice().settings;
  if (form_->settings().cut != chosen.cut) form_->setSettings(chosen);
  const QString whyNot =
      controller_.hasSession() ? tr("The session that is open keeps what it was begun with.") : QString();
  for (QWidget* editor : form_->editors()) allow(*editor, whyNot);
}

void TestScanBox::refresh() {
  const auto& scan = controller_.testScans().scanResult();
  allow(*scan_, controller_.permissions().whyNotTestScan());
  figures_->clear();
  picture_->setVisible(scan.has_value());
  if (!scan) {
    setRole(*verdict_, "");
    verdict_->setVisible(true);
    verdict_->setText(tr("A test scan shows what the scanner sees, and what of that is taken for the object."));
    return;
  }
  picture_->show(scan->picture);
  const std::size_t used = scan->counts[static_cast<std::size_t>(CutReason::Kept)];
  verdict_->setText(used == 0 ? tr("Nothing of the scan is used: look whether the object stands inside the viewing "
                                   "volume, and whether too much is cut.")
                              : QString());
  setRole(*verdict_, used == 0 ? "warning" : "");
  verdict_->setVisible(used == 0);
  for (const CutReason reason : kShown) {
    const std::size_t count = scan->counts[static_cast<std::size_t>(reason)];
    if (count > 0 || reason == CutReason::Kept)
      figures_->add(keyOf(reason),
                    count == 1 ? tr("1 sample") : tr("%1 samples").arg(figureText(static_cast<double>(count))));
  }
}

}  // namespace vantage
