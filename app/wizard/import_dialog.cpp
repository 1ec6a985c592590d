#include "wizard/import_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QRegularExpression>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "form_parts.h"
#include "help/help_topic.h"
#include "scanner/length_unit.h"
#include "session_controller.h"
#include "wizard/scan_list.h"

namespace vantage {
namespace {

// Of a profile that is not read yet: what it has is said when the scans are read.
constexpr int kAnyPosition = 100'000;

struct Text {
  Q_DECLARE_TR_FUNCTIONS(ImportDialog)
};

QString unitText(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Millimetre:
      return Text::tr("millimetres");
    case LengthUnit::Centimetre:
      return Text::tr("centimetres");
    case LengthUnit::Inch:
      return Text::tr("inches");
    case LengthUnit::Metre:
      break;
  }
  return Text::tr("metres");
}

// What the command line calls them, and what it means.
std::vector<std::pair<const char*, QString>> frames() {
  return {{"camera", Text::tr("along z, y down (a camera)")},
          {"gl", Text::tr("along −z, y up (OpenGL)")},
          {"x+", Text::tr("along x")},
          {"x-", Text::tr("along −x")},
          {"y+", Text::tr("along y")},
          {"y-", Text::tr("along −y")},
          {"world", Text::tr("points are in the object's coordinates")},
          {"cylinder", Text::tr("columns go around an axis")},
          {"profile", Text::tr("points are in the coordinates of the profile")}};
}

QComboBox* makeBox(const QString& name, const QString& title, const QString& help) {
  auto* box = new QComboBox;
  box->setObjectName(name);
  box->setAccessibleName(title);
  box->setToolTip(help);
  return box;
}

QLineEdit* makeEdit(const QString& name, const QString& title, const QString& help, const QString& placeholder) {
  auto* edit = new QLineEdit;
  edit->setObjectName(name);
  edit->setAccessibleName(title);
  edit->setToolTip(help);
  edit->setPlaceholderText(placeholder);
  return edit;
}

// "480x640": both at least 2. Nothing for anything else.
std::optional<GridSize> gridIn(const QString& text) {
  static const QRegularExpression kGrid(QStringLiteral("^\\s*(\\d{1,6})\\s*[x×]\\s*(\\d{1,6})\\s*$"));
  const auto match = kGrid.match(text);
  const GridSize grid{match.captured(1).toULongLong(), match.captured(2).toULongLong()};
  return match.hasMatch() && grid.rows >= 2 && grid.columns >= 2 ? std::optional(grid) : std::nullopt;
}

}  // namespace

ImportDialog::ImportDialog(SessionController& controller, Into into, QWidget* parent)
    : QDialog(parent),
      controller_(controller),
      into_(into),
      list_(new ScanList),
      scanner_(makeBox(QStringLiteral("importScanner"), tr("Scanner"),
                       tr("Scans of a known scanner lie on its rays; of others the rays are found from the files."))),
      poses_(new QLineEdit),
      unit_(makeBox(QStringLiteral("importUnit"), tr("Unit"), tr("What the command line calls --unit."))),
      frame_(makeBox(QStringLiteral("importFrame"), tr("Where the scanner looks"),
                     tr("In the coordinates of the files; what the command line calls --frame."))),
      grid_(makeEdit(QStringLiteral("importGrid"), tr("Rows and columns"),
                     tr("Of points as text, one line for every cell; what the command line calls --grid."),
                     tr("As the files say, for instance 480x640"))),
      noSample_(
          makeEdit(QStringLiteral("importNoSample"), tr("Where nothing was measured"),
                   tr("The value that stands where nothing was measured; what the command line calls --no-sample."),
                   tr("As it is found, for instance 0 or -9999"))),
      folder_(new QLineEdit),
      complaint_(makeLabel(QString(), "warning")),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
  setHelpTopic(*this, QStringLiteral("import"));
  setWindowTitle(into == Into::NewSession ? tr("Import recorded scans") : tr("Add scans to the session"));
  resize(760, 580);
  build();
  connect(list_, &ScanList::edited, this, &ImportDialog::refresh);
  connect(scanner_, &QComboBox::currentIndexChanged, this, &ImportDialog::refresh);
  connect(folder_, &QLineEdit::textChanged, this, &ImportDialog::refresh);
  connect(poses_, &QLineEdit::textChanged, this, &ImportDialog::refresh);
  connect(buttons_, &QDialogButtonBox::accepted, this, &ImportDialog::bringIn);
  connect(buttons_, &QDialogButtonBox::rejected, this, &ImportDialog::reject);
  connect(&controller, &SessionController::activityChanged, this, &ImportDialog::refresh);
  connect(&controller, &SessionController::imported, this, &QDialog::accept);
  connect(&controller, &SessionController::importFailed, this, &ImportDialog::say);
  suggest({});
}

