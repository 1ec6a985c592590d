#include <memory>
#include <optional>

#include "acquisition/steps.h"
#include "base/errors.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/text.h"
#include "planning/choice.h"
#include "positional_space/scanner_images_cache.h"
#include "program/user_folders.h"
#include "report/report.h"
#include "report/wording.h"

namespace vantage {
namespace {

struct PlanArguments {
  std::string session;
  bool why = false;
  std::optional<int> position;
};

std::string scoreText(const PositionScore& s) {
  std::string text = "position " + std::to_string(s.position) + (s.uncorrected ? ": new surface " : ": void ") +
                     number(promise(s), 1) + " mm2, overlap " + number(s.overlapArea, 0) + " mm2, " +
                     std::string(name(s.constraint));
  if (s.constraint == Constraint::BelowThreshold || s.constraint == Constraint::OverlapShort)
    text += ", short by " + number(s.shortBy, 1) + " mm2";
  if (s.constraint == Constraint::PoseUncertain) text += ", short by " + number(s.shortBy, 2) + " mm";
  if (s.poseSigma) text += "; worst " + describe(s.weakMotions) + ", " + number(*s.poseSigma, 3) + " mm";
  return text + "\n";
}

nlohmann::ordered_json planJson(const Plan& plan, const PlanArguments& args) {
  nlohmann::ordered_json json{
      {"outcome", name(plan.outcome)},          {"position", plan.position.value_or(-1)},
      {"least_overlap_mm2", plan.leastOverlap}, {"relaxations", plan.relaxations},
      {"table_alone", plan.tableAlone},         {"termination_threshold_mm2", plan.terminationThreshold},
      {"void_left_mm2", plan.voidLeft},         {"angular_error_deg", degrees(plan.angularError)},
      {"void_patches", voidJson(plan)}};
  if (plan.forecast) json["forecast"] = forecastJson(*plan.forecast);
  if (args.why) {
    json["scores"] = nlohmann::ordered_json::array();
    for (const PositionScore& s : plan.scores) json["scores"].push_back(scoreJson(s));
    json["remaining"] = remainingJson(plan);
  }
  if (args.position) json["asked"] = scoreJson(plan.scores[static_cast<std::size_t>(*args.position)]);
  return json;
}

std::string planText(const Plan& plan, const PlanArguments& args) {
  std::string text = plan.outcome == PlanOutcome::Found
                         ? "next best view: position " + std::to_string(plan.position.value()) + "\n"
                         : std::string(name(plan.outcome)) + "\n";
  text += "t = " + number(plan.leastOverlap, 1) + " mm2, F = " + number(plan.terminationThreshold, 1) + " mm2\n";
  if (plan.tableAlone) text += "nothing overlaps the model enough: the table alone will place the view\n";
  if (plan.forecast && plan.forecast->left)
    text += "surface that positions would still show, as forecast: " + number(plan.forecast->left->area, 1) + " mm2 (" +
            number(plan.forecast->left->least, 1) + " to " + number(plan.forecast->left->most, 1) + ")\n";
  else if (plan.voidLeft > 0.0)
    text += "views that are still possible would show " + number(plan.voidLeft, 1) + " mm2 in all\n";
  if (args.why)
    for (const PositionScore& s : plan.scores) text += scoreText(s);
  if (args.position) text += scoreText(plan.scores[static_cast<std::size_t>(*args.position)]);
  return text;
}

void runPlan(const PlanArguments& args, CommandContext& context) {
  const auto state = readSession(args.session, context);
  const auto& profile = state->profile;
  if (!profile)
    throw InvalidInput(args.session +
                       ": holds recorded scans without a workspace, a next view needs a scanner profile");
  if (!state->model) throw InvalidInput(args.session + ": has no view yet to plan from");
  if (args.position && (*args.position < 0 || *args.position >= static_cast<int>(profile->workspace.size())))
    throw InvalidInput("--position is " + std::to_string(*args.position) + ", the workspace has positions 0 to " +
                       std::to_string(profile->workspace.size() - 1));
  const ScannerImages images = loadScannerImages(*profile, cacheDirectory(),
                                                 context.progress().part(0.2, 0.3, "positional space of the scanner"));
  // The plan that the session holds, else the one that the state gives.
  std::shared_ptr<const Plan> plan = state->plan;
  if (!plan)
    plan = std::make_shared<const Plan>(
        planAfter(*state, images, stepOptionsFor(*state), context.progress().part(0.3, 1.0)));
  context.result(planJson(*plan, args), planText(*plan, args));
}

}  // namespace

void addPlanCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<PlanArguments>();
  CLI::App* command = app.add_subcommand("plan", "Find the next best view of a session and say why");
  command->add_option("session", args->session, "Session file")->required();
  command->add_flag("--why", args->why, "Give the score of every position and what bound it");
  command->add_option("--position", args->position, "Explain this position");
  context.addCommonOptions(*command);
  command->callback([args, &context] { runPlan(*args, context); });
}

}  // namespace vantage
