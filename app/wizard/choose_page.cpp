#include "wizard/choose_page.h"

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QStandardPaths>
#include <QToolButton>
#include <QVBoxLayout>

#include "base/errors.h"
#include "form_parts.h"
#include "help/help_topic.h"
#include "io/mesh_reader.h"
#include "recent/recent_list.h"
#include "settings/settings_form.h"
#include "wizard/device_editor.h"

namespace vantage {
namespace {

const QString kPreferredObject = QStringLiteral("mug.ply");

// A name for people: "rotating_stripe.json" is "Rotating stripe".
QString readable(const QString& path) {
  QString name = QFileInfo(path).completeBaseName().replace(QLatin1Char('_'), QLatin1Char(' '));
  if (!name.isEmpty()) name[0] = name[0].toUpper();
  return name;
}

void select(QComboBox& box, const QString& path) {
  int index = box.findData(path);
  if (index < 0) {
    box.addItem(readable(path), path);
    index = box.count() - 1;
  }
  box.setCurrentIndex(index);
}

// "*.obj *.off"
QString patternsOf(const std::vector<std::string>& extensions) {
  QStringList patterns;
  for (const std::string& extension : extensions) patterns << QStringLiteral("*.") + QString::fromStdString(extension);
  return patterns.join(QLatin1Char(' '));
}

// A folder of that name among the documents, or the first with a number that is not there yet.
QString freeFolder(const QString& name) {
  const QString base =
      QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + QStringLiteral("/Vantage/") + name;
  QString folder = base;
  for (int i = 2; QFileInfo::exists(folder); ++i) folder = base + QLatin1Char('-') + QString::number(i);
  return folder;
}

QToolButton* browseButton(const QString& what) {
  auto* button = new QToolButton;
  button->setObjectName(QStringLiteral("browse"));
  button->setText(QStringLiteral("…"));
  button->setToolTip(what);
  button->setAccessibleName(what);
  return button;
}

}  // namespace

ChoosePage::ChoosePage(SessionController& controller, const QString& resources, QWidget* parent)
    : WizardPage(controller, parent), resources_(resources) {
  setHelpTopic(*this, QStringLiteral("choose"));
  build();
  fill(*scanner_, QStringLiteral("scanners"), QStringLiteral("*.json"), QStringLiteral("rotating_stripe.json"));
  fill(*object_, QStringLiteral("objects"), QStringLiteral("*.ply"), kPreferredObject);
  object_->setPlaceholderText(tr("None: the scans were recorded elsewhere"));
  suggestFolder();
  connect(object_, &QComboBox::currentIndexChanged, this, [this] {
    suggestFolder();
    emit changed();
  });
  connect(scanner_, &QComboBox::currentIndexChanged, this, [this] { emit changed(); });
  connect(folder_, &QLineEdit::textChanged, this, [this] { emit changed(); });
  connect(&controller, &SessionController::setUpChanged, this, &ChoosePage::takeWhatWasTried);
  connect(&controller, &SessionController::sessionChanged, this, [this] {
    if (!this->controller().hasSession()) {
      if (object_->currentIndex() < 0) select(*object_, resources_ + QStringLiteral("/objects/") + kPreferredObject);
      folderIsChosen_ = false;
      suggestFolder();
    }
    entered();
  });
}

QComboBox* ChoosePage::addFileRow(QVBoxLayout& column, const QString& label, const QString& name, const QString& help,
                                  const QString& filter) {
  column.addWidget(makeLabel(label, "section"));
  auto* box = new QComboBox;
  box->setObjectName(name);
  box->setAccessibleName(label);
  box->setToolTip(help);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  // A long placeholder must not widen the page.
  box->setMinimumWidth(80);
  QToolButton* browse = browseButton(tr("Take another file"));
  connect(browse, &QToolButton::clicked, this, [this, box, label, filter] {
    const QString path =
        QFileDialog::getOpenFileName(this, label, {}, filter, nullptr, QFileDialog::HideNameFilterDetails);
    if (!path.isEmpty()) select(*box, path);
  });
  auto* row = new QHBoxLayout;
  row->addWidget(box, 1);
  row->addWidget(browse);
  column.addLayout(row);
  return box;
}

void ChoosePage::build() {
  column().addWidget(
      makeLabel(tr("Vantage scans an object from positions that it chooses itself, until nothing is left "
                   "to see."),
                "muted"));
  devices_ = new DeviceEditor;
  connect(devices_, &DeviceEditor::edited, this, [this] {
    suggestCut();
    showWhatIsSimulated();
    suggestFolder();
    emit changed();
  });
  connect(devices_, &DeviceEditor::rigRead, this, &ChoosePage::takeRig);
  column().addWidget(devices_);
  scanner_ = addFileRow(column(), tr("Scanner profile"), QStringLiteral("scanner"),
                        tr("Profile of the scanner and its turntable."), tr("Scanner profiles (*.json)"));
  objectRow_ = new QWidget;
  auto* object = new QVBoxLayout(objectRow_);
  object->setContentsMargins(0, 0, 0, 0);
  object_ = addFileRow(*object, tr("Object for the simulated scanner"), QStringLiteral("object"),
                       tr("Mesh that the simulated scanner looks at."),
                       tr("Meshes (%1);;All files (*)").arg(patternsOf(readableMeshExtensions())));
  column().addWidget(objectRow_);
  addSection(tr("Save everything in"));
  folder_ = new QLineEdit;
  folder_->setObjectName(QStringLiteral("folder"));
  folder_->setAccessibleName(tr("Folder of the session"));
  QToolButton* browse = browseButton(tr("Take another folder"));
  connect(browse, &QToolButton::clicked, this, [this] {
    const QString path = QFileDialog::getExistingDirectory(this, tr("Folder of the session"), folder_->text());
    if (path.isEmpty()) return;
    folderIsChosen_ = true;
    folder_->setText(path);
  });
  connect(folder_, &QLineEdit::textEdited, this,
          [this](const QString& text) { folderIsChosen_ = !text.trimmed().isEmpty(); });
  auto* row = new QHBoxLayout;
  row->addWidget(folder_, 1);
  row->addWidget(browse);
  column().addLayout(row);

  addSection(tr("Options"));
  form_ = new SettingsForm;
  form_->setMinimumWidth(1);
  connect(form_, &SettingsForm::edited, this, [this] { emit changed(); });
  column().addWidget(form_);
  column().addStretch();
  auto* open = makeButton(tr("&Open a session…"), QStringLiteral("open"), tr("Go on with a session from a file."));
  connect(open, &QPushButton::clicked, this, &ChoosePage::openRequested);
  column().addWidget(open);
  auto* import = makeButton(tr("&Import recorded scans…"), QStringLiteral("import"),
                            tr("Make a session of range files that were recorded before; they can also be dropped on "
                               "the window."));
  connect(import, &QPushButton::clicked, this, &ChoosePage::importRequested);
  column().addWidget(import);
}

// Below the words that the page begins with.
void ChoosePage::showRecent(RecentSessions& sessions) {
  auto* list = new RecentList(sessions, controller());
  connect(list, &RecentList::chosen, this, &ChoosePage::recentRequested);
  column().insertWidget(1, list);
}

QString ChoosePage::whyNoObject() const {
  if (controller().hasSession()) return tr("The session that is open keeps the object that it was begun with.");
  if (!devices_->simulated()) return tr("Only the simulated scanner looks at a mesh, and another scanner is chosen.");
  return {};
}

void ChoosePage::takeObject(const QString& path) {
  select(*object_, path);
}

ImportChoice ChoosePage::importChoice() const {
  ImportChoice import;
  import.scanner = scanner_->currentData().toString().toStdString();
  import.settings = form_->settings();
  import.folder = freeFolder(QStringLiteral("import")).toStdString();
  return import;
}

// The profile and the cut that a rig file names besides its devices.
void ChoosePage::takeRig(const RigFile& file) {
  if (!file.rig.scanner.empty()) select(*scanner_, QString::fromStdString(file.rig.scanner));
  if (devices_->simulated()) return;
  try {
    form_->setSettings(withCut(form_->settings(), file));
  } catch (const InvalidInput& e) {
    form_->complain(QString::fromUtf8(e.what()));
  }
}

void ChoosePage::fill(QComboBox& box, const QString& folder, const QString& pattern, const QString& preferred) {
  const QDir directory(resources_ + QLatin1Char('/') + folder);
  for (const QString& name : directory.entryList({pattern}, QDir::Files, QDir::Name))
    box.addItem(readable(name), directory.filePath(name));
  select(box, directory.filePath(preferred));
}

void ChoosePage::showWhatIsSimulated() {
  objectRow_->setVisible(devices_->simulated());
  form_->setSimulated(devices_->simulated());
}

// Real scanners see more than their object: what suits them is cut, until something else is said.
void ChoosePage::suggestCut() {
  if (form_ == nullptr || controller().hasSession() || cutIsForReal_ == !devices_->simulated()) return;
  cutIsForReal_ = !devices_->simulated();
  AcquisitionSettings settings = form_->settings();
  settings.cut = cutIsForReal_ ? cutForRealScanners() : CutOptions();
  form_->setSettings(settings);
}

// What was tried out on a test scan, and the calibration that was made, are what holds.
void ChoosePage::takeWhatWasTried() {
  if (controller().hasSession() || !controller().setUp()) return;
  if (devices_->rig() != controller().choice().rig) {
    const QSignalBlocker quiet(devices_);
    devices_->setRig(controller().choice().rig);
  }
  const CutOptions& cut = controller().choice().settings.cut;
  if (form_->settings().cut == cut) return;
  AcquisitionSettings settings = form_->settings();
  settings.cut = cut;
  form_->setSettings(settings);
}

// A folder that somebody chose stays.
void ChoosePage::suggestFolder() {
  if (folderIsChosen_) return;
  const QString name =
      devices_->simulated() ? QFileInfo(object_->currentData().toString()).completeBaseName() : QStringLiteral("scan");
  folder_->setText(QDir::toNativeSeparators(freeFolder(name)));
}

SetUpChoice ChoosePage::choice() const {
  SetUpChoice choice;
  choice.scanner = scanner_->currentData().toString().toStdString();
  choice.folder = folder_->text().toStdString();
  choice.rig = devices_->rig();
  choice.settings = form_->settings();
  if (devices_->simulated()) choice.settings.simulation.object = object_->currentData().toString().toStdString();
  return choice;
}

bool ChoosePage::complete() const {
  return whyNotNext().isEmpty();
}

QString ChoosePage::whyNotNext() const {
  if (controller().hasSession()) return {};
  if (const QString why = devices_->whyNot(); !why.isEmpty()) return why;
  if (scanner_->currentData().toString().isEmpty()) return tr("Choose the profile of the scanner first.");
  if (devices_->simulated() && object_->currentData().toString().isEmpty()) return tr("Choose an object first.");
  if (folder_->text().trimmed().isEmpty()) return tr("Choose a folder first.");
  return form_->consistent() ? QString() : tr("Options contradict each other.");
}

QString ChoosePage::whatNext() const {
  return controller().hasSession() ? tr("The set-up of this session is shown. Its scanner and object stay as they are.")
                                   : tr("Scanner and object are read and checked. Nothing is scanned yet.");
}

// What an open session was begun with cannot be changed any more.
void ChoosePage::entered() {
  const bool open = controller().hasSession();
  const SetUpChoice& chosen = controller().choice();
  if (open && chosen.settings.simulation.object.empty())
    object_->setCurrentIndex(-1);
  else if (open)
    select(*object_, QString::fromStdString(chosen.settings.simulation.object));
  if (open) devices_->setRig(chosen.rig);
  showWhatIsSimulated();
  if (open) folder_->setText(QString::fromStdString(chosen.folder));
  if (open) form_->setSettings(chosen.settings);
  showScanner();
  allowChoice();
  emit changed();
}

// A session keeps its scanner by itself: no file of the list need be the one.
void ChoosePage::showScanner() {
  const bool open = controller().hasSession();
  if (open == (scanner_->currentIndex() < 0)) return;
  if (open) {
    chosenScanner_ = scanner_->currentData().toString();
    const SharedSetUp& setUp = controller().setUp();
    const bool known = setUp && setUp->profile;
    scanner_->setPlaceholderText(known ? QString::fromStdString(setUp->profile->name)
                                       : tr("None: the scans were recorded elsewhere"));
    scanner_->setCurrentIndex(-1);
  } else {
    select(*scanner_, chosenScanner_);
  }
}

void ChoosePage::allowChoice() {
  const QString whyNot =
      controller().hasSession() ? tr("The session that is open keeps what it was begun with.") : QString();
  for (QWidget* editor :
       {static_cast<QWidget*>(scanner_), static_cast<QWidget*>(object_), static_cast<QWidget*>(folder_)})
    allow(*editor, whyNot);
  for (QWidget* editor : form_->editors()) allow(*editor, whyNot);
  for (QWidget* editor : devices_->editors()) allow(*editor, whyNot);
  for (auto* browse : findChildren<QToolButton*>(QStringLiteral("browse"))) allow(*browse, whyNot);
}

void ChoosePage::leaving() {
  if (!controller().hasSession()) controller().setChoice(choice());
}

}  // namespace vantage