void ImportDialog::build() {
  auto* column = new QVBoxLayout(this);
  column->addWidget(makeLabel(into_ == Into::NewSession
                                  ? tr("Scans of one scanner, of one object. They are registered and merged; where "
                                       "they were taken from is found, or said here.")
                                  : tr("Each scan is registered at the position that it was taken from, one after the "
                                       "other."),
                              "muted"));
  column->addWidget(list_, 1);
  auto* form = new QFormLayout;
  const bool isNew = into_ == Into::NewSession;
  if (isNew) form->addRow(tr("Taken with"), scanner_);
  poses_->setObjectName(QStringLiteral("importPoses"));
  poses_->setAccessibleName(tr("List of poses"));
  poses_->setPlaceholderText(tr("None: as the files say, or found"));
  auto* browse = new QToolButton;
  browse->setText(QStringLiteral("…"));
  browse->setToolTip(tr("Take a file"));
  browse->setAccessibleName(tr("Take a file"));
  connect(browse, &QToolButton::clicked, this, &ImportDialog::browsePoses);
  auto* posesRow = new QWidget;
  auto* row = new QHBoxLayout(posesRow);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(poses_, 1);
  row->addWidget(browse);
  if (isNew) form->addRow(tr("List of poses (.conf)"), posesRow);
  unit_->addItem(tr("as it is found"), QString());
  for (const LengthUnit unit : kLengthUnits) unit_->addItem(unitText(unit), millimetresIn(unit));
  form->addRow(tr("Unit (--unit)"), unit_);
  frame_->addItem(tr("as it is found"), QString());
  for (const auto& [key, text] : frames()) frame_->addItem(text, QString::fromLatin1(key));
  form->addRow(tr("The scanner looks (--frame)"), frame_);
  form->addRow(tr("Rows × columns (--grid)"), grid_);
  form->addRow(tr("No sample is (--no-sample)"), noSample_);
  folder_->setObjectName(QStringLiteral("importFolder"));
  folder_->setAccessibleName(tr("Folder of the session"));
  if (isNew) form->addRow(tr("Save everything in"), folder_);
  for (QLineEdit* edit : {grid_, noSample_}) connect(edit, &QLineEdit::textChanged, this, &ImportDialog::refresh);
  for (QWidget* unused : {static_cast<QWidget*>(scanner_), posesRow, static_cast<QWidget*>(folder_)})
    if (!isNew) unused->setParent(this), unused->hide();
  column->addLayout(form);
  complaint_->setObjectName(QStringLiteral("importComplaint"));
  column->addWidget(complaint_);
  buttons_->button(QDialogButtonBox::Ok)->setText(isNew ? tr("&Import") : tr("&Add"));
  buttons_->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("bringIn"));
  column->addWidget(buttons_);
}

