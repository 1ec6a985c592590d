#include <memory>
#include <optional>

#include "acquisition/acquisition.h"
#include "acquisition/stand_advice.h"
#include "base/errors.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/text.h"

namespace vantage {
namespace {

struct StandArguments {
  std::string session;
  std::optional<int> face;
};

std::string sideText(const Vec3& down) {
  return "(" + number(down.x(), 2) + ", " + number(down.y(), 2) + ", " + number(down.z(), 2) + ")";
}

nlohmann::ordered_json adviceJson(const StandAdvice& advice, std::size_t face) {
  return {{"face", face},
          {"down", {advice.down.x(), advice.down.y(), advice.down.z()}},
          {"gain_mm2", advice.gain},
          {"share_of_void", advice.share},
          {"falls_over_at_deg", degrees(advice.margin)},
          {"new", advice.isNew}};
}

std::vector<StandAdvice> adviceFor(const AcquisitionState& state, const std::string& session, CommandContext& context) {
  if (!state.profile)
    throw InvalidInput(session + ": has no scanner profile, so nothing can be scanned in a new stand");
  std::vector<StandAdvice> advice = adviseStands(state, context.progress());
  if (advice.empty())
    throw InvalidInput(session + ": has no model yet that could rest on a side, expected views that span a volume");
  return advice;
}

void list(const StandArguments& args, CommandContext& context) {
  const auto state = readSession(args.session, context);
  const std::vector<StandAdvice> advice = adviceFor(*state, args.session, context);
  nlohmann::ordered_json json{{"stand", state->stand()}, {"faces", nlohmann::ordered_json::array()}};
  std::string text = "sides to put the object on next, by what that would show:\n";
  for (std::size_t i = 0; i < advice.size(); ++i) {
    json["faces"].push_back(adviceJson(advice[i], i));
    text += std::to_string(i) + ": down " + sideText(advice[i].down) + ", shows " + number(advice[i].gain, 0) +
            " mm2 of void (" + number(100.0 * advice[i].share, 0) + " %), falls over at " +
            number(degrees(advice[i].margin), 0) + " degrees" + (advice[i].isNew ? "" : "; it stood so before") + "\n";
  }
  context.result(json, text + "begin a stand: vantage-cli stand " + args.session + " --face K\n");
}

void begin(const StandArguments& args, CommandContext& context) {
  Session session = openSession(args.session, SessionAccess::Write, context);
  const std::vector<StandAdvice> advice = adviceFor(*session.state(), args.session, context);
  if (*args.face < 0 || *args.face >= static_cast<int>(advice.size()))
    throw InvalidInput("--face is " + std::to_string(*args.face) + ", the object has sides 0 to " +
                       std::to_string(advice.size() - 1));
  const StandAdvice& side = advice[static_cast<std::size_t>(*args.face)];
  Acquisition(session).carryOut(TurnObject{{}, side.down});
  const int stand = session.state()->stand();
  auto json = adviceJson(side, static_cast<std::size_t>(*args.face));
  json["stand"] = stand;
  context.result(json, "stand " + std::to_string(stand) + " begins: put the object down on its side " +
                           sideText(side.down) + ", then scan: vantage-cli resume " + args.session +
                           "\nit is aligned with the others by vantage-cli align " + args.session + "\n");
}

}  // namespace

void addStandCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<StandArguments>();
  CLI::App* command = app.add_subcommand("stand", "Say on which side to put the object next, or begin a stand on one");
  command->add_option("session", args->session, "Session file")->required();
  command->add_option("--face", args->face, "Begin the next stand on this side of the list");
  context.addCommonOptions(*command);
  command->callback([args, &context] { args->face ? begin(*args, context) : list(*args, context); });
}

}  // namespace vantage
