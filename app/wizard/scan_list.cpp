#include "wizard/scan_list.h"

#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMimeData>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "form_parts.h"

namespace vantage {
namespace {

const QStringList kRangePatterns{QStringLiteral("*.ply"), QStringLiteral("*.pcd"), QStringLiteral("*.ptx"),
                                 QStringLiteral("*.png"), QStringLiteral("*.xyz"), QStringLiteral("*.asc"),
                                 QStringLiteral("*.txt")};
// Below every position: not known.
constexpr int kUnknown = -1;

QStringList localFiles(const QMimeData& data) {
  QStringList paths;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  return paths;
}

}  // namespace

QStringList rangeFilesIn(const QStringList& paths) {
  QStringList files;
  for (const QString& path : paths) {
    if (!QFileInfo(path).isDir()) {
      files << path;
      continue;
    }
    const QDir folder(path);
    for (const QString& name : folder.entryList(kRangePatterns, QDir::Files, QDir::Name))
      files << folder.filePath(name);
  }
  return files;
}

ScanList::ScanList(QWidget* parent) : QWidget(parent), table_(new QTableWidget(0, 2)) {
  setAcceptDrops(true);
  table_->setObjectName(QStringLiteral("scanFiles"));
  table_->setAccessibleName(tr("Range files"));
  table_->setHorizontalHeaderLabels({tr("Range file"), tr("Taken from position")});
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  table_->verticalHeader()->hide();
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTextElideMode(Qt::ElideLeft);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(table_, 1);
  auto* row = new QHBoxLayout;
  const auto addButton = [&](const QString& text, const QString& name, const QString& help, auto run) {
    auto* button = makeButton(text, name, help);
    connect(button, &QPushButton::clicked, this, run);
    row->addWidget(button);
  };
  addButton(tr("Add fil&es…"), QStringLiteral("addFiles"), tr("Add range files; they can also be dropped here."),
            [this] {
              addFiles(QFileDialog::getOpenFileNames(
                  this, tr("Range files"), {},
                  tr("Range files (%1);;All files (*)").arg(kRangePatterns.join(QLatin1Char(' ')))));
            });
  addButton(tr("Add &folder…"), QStringLiteral("addFolder"), tr("Add all range files of a folder, by name."), [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of range files"));
    if (!folder.isEmpty()) addFiles({folder});
  });
  addButton(tr("Re&move"), QStringLiteral("removeFiles"), tr("Take the chosen files off the list."),
            [this] { removeChosen(); });
  addButton(tr("&Up"), QStringLiteral("moveUp"), tr("Use the chosen file earlier."), [this] { moveChosen(-1); });
  addButton(tr("&Down"), QStringLiteral("moveDown"), tr("Use the chosen file later."), [this] { moveChosen(1); });
  row->addStretch();
  column->addLayout(row);
}

void ScanList::setPositions(int count) {
  positionCount_ = count;
  table_->setColumnHidden(1, count == 0);
  for (int i = 0; i < table_->rowCount(); ++i)
    if (auto* box = qobject_cast<QSpinBox*>(table_->cellWidget(i, 1))) box->setMaximum(std::max(kUnknown, count - 1));
}

void ScanList::addFiles(const QStringList& paths, std::optional<int> position) {
  const std::vector<std::string> before = files();
  for (const QString& path : rangeFilesIn(paths)) {
    if (std::find(before.begin(), before.end(), path.toStdString()) != before.end()) continue;
    addFile(path, position);
    position.reset();
  }
  emit edited();
}

void ScanList::addFile(const QString& path, std::optional<int> position) {
  const int row = table_->rowCount();
  table_->insertRow(row);
  auto* item = new QTableWidgetItem(path);
  item->setToolTip(path);
  table_->setItem(row, 0, item);
  auto* box = new QSpinBox;
  box->setAccessibleName(tr("Position of %1").arg(QFileInfo(path).fileName()));
  box->setRange(kUnknown, std::max(kUnknown, positionCount_ - 1));
  box->setSpecialValueText(tr("not known"));
  box->setValue(position.value_or(kUnknown));
  connect(box, &QSpinBox::valueChanged, this, &ScanList::edited);
  table_->setCellWidget(row, 1, box);
}

void ScanList::removeChosen() {
  QList<int> rows;
  for (const QModelIndex& index : table_->selectionModel()->selectedRows()) rows << index.row();
  std::sort(rows.begin(), rows.end(), std::greater<>());
  for (const int row : rows) table_->removeRow(row);
  emit edited();
}

void ScanList::moveChosen(int by) {
  const int row = table_->currentRow();
  const int other = row + by;
  if (row < 0 || other < 0 || other >= table_->rowCount()) return;
  const auto exchange = [&](auto get, auto set) {
    const auto here = get(row);
    set(row, get(other));
    set(other, here);
  };
  exchange([&](int r) { return table_->item(r, 0)->text(); },
           [&](int r, const QString& text) {
             table_->item(r, 0)->setText(text);
             table_->item(r, 0)->setToolTip(text);
           });
  exchange([&](int r) { return qobject_cast<QSpinBox*>(table_->cellWidget(r, 1))->value(); },
           [&](int r, int value) { qobject_cast<QSpinBox*>(table_->cellWidget(r, 1))->setValue(value); });
  table_->setCurrentCell(other, 0);
  emit edited();
}

std::vector<std::string> ScanList::files() const {
  std::vector<std::string> files;
  for (int i = 0; i < table_->rowCount(); ++i) files.push_back(table_->item(i, 0)->text().toStdString());
  return files;
}

std::vector<std::optional<int>> ScanList::positions() const {
  std::vector<std::optional<int>> positions;
  for (int i = 0; i < table_->rowCount(); ++i) {
    const int value = qobject_cast<QSpinBox*>(table_->cellWidget(i, 1))->value();
    positions.push_back(value > kUnknown && positionCount_ > 0 ? std::optional(value) : std::nullopt);
  }
  return positions;
}

void ScanList::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void ScanList::dropEvent(QDropEvent* event) {
  addFiles(localFiles(*event->mimeData()));
  event->acceptProposedAction();
}

}  // namespace vantage
