#include "wizard/review_page.h"

#include <QHeaderView>
#include <QTableWidget>
#include <QVBoxLayout>

#include "acquisition/stand_composites.h"
#include "completeness_text.h"
#include "ending_text.h"
#include "form_parts.h"
#include "geometry/measures.h"
#include "help/help_topic.h"
#include "report/areas_known.h"
#include "report/edges_left.h"
#include "report/reading_words.h"
#include "report/wording.h"
#include "stand_text.h"
#include "why_card.h"
#include "wizard/completeness_box.h"
#include "wizard/object_figures.h"
#include "wizard/other_turn_box.h"
#include "wording.h"

namespace vantage {
namespace {

constexpr int kScanRole = Qt::UserRole;
constexpr int kLeftOutRole = Qt::UserRole + 1;

QString statusText(const KeptScan& scan) {
  switch (scan.status) {
    case ScanStatus::Rejected:
      return ReviewPage::tr("did not fit");
    case ScanStatus::LeftOut:
      return ReviewPage::tr("left out");
    case ScanStatus::Waiting:
      return ReviewPage::tr("waits");
    case ScanStatus::Aside:
      return ReviewPage::tr("stand %1").arg(scan.station().stand);
    case ScanStatus::In:
      break;
  }
  return scan.record.registration.verdict == Verdict::Good ? ReviewPage::tr("good") : ReviewPage::tr("doubtful");
}

// As what recorded scans were read: of the first one, the tips of the list have all.
QString readingText(const AcquisitionState& state) {
  if (state.scans.empty() || !state.scans.front().record.reading) return {};
  return QStringLiteral("\n") +
         ReviewPage::tr("Read as: %1.").arg(translated(phraseOf(*state.scans.front().record.reading)));
}

}  // namespace

ReviewPage::ReviewPage(SessionController& controller, QWidget* parent)
    : WizardPage(controller, parent),
      reason_(makeLabel({}, "section")),
      stands_(makeLabel({})),
      completeness_(new CompletenessBox),
      figures_(new FigureTable),
      left_(new FigureTable),
      views_(new QTableWidget(0, 5)),
      toggle_(makeButton(tr("&Leave this view out"), QStringLiteral("leaveOut"),
                         tr("Make the model without this view, or take it back. The scan is kept."))),
      turnOver_(makeButton(tr("T&urn the object over…"), QStringLiteral("turnOver"),
                           tr("Put the object on another side, to scan what this stand hides."))) {
  setHelpTopic(*this, QStringLiteral("review"));
  column().addWidget(reason_);
  column().addWidget(stands_);
  stands_->setObjectName(QStringLiteral("stands"));
  column().addWidget(new OtherTurnBox(controller));
  column().addWidget(completeness_);
  column().addWidget(figures_);
  addSection(tr("What is left, and why"));
  column().addWidget(left_);
  addSection(tr("Views"));
  views_->setHorizontalHeaderLabels({tr("Scan"), tr("Pos."), tr("New mm²"), tr("Fit mm"), tr("Verdict")});
  views_->verticalHeader()->hide();
  views_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  views_->horizontalHeader()->setSectionResizeMode(views_->columnCount() - 1, QHeaderView::Stretch);
  views_->setSelectionBehavior(QAbstractItemView::SelectRows);
  views_->setSelectionMode(QAbstractItemView::SingleSelection);
  views_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  views_->setAccessibleName(tr("Views"));
  views_->setMinimumHeight(150);
  column().addWidget(views_, 1);
  column().addWidget(toggle_);
  column().addWidget(turnOver_);
  addErase();
  connect(turnOver_, &QPushButton::clicked, this, [this] { emit wanted(QStringLiteral("turn_over")); });
  connect(toggle_, &QPushButton::clicked, this, &ReviewPage::toggle);
  connect(views_, &QTableWidget::itemSelectionChanged, this, &ReviewPage::choose);
  connect(&controller, &SessionController::stateChanged, this, &ReviewPage::refresh);
  connect(&controller, &SessionController::activityChanged, this, [this] {
    refreshTurnOver();
    emit changed();
  });
  refresh();
}

bool ReviewPage::complete() const {
  return controller().idle() && hasAnyModel(controller().now());
}

void ReviewPage::entered() {
  refresh();
}

void ReviewPage::choose() {
  const auto* item = views_->selectedItems().isEmpty() ? nullptr : views_->item(views_->currentRow(), 0);
  const bool leftOut = item != nullptr && item->data(kLeftOutRole).toBool();
  const auto scan = item == nullptr ? 0 : static_cast<std::int64_t>(item->data(kScanRole).toLongLong());
  const QString whyNot = item == nullptr ? tr("Choose a scan in the list first.")
                         : leftOut       ? controller().permissions().whyNot(TakeBackView{scan})
                                         : controller().permissions().whyNot(LeaveOutView{scan});
  allow(*toggle_, whyNot);
  toggle_->setText(leftOut ? tr("&Take this view back") : tr("&Leave this view out"));
  toggle_->setAccessibleName(QString(toggle_->text()).remove(QLatin1Char('&')));
  emit scanChosen(item != nullptr ? std::optional(scan) : std::nullopt);
}

void ReviewPage::select(std::int64_t scan) {
  for (int row = 0; row < views_->rowCount(); ++row)
    if (views_->item(row, 0)->data(kScanRole).toLongLong() == scan) views_->selectRow(row);
}

void ReviewPage::toggle() {
  const auto* item = views_->item(views_->currentRow(), 0);
  if (item == nullptr) return;
  const auto scan = static_cast<std::int64_t>(item->data(kScanRole).toLongLong());
  if (item->data(kLeftOutRole).toBool())
    controller().takeBack(scan);
  else
    controller().leaveOut(scan);
}

void ReviewPage::refresh() {
  // The scan that was chosen stays so.
  const QTableWidgetItem* chosen = views_->selectedItems().isEmpty() ? nullptr : views_->item(views_->currentRow(), 0);
  const bool isChosen = chosen != nullptr;
  const std::int64_t scan = isChosen ? chosen->data(kScanRole).toLongLong() : 0;
  figures_->clear();
  left_->clear();
  {
    const QSignalBlocker quiet(views_);
    views_->setRowCount(0);
  }
  allow(*toggle_, tr("Choose a scan in the list first."));
  refreshTurnOver();
  const SharedState& now = controller().now();
  stands_->setText(now ? standsText(*now) : QString());
  stands_->setVisible(!stands_->text().isEmpty());
  const auto& completeness = controller().present().completeness();
  completeness_->setVisible(completeness.has_value());
  if (completeness) completeness_->show(makeCompletenessCard(withObject(*now), *completeness));
  if (!hasAnyModel(now)) {
    reason_->setText(tr("Nothing has been scanned yet."));
    return;
  }
  const QString own = ownModelText(*now);
  reason_->setText(endingText(*now) + readingText(*now));
  figures_->add(own.isEmpty() ? tr("Views") : tr("Views in this stand"),
                QString::number(countScans(*now, ScanStatus::In)), own);
  if (now->model) {
    figures_->add(tr("Surface"), areaText(area(now->model->mesh)));
    figures_->add(tr("Triangles"), countText(now->model->mesh.triangles.size()));
  }
  if (!own.isEmpty()) addObject(*figures_, *now);
  refreshLeft(*now);
  refreshViews(*now);
  if (isChosen) select(scan);
  emit changed();
}

void ReviewPage::refreshTurnOver() {
  QString why = controller().permissions().whyNot(TurnObject{});
  if (why.isEmpty()) why = controller().permissions().whyNoDevices();
  allow(*turnOver_, why);
}

void ReviewPage::refreshLeft(const AcquisitionState& state) {
  const auto& plan = state.plan;
  if (!plan && state.termination == Termination::Imported)
    left_->add(tr("Not known: nothing is planned from recorded scans."), {});
  if (!plan || !plan->voids) return;
  if (!ownModelText(state).isEmpty()) left_->add(tr("Of this stand alone:"), {});
  for (const EdgesLeft& left : edgesLeft(*plan)) {
    QLabel* name = left_->add(QStringLiteral("%1 <a href=\"edges\">%2</a>")
                                  .arg(edgeReasonText(left.reason, plan->outcome).toHtmlEscaped(), tr("Show")),
                              tr("%1 mm of edge").arg(figureText(left.length)));
    name->setTextFormat(Qt::RichText);
    name->setTextInteractionFlags(Qt::TextBrowserInteraction);
    name->setFocusPolicy(Qt::StrongFocus);
    connect(name, &QLabel::linkActivated, this, [this, reason = left.reason] { emit edgesWanted(reason); });
  }
  if (plan->voids->patches.empty()) left_->add(tr("Nothing: the surface is closed."), {});
}

// Every scan keeps its number; what is no view says what it is.
void ReviewPage::addScan(const KeptScan& scan) {
  const int row = views_->rowCount();
  views_->insertRow(row);
  const bool leftOut = scan.status == ScanStatus::LeftOut;
  const bool in = scan.status == ScanStatus::In;
  const std::optional<int> position = scan.station().position;
  const RegistrationResult& registration = scan.record.registration;
  const QString texts[] = {QString::number(scan.number), position ? QString::number(*position) : tr("none"),
                           in && areasKnown(scan.record) ? figureText(scan.record.newArea) : QString(),
                           in || leftOut ? figureText(registration.rms, 3) : QString(), statusText(scan)};
  QString tip = scan.station().stand > 0 ? tr("Stand %1: ").arg(scan.station().stand) : QString();
  tip += translated(phraseOf(registration.finding));
  if (scan.record.reading) tip += QStringLiteral("\n") + translated(phraseOf(*scan.record.reading));
  for (int column = 0; column < 5; ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    item->setTextAlignment((column < 4 ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    item->setToolTip(tip);
    views_->setItem(row, column, item);
  }
  views_->item(row, 0)->setData(kScanRole, static_cast<qlonglong>(scan.number));
  views_->item(row, 0)->setData(kLeftOutRole, leftOut);
}

void ReviewPage::refreshViews(const AcquisitionState& state) {
  for (const KeptScan& scan : state.scans) addScan(scan);
}

}  // namespace vantage
