#include "wizard/review_page.h"

#include <QHeaderView>
#include <QTableWidget>
#include <QVBoxLayout>

#include "form_parts.h"
#include "report/edges_left.h"
#include "why_card.h"
#include "wording.h"

namespace vantage {
namespace {

constexpr int kScanRole = Qt::UserRole;
constexpr int kLeftOutRole = Qt::UserRole + 1;

}  // namespace

ReviewPage::ReviewPage(SessionController& controller, QWidget* parent)
    : WizardPage(controller, parent),
      reason_(makeLabel({}, "section")),
      figures_(new FigureTable),
      left_(new FigureTable),
      views_(new QTableWidget(0, 4)),
      toggle_(makeButton(tr("&Leave this view out"), QStringLiteral("leaveOut"),
                         tr("Make the model without this view, or take it back. The scan is kept."))) {
  column().addWidget(reason_);
  column().addWidget(figures_);
  addSection(tr("What is left, and why"));
  column().addWidget(left_);
  addSection(tr("Views"));
  views_->setHorizontalHeaderLabels({tr("View"), tr("Position"), tr("New mm²"), tr("Fit mm")});
  views_->verticalHeader()->hide();
  views_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  views_->setSelectionBehavior(QAbstractItemView::SelectRows);
  views_->setSelectionMode(QAbstractItemView::SingleSelection);
  views_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  views_->setAccessibleName(tr("Views"));
  views_->setMinimumHeight(150);
  column().addWidget(views_, 1);
  column().addWidget(toggle_);
  connect(toggle_, &QPushButton::clicked, this, &ReviewPage::toggle);
  connect(views_, &QTableWidget::itemSelectionChanged, this, [this] {
    const auto* item = views_->item(views_->currentRow(), 0);
    toggle_->setEnabled(item != nullptr && this->controller().idle());
    toggle_->setText(item != nullptr && item->data(kLeftOutRole).toBool() ? tr("&Take this view back")
                                                                          : tr("&Leave this view out"));
  });
  connect(&controller, &SessionController::stateChanged, this, &ReviewPage::refresh);
  connect(&controller, &SessionController::activityChanged, this, [this] { emit changed(); });
  refresh();
}

bool ReviewPage::complete() const {
  return controller().idle() && controller().now() && controller().now()->model;
}

void ReviewPage::entered() {
  refresh();
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
  figures_->clear();
  left_->clear();
  views_->setRowCount(0);
  toggle_->setEnabled(false);
  const SharedState& now = controller().now();
  if (!now || !now->model) {
    reason_->setText(tr("Nothing has been scanned yet."));
    return;
  }
  reason_->setText(terminationText(now->termination));
  double area = 0.0;
  for (const ViewRecord& record : now->records) area += record.newArea;
  figures_->add(tr("Views"), QString::number(now->views.size()));
  figures_->add(tr("Surface"), areaText(area));
  figures_->add(tr("Triangles"), QString::number(now->model->mesh.triangles.size()));
  refreshLeft(*now);
  refreshViews(*now);
  emit changed();
}

void ReviewPage::refreshLeft(const AcquisitionState& state) {
  const auto plan = currentPlan(state);
  if (!plan || !plan->voids) return;
  for (const EdgesLeft& left : edgesLeft(*plan))
    left_->add(edgeReasonText(left.reason, plan->outcome), tr("%1 mm of edge").arg(figureText(left.length)));
  if (plan->voids->patches.empty()) left_->add(tr("Nothing: the surface is closed."), {});
}

void ReviewPage::addView(const ViewRecord& record, bool leftOut) {
  const int row = views_->rowCount();
  views_->insertRow(row);
  const QString texts[] = {leftOut ? tr("left out") : QString::number(row + 1), QString::number(record.position),
                           figureText(record.newArea), figureText(record.registration.rms, 3)};
  for (int column = 0; column < 4; ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    views_->setItem(row, column, item);
  }
  views_->item(row, 0)->setData(kScanRole, static_cast<qlonglong>(record.scan));
  views_->item(row, 0)->setData(kLeftOutRole, leftOut);
}

void ReviewPage::refreshViews(const AcquisitionState& state) {
  for (const ViewRecord& record : state.records) addView(record, false);
  for (const LeftOutView& view : state.leftOut) addView(view.record, true);
}

}  // namespace vantage
