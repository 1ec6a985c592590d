#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <vector>

#include "acquisition/acquisition.h"
#include "acquisition/erased_regions.h"
#include "acquisition/refusal_error.h"
#include "acquisition/stand_composites.h"
#include "base/errors.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/point_arguments.h"
#include "cli/text.h"
#include "positional_space/scanner_images_cache.h"
#include "program/user_folders.h"
#include "report/wording.h"
#include "session/region_json.h"

namespace vantage {
namespace {

struct EraseArguments {
  std::string session;
  std::string below;
  std::string box;
  std::string region;
  std::optional<double> loosePieces;
  std::optional<int> stand;
  std::optional<int> takeBack;
  bool preview = false;

  [[nodiscard]] bool erases() const { return !below.empty() || !box.empty() || !region.empty() || loosePieces; }
};

Region regionFromFile(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  if (!(text << file.rdbuf())) throw IoError(path, "cannot be read, expected a region as JSON");
  const nlohmann::json json = jsonObject(text.str(), path);
  return regionFrom(JsonFields(json, path));
}

// Coordinates are those of the table in the stand, as `export` writes them: with what was taken off the scans.
Region regionSaid(const EraseArguments& args, const Vec3& offset) {
  if (!args.below.empty()) {
    const SurfacePlane plane = planeOf(args.below);
    return BelowPlane{plane.offset * plane.normal - offset, plane.normal};
  }
  if (!args.region.empty()) return regionFromFile(args.region);
  const BoundingBox box = boxOf(args.box);
  OrientedBox region;
  region.T_region_box.translation() = box.centre() - offset;
  region.size = box.size();
  return region;
}

// What is to be erased; nothing where there are no loose pieces.
std::optional<ErasingRegion> erasingSaid(const EraseArguments& args, const AcquisitionState& state) {
  const int stand = args.stand.value_or(state.stand());
  // The plane of a table is one in its own stand only.
  const bool alone = args.stand || !args.below.empty();
  if (!args.loosePieces) return ErasingRegion{stand, regionSaid(args, worldOffset(outlineOf(state))), alone};
  auto pieces = loosePiecesRegion(state, *args.loosePieces);
  if (!pieces) return std::nullopt;
  return ErasingRegion{state.stand(), *std::move(pieces), false};
}

nlohmann::ordered_json erasureJson(const EraseRegion& command, const Erasure& erasure) {
  return {{"kind", kindOf(command.region)}, {"stand", command.stand},   {"only_this_stand", command.alone},
          {"samples", erasure.samples},     {"area_mm2", erasure.area}, {"pieces", erasure.pieces}};
}

std::string erasureText(const Erasure& erasure) {
  return counted(erasure.samples, "sample") + " of the model, " + number(erasure.area, 1) + " mm2 in " +
         counted(erasure.pieces, "piece");
}

Remark nothingThere(const std::string& text) {
  return {"nothing_erased", text, {}, true};
}

std::string nextText(const AcquisitionState& state) {
  const std::optional<int> next = nextPosition(state);
  if (next) return "next best view: position " + std::to_string(*next) + "\n";
  return "nothing is left to scan: " + std::string(name(state.termination)) + "\n";
}

AcquisitionTools planningTools(const Session& session, CommandContext& context) {
  AcquisitionTools tools;
  if (const auto profile = session.profile())
    tools.images = std::make_shared<const ScannerImages>(loadScannerImages(
        *profile, cacheDirectory(), context.progress().part(0.0, 0.2, "positional space of the scanner")));
  return tools;
}

void erase(const EraseArguments& args, CommandContext& context) {
  const auto access = args.preview ? SessionAccess::Read : SessionAccess::Write;
  Session session = openSession(args.session, access, context);
  const auto before = session.state();
  if (!before->model)
    throw InvalidInput(args.session + ": has no model of the stand of now yet, so nothing to erase from");
  const std::optional<ErasingRegion> said = erasingSaid(args, *before);
  if (!said)
    return context.result({{"kind", "near"}, {"samples", 0}, {"area_mm2", 0.0}, {"pieces", 0}}, "nothing is changed\n",
                          std::vector<Remark>{nothingThere("the model has no loose pieces of up to " +
                                                           number(*args.loosePieces, 1) + " mm2")});
  const EraseRegion command{said->stand, said->region, said->alone};
  if (const auto refusal = mayDo(*before, command)) throwRefusal(*refusal);
  const Erasure erasure = erasureOf(*before, *said, context.progress().part(0.0, 0.1));
  auto json = erasureJson(command, erasure);
  std::vector<Remark> remarks;
  if (erasure.samples == 0)
    remarks.push_back(nothingThere(args.preview ? "nothing of the model lies there"
                                                : "nothing of the model lies there; it holds for later scans"));
  if (args.preview) {
    json["preview"] = true;
    return context.result(json, "would erase " + erasureText(erasure) + "\n", remarks);
  }
  const int made = nextErasure(before->stands);
  Acquisition acquisition(session, planningTools(session, context));
  acquisition.carryOut(command, context.progress().part(0.2, 1.0));
  const auto after = session.state();
  json["erasure"] = made;
  json["next_position"] = nextPosition(*after).value_or(-1);
  json["state"] = name(after->termination);
  context.result(json,
                 "erasure " + std::to_string(made) + ": " + erasureText(erasure) + "\n" + nextText(*after) +
                     "take it back: vantage-cli erase " + args.session + " --take-back " + std::to_string(made) + "\n",
                 remarks);
}

void takeBack(const EraseArguments& args, CommandContext& context) {
  Session session = openSession(args.session, SessionAccess::Write, context);
  Acquisition acquisition(session, planningTools(session, context));
  const TakeBackErasure command{*args.takeBack};
  acquisition.carryOut(command, context.progress().part(0.2, 1.0));
  const auto after = session.state();
  context.result({{"taken_back", command.number},
                  {"next_position", nextPosition(*after).value_or(-1)},
                  {"state", name(after->termination)}},
                 english(phraseOf(Command(command))) + "\n" + nextText(*after));
}

void listErasures(const EraseArguments& args, CommandContext& context) {
  const auto state = readSession(args.session, context);
  nlohmann::ordered_json json{{"erasures", nlohmann::ordered_json::array()}};
  std::string text;
  for (std::size_t stand = 0; stand < state->stands.size(); ++stand)
    for (const ErasedRegion& erased : state->stands[stand].erased) {
      const std::string_view kind = kindOf(erased.region->region());
      json["erasures"].push_back({{"erasure", erased.number}, {"stand", stand}, {"kind", kind}});
      text += "erasure " + std::to_string(erased.number) + ": " + std::string(kind) + ", in stand " +
              std::to_string(stand) + "\n";
    }
  context.result(json, text.empty() ? "nothing is erased\n" : text);
}

}  // namespace

void addEraseCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<EraseArguments>();
  CLI::App* command = app.add_subcommand(
      "erase",
      "Erase what is not the object from the model (putty, a clamp, the table, loose pieces), take that back, "
      "or list what is erased");
  command->add_option("session", args->session, "Session file")->required();
  CLI::Option* below =
      command
          ->add_option("--below", args->below,
                       "What lies below a plane, on the other side than its normal points to [mm, table]")
          ->check(planeText());
  CLI::Option* box =
      command->add_option("--box", args->box, "What lies in a box, of which these are two opposite corners [mm, table]")
          ->check(boxText());
  CLI::Option* pieces = command
                            ->add_option("--loose-pieces", args->loosePieces,
                                         "Pieces that hang together with nothing else, up to this area each [mm2]; the "
                                         "largest one stays")
                            ->check(CLI::NonNegativeNumber);
  CLI::Option* region = command->add_option(
      "--region", args->region, "What lies in a region that a file describes, as JSON like in a session: a lasso");
  CLI::Option* back =
      command->add_option("--take-back", args->takeBack, "Take back the erasure of this number, and erase nothing");
  const std::vector<CLI::Option*> ways{below, box, pieces, region, back};
  command->add_option("--stand", args->stand,
                      "Only what was seen in this stand, whose table the coordinates are of; when not given, in all "
                      "stands that make the model, but with --below in the present one only");
  command->add_flag("--preview", args->preview, "Only say what would be erased");
  context.addCommonOptions(*command);
  command->callback([args, ways, &context] {
    if (std::count_if(ways.begin(), ways.end(), [](const CLI::Option* way) { return way->count() > 0; }) > 1)
      throw CLI::ValidationError("erase", "one of --below, --box, --loose-pieces, --region and --take-back at a time");
    if (args->takeBack) return takeBack(*args, context);
    args->erases() ? erase(*args, context) : listErasures(*args, context);
  });
}

}  // namespace vantage