void ImportDialog::suggest(const ImportChoice& choice) {
  suggested_ = choice;
  scanner_->clear();
  scanner_->addItem(tr("a scanner without a profile: its rays are found from the files"), QString());
  if (!choice.scanner.empty()) {
    const QString path = QString::fromStdString(choice.scanner);
    scanner_->addItem(tr("the scanner of %1").arg(QFileInfo(path).fileName()), path);
  }
  folder_->setText(QString::fromStdString(choice.folder));
  say({});
}

void ImportDialog::addFiles(const QStringList& paths) {
  const bool first = list_->files().empty();
  list_->addFiles(paths, into_ == Into::OpenSession && first ? controller_.present().nextPosition() : std::nullopt);
}

void ImportDialog::reject() {
  if (controller_.idle()) return QDialog::reject();
  controller_.stop();
}

void ImportDialog::browsePoses() {
  const QString path = QFileDialog::getOpenFileName(this, tr("List of poses"), {}, tr("Poses (*.conf)"));
  if (!path.isEmpty()) poses_->setText(path);
}

QString ImportDialog::whyNot() const {
  if (!controller_.idle()) return tr("Something else is under way.");
  if (into_ == Into::OpenSession)
    if (QString why = controller_.permissions().whyNotAddScans(); !why.isEmpty()) return why;
  if (list_->files().empty()) return tr("Add the range files first.");
  const auto positions = list_->positions();
  const auto known = std::count_if(positions.begin(), positions.end(), [](const auto& p) { return p.has_value(); });
  if (into_ == Into::OpenSession && known < static_cast<std::ptrdiff_t>(positions.size()))
    return tr("Say of every file from which position it was taken.");
  if (known > 0 && !poses_->text().trimmed().isEmpty())
    return tr("Positions and a list of poses both say where the scans were taken: give one.");
  if (!grid_->text().trimmed().isEmpty() && !gridIn(grid_->text()))
    return tr("Rows and columns are two numbers from 2 on, for instance 480x640.");
  bool isNumber = true;
  if (!noSample_->text().trimmed().isEmpty()) static_cast<void>(noSample_->text().toDouble(&isNumber));
  if (!isNumber) return tr("The value where nothing was measured is a number.");
  if (into_ == Into::NewSession && folder_->text().trimmed().isEmpty()) return tr("Choose a folder first.");
  return {};
}

ImportChoice ImportDialog::choice() const {
  ImportChoice choice = suggested_;
  choice.scanner = scanner_->currentData().toString().toStdString();
  choice.folder = folder_->text().trimmed().toStdString();
  choice.recorded.files = list_->files();
  choice.recorded.positions = list_->positions();
  choice.recorded.poses = poses_->text().trimmed().toStdString();
  if (unit_->currentIndex() > 0) choice.recorded.reading.unit = unit_->currentData().toDouble();
  choice.recorded.reading.grid = gridIn(grid_->text());
  if (!noSample_->text().trimmed().isEmpty()) choice.recorded.reading.noSample = noSample_->text().toDouble();
  if (frame_->currentIndex() > 0)
    choice.recorded.reading.frame = parseFrame(frame_->currentData().toString().toStdString());
  return choice;
}

void ImportDialog::bringIn() {
  say({});
  if (into_ == Into::NewSession)
    controller_.importScans(choice());
  else
    controller_.addScans(choice().recorded);
}

void ImportDialog::say(const QString& complaint) {
  complaint_->setText(complaint);
  complaint_->setVisible(!complaint.isEmpty());
  refresh();
}

void ImportDialog::refresh() {
  const SharedSetUp& setUp = controller_.setUp();
  if (into_ == Into::OpenSession)
    list_->setPositions(setUp && setUp->profile ? static_cast<int>(setUp->profile->workspace.size()) : 0);
  else
    list_->setPositions(scanner_->currentIndex() > 0 ? kAnyPosition : 0);
  allow(*buttons_->button(QDialogButtonBox::Ok), whyNot());
  buttons_->button(QDialogButtonBox::Cancel)->setText(controller_.idle() ? tr("Cancel") : tr("Stop"));
}

}  // namespace vantage
