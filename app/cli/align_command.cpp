#include <memory>
#include <optional>

#include "acquisition/acquisition.h"
#include "acquisition/stand_composites.h"
#include "acquisition/stand_course.h"
#include "base/errors.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/session_run.h"
#include "cli/text.h"
#include "io/file_bytes.h"
#include "positional_space/scanner_images_cache.h"
#include "program/user_folders.h"
#include "report/stands_report.h"
#include "session/json_fields.h"
#include "session/stand_json.h"

namespace vantage {
namespace {

// Of a file of picked points.
constexpr std::uintmax_t kMostPickBytes = 1 << 20;

struct AlignArguments {
  std::string session;
  std::optional<int> stand;
  std::optional<int> choose;
  bool anyway = false;
  std::string picks;
};

AcquisitionTools toolsFor(const Session& session, CommandContext& context) {
  AcquisitionTools tools;
  if (const auto profile = session.profile())
    tools.images = std::make_shared<const ScannerImages>(loadScannerImages(
        *profile, cacheDirectory(), context.progress().part(0.0, 0.2, "positional space of the scanner")));
  return tools;
}

// The stand that was asked for, else the last one that is not known yet.
int standOf(const AlignArguments& args, const AcquisitionState& state) {
  if (args.stand) return *args.stand;
  const std::vector<int> open = standsToAlign(state);
  if (open.empty())
    throw InvalidInput(args.session + ": there is no stand to align: " +
                       (state.stand() == 0 ? "the object was not turned over yet" : "all are aligned"));
  return open.back();
}

PickedPairs readPicks(const std::string& path) {
  const nlohmann::json json = jsonObject(std::string(FileBytes(path, kMostPickBytes).text()), path);
  return picksFrom(JsonFields(json, path).list("pairs"), path);
}

std::string candidateText(const StandAlignment& alignment) {
  std::string text;
  for (std::size_t i = 0; i < alignment.candidates.size(); ++i) {
    const StandPose& pose = alignment.candidates[i];
    text += "  pose " + std::to_string(i) + ": overlap " + number(100.0 * pose.overlap, 1) + " %, " +
            number(pose.rms, 3) + " mm, contradicted " + number(100.0 * (pose.conflict + pose.table), 2) +
            " %, missing " + number(100.0 * pose.missing, 2) + " %, " +
            (alignment.used == static_cast<int>(i) ? "used"
             : pose.possible                       ? "possible"
                                                   : "not possible") +
            "\n";
  }
  return text;
}

void announce(const AcquisitionState& state, CommandContext& context) {
  const AcquisitionState object = withObject(state);
  std::string text;
  for (int stand = 0; stand <= state.stand(); ++stand) {
    if (stand == referenceOf(state.stands)) continue;
    text += standLine(state, stand) + "\n";
    if (const auto& alignment = state.stands[static_cast<std::size_t>(stand)].alignment)
      text += candidateText(*alignment);
  }
  std::vector<Warning> warnings;
  for (Warning& warning : warningsOf(object))
    if (warning.stand) warnings.push_back(std::move(warning));
  context.result({{"views", countScans(object, ScanStatus::In)}, {"stands", standsJson(state)}}, text, warnings);
}

void runAlign(const AlignArguments& args, CommandContext& context) {
  Session session = openSession(args.session, SessionAccess::Write, context);
  const int stand = standOf(args, *session.state());
  Acquisition acquisition(session, toolsFor(session, context));
  const Progress progress = context.progress().part(0.2, 1.0, "align");
  if (args.choose)
    acquisition.carryOut(ChooseStandPose{stand, *args.choose, args.anyway}, progress);
  else if (!args.picks.empty())
    acquisition.carryOut(AlignStand{stand, readPicks(args.picks)}, progress);
  else if (args.stand)
    acquisition.carryOut(AlignStand{stand}, progress);
  else
    static_cast<void>(alignStands(acquisition, true, progress));
  announce(*session.state(), context);
}

}  // namespace

void addAlignCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<AlignArguments>();
  CLI::App* command =
      app.add_subcommand("align", "Find how the stands of the object lie in each other, and put them together");
  command->add_option("session", args->session, "Session file")->required();
  command->add_option("--stand", args->stand, "This stand; all that are not aligned yet when not given");
  CLI::Option* choose = command->add_option("--choose", args->choose, "Use this pose of those that were found");
  command->add_flag("--anyway", args->anyway, "Also one that something speaks against")->needs(choose);
  command
      ->add_option("--picks", args->picks,
                   "Begin with points that lie in the same places (JSON): three pairs or more of on_object, on_stand")
      ->excludes(choose);
  context.addCommonOptions(*command);
  command->callback([args, &context] { runAlign(*args, context); });
}

}  // namespace vantage
