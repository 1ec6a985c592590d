#include "wizard/turn_over_page.h"

#include <QShowEvent>
#include <QVBoxLayout>

#include "form_parts.h"
#include "help/help_topic.h"
#include "stand_desk.h"
#include "views/stand_view.h"
#include "why_card.h"
#include "wizard/stand_sides.h"

namespace vantage {
namespace {

// What tilts by less falls over from a breath.
constexpr double kFallsEasily = radians(8.0);

QString shareText(double share) {
  return TurnOverPage::tr("%1 %").arg(figureText(100.0 * share));
}

}  // namespace

TurnOverPage::TurnOverPage(SessionController& controller, StandDesk& desk, const SurfaceMaker& surfaces,
                           QWidget* parent)
    : WizardPage(controller, parent),
      desk_(desk),
      summary_(makeLabel({})),
      again_(makeButton(tr("&Look again"), QStringLiteral("lookAgain"), tr("Look for sides to put the object on."))),
      view_(new StandView(surfaces)),
      sidesTitle_(makeLabel(tr("Sides that it can rest on"), "section")),
      sides_(new StandSides),
      figures_(new FigureTable),
      mind_(makeLabel({}, "muted")),
      turned_(makeButton(tr("It s&tands on this side now: scan on"), QStringLiteral("turned"),
                         tr("Begin a new stand. What was scanned before is kept aside until it is known how the object "
                            "was turned over."),
                         true)) {
  setHelpTopic(*this, QStringLiteral("turn_over"));
  build();
  connect(sides_, &StandSides::sideChosen, this, &TurnOverPage::showSide);
  connect(again_, &QPushButton::clicked, &desk, &StandDesk::look);
  connect(turned_, &QPushButton::clicked, this, [this] {
    if (const auto chosen = side()) desk_.turnOnto(chosen->down);
  });
  connect(&desk, &StandDesk::prospectChanged, this, &TurnOverPage::showProspect);
  connect(&desk, &StandDesk::turned, this, [this] { emit wanted(QStringLiteral("acquire")); });
  connect(&controller, &SessionController::stateChanged, this, &TurnOverPage::look);
  connect(&controller, &SessionController::activityChanged, this, &TurnOverPage::look);
  showProspect();
}

void TurnOverPage::build() {
  summary_->setObjectName(QStringLiteral("turnSummary"));
  view_->setMinimumHeight(150);
  view_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  column().addWidget(summary_);
  column().addWidget(again_);
  column().addWidget(view_, 1);
  column().addWidget(turned_);
  column().addWidget(sidesTitle_);
  column().addWidget(sides_);
  column().addWidget(figures_);
  column().addWidget(mind_);
}

void TurnOverPage::entered() {
  controller().prepare();
  look();
}

// Looked at only while somebody is here. What was stopped waits for the operator.
void TurnOverPage::look() {
  if (isVisible() && desk_.failure().isEmpty()) desk_.look();
  refresh();
}

void TurnOverPage::showEvent(QShowEvent* event) {
  WizardPage::showEvent(event);
  look();
  takePictures();
}

bool TurnOverPage::complete() const {
  return controller().idle() && controller().now() && controller().now()->model;
}

QString TurnOverPage::whatNext() const {
  return tr("Scan on, or go to the review without. How it was turned over is found out by itself.");
}

std::optional<StandAdvice> TurnOverPage::side() const {
  const auto& prospect = desk_.prospect();
  if (!prospect || sides_->chosen() < 0 || sides_->chosen() >= static_cast<int>(prospect->outlook.sides.size()))
    return std::nullopt;
  return prospect->outlook.sides[static_cast<std::size_t>(sides_->chosen())];
}

QString TurnOverPage::summary() const {
  const auto& prospect = desk_.prospect();
  if (desk_.looking()) return tr("Looking for the side that would show most.");
  if (!desk_.failure().isEmpty()) return desk_.failure();
  if (!prospect)
    return controller().now() ? tr("Nothing is known of its sides yet.") : tr("Nothing has been scanned yet.");
  const StandOutlook& outlook = prospect->outlook;
  if (!prospect->geometry) return tr("There is no model of the object: nothing can be said of its sides.");
  if (outlook.sides.empty())
    return tr("What is known of the object spans no volume, so it is not known what it can rest on. Scan more first.");
  if (outlook.left <= 0.0) return tr("Nothing is left that another stand could show: the surface is closed.");
  if (!prospect->worthAnother())
    return tr("Nothing more is to be gained: no other side would show more than %1, which a stand has to be worth. %2 "
              "of what is still unseen no side shows at all: it lies in hollows or too steep from everywhere.")
        .arg(areaText(prospect->leastGain), areaText(outlook.hidden));
  const StandAdvice& best = outlook.sides.front();
  return tr("On another side the scanner would see up to %1 of what is still unseen, %2 of what is left.")
      .arg(areaText(best.gain), shareText(best.share));
}

QString TurnOverPage::toMind() const {
  QStringList lines;
  const auto& setUp = controller().setUp();
  const bool simulated = setUp && setUp->devices && std::holds_alternative<Simulated>(*setUp->devices);
  if (simulated) {
    lines << tr(
        "The simulated object is turned over by itself: it comes to rest on the side nearest to this one, "
        "turned at random and a little beside the axis.");
  } else {
    lines << tr("Put it on that side anywhere near the axis, turned in any way: how it stands is found out.");
    lines << tr("If it would not rest like this, take the picture that is nearest to how it does.");
    const CutOptions& cut = controller().now() ? controller().now()->settings.cut : controller().choice().settings.cut;
    lines << (cut.volume ? tr("What holds it is scanned with it, save what lies at the height of the table, which is "
                              "cut out: hold it with as little as will do.")
                         : tr("What holds it is scanned with it, and so is the table: nothing is cut out of these "
                              "scans."));
  }
  return lines.join(QLatin1Char('\n'));
}

void TurnOverPage::showProspect() {
  const auto& prospect = desk_.prospect();
  view_->setModel(prospect ? prospect->geometry : nullptr, prospect ? prospect->profile.get() : nullptr);
  sides_->setSides(prospect ? prospect->outlook.sides : std::vector<StandAdvice>());
  showSide(sides_->chosen());
  takePictures();
}

void TurnOverPage::showSide(int /*side*/) {
  if (const auto chosen = side()) view_->showStand(chosen->T_object_table);
  refresh();
}

// Only of what can be seen: a view that is not shown has no size yet.
void TurnOverPage::takePictures() {
  const auto& prospect = desk_.prospect();
  if (!isVisible() || !prospect || prospect == pictured_ || !prospect->geometry) return;
  pictured_ = prospect;
  std::vector<Pose> stands;
  for (const StandAdvice& advice : prospect->outlook.sides) stands.push_back(advice.T_object_table);
  view_->takeStands(std::move(stands), [this](const std::vector<QImage>& pictures) { sides_->setPictures(pictures); });
}

void TurnOverPage::setTheme(const Theme& theme) {
  view_->setTheme(theme);
  pictured_.reset();
  takePictures();
}

void TurnOverPage::refresh() {
  const auto chosen = side();
  summary_->setText(summary());
  again_->setVisible(!desk_.failure().isEmpty() && !desk_.looking());
  allow(*again_, controller().idle() ? QString() : tr("Something else is under way."));
  for (QWidget* part : {static_cast<QWidget*>(view_), static_cast<QWidget*>(sidesTitle_), static_cast<QWidget*>(sides_),
                        static_cast<QWidget*>(figures_), static_cast<QWidget*>(mind_)})
    part->setVisible(chosen.has_value());
  mind_->setText(toMind());
  allow(*turned_, chosen ? desk_.whyNotTurn() : tr("There is no side to put it on yet."));
  figures_->clear();
  if (chosen) {
    figures_->add(tr("It would show"), areaText(chosen->gain), tr("%1 of what is left").arg(shareText(chosen->share)));
    figures_->add(tr("It falls over beyond a tilt of"), angleText(chosen->margin),
                  chosen->margin < kFallsEasily ? tr("easily: hold it, or take another side") : QString());
    if (!chosen->isNew) figures_->add(tr("It stood like this"), tr("already"));
  }
  emit changed();
}

}  // namespace vantage
