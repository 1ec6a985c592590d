#include "session/earlier_endings.h"

#include <cstdint>
#include <map>
#include <string>

#include "base/errors.h"
#include "session/command_json.h"
#include "session/session_json.h"

namespace vantage {
namespace {

// A step after which the acquisition was called finished.
struct FinishedStep {
  std::int64_t parent = 0;
  std::string kind;
  bool chosen = false;       // a position, by the operator
  std::string settings;      // JSON
  std::string outcome;       // of the plan that held; empty without one that can be read
  std::int64_t scanned = 0;  // scans that are views, or were rejected
  bool positions = false;    // whether any scan is of a position
};

std::map<std::int64_t, FinishedStep> finishedSteps(Database& database) {
  std::map<std::int64_t, FinishedStep> steps;
  Statement rows = database.prepare(
      "SELECT s.id, s.parent, s.kind, s.chosen NOT NULL, s.settings, ifnull((SELECT CASE WHEN json_valid(p.summary) "
      "THEN json_extract(p.summary, '$.outcome') END FROM plan p WHERE p.step = s.plan), ''), (SELECT count(*) FROM "
      "view v WHERE v.step = s.id AND v.status IN ('in', 'rejected')), EXISTS (SELECT 1 FROM view v JOIN scan c ON "
      "c.id = v.scan WHERE v.step = s.id AND c.position NOT NULL) FROM step s WHERE s.termination = 'finished'");
  while (rows.step())
    steps[rows.integer(0)] = {rows.integer(1), rows.text(2),    rows.integer(3) != 0, rows.text(4),
                              rows.text(5),    rows.integer(6), rows.integer(7) != 0};
  return steps;
}

// Whether the strategy had come to its end when somebody said that it had.
bool strategyHadEnded(const FinishedStep& step) {
  if (step.chosen) return false;
  try {
    const Strategy strategy = settingsFromText(step.settings, "settings").strategy;
    if (strategy.kind == Strategy::Kind::PositionalSpace) return step.outcome == name(PlanOutcome::Finished);
    return strategy.kind == Strategy::Kind::Uniform && step.scanned >= strategy.uniformViews;
  } catch (const InvalidInput&) {
    return true;  // Damaged: it stays what it was called.
  }
}

// Whether the end is the one of the step before: recorded scans stay an import as long as nothing is scanned or
// planned.
bool inherits(const FinishedStep& step, Termination before) {
  if (step.kind == "choose_position") return true;
  return before == Termination::Imported && step.kind != "finish" && step.kind != "add_scan" && step.outcome.empty();
}

Termination endOf(const FinishedStep& step, const std::map<std::int64_t, Termination>& ends) {
  const bool imported = step.kind == "import_scans" || (step.kind == "take_over" && !step.positions);
  if (imported) return Termination::Imported;
  if (step.kind == "finish" && !strategyHadEnded(step)) return Termination::EndedByOperator;
  const auto before = ends.find(step.parent);
  return before != ends.end() && inherits(step, before->second) ? before->second : Termination::Finished;
}

}  // namespace

void renameEarlierEndings(Database& database) {
  const std::map<std::int64_t, FinishedStep> steps = finishedSteps(database);
  std::map<std::int64_t, Termination> ends;  // parents come before their children
  for (const auto& [id, step] : steps) ends[id] = endOf(step, ends);

  Statement update = database.prepare("UPDATE step SET termination = ? WHERE id = ?");
  Statement command = database.prepare("UPDATE step SET command = ? WHERE id = ?");
  for (const auto& [id, end] : ends) {
    if (end == Termination::Finished) continue;
    update.bind(1, name(end)).bind(2, id).run();
    if (steps.at(id).kind == "finish") command.bind(1, std::string_view(commandText(Finish{end}))).bind(2, id).run();
  }
}

}  // namespace vantage
