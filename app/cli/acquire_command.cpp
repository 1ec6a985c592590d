#include <filesystem>
#include <memory>
#include <optional>

#include "base/errors.h"
#include "cli/command.h"
#include "cli/device_run.h"
#include "cli/new_session.h"
#include "cli/reading_arguments.h"
#include "cli/rig_arguments.h"
#include "cli/session_run.h"
#include "cli/settings_arguments.h"
#include "cli/text.h"
#include "io/placement.h"
#include "scanner/profile_size.h"
#include "session/session_place.h"

namespace vantage {
namespace {

struct AcquireArguments {
  RigArguments rig;
  bool events = false;
  std::string out;
  std::string object;
  bool replace = false;
  std::optional<StandCourse> course;
  ReadingArguments reading;  ///< of files that come as scans; the unit also of the mesh
  SettingsArguments given;
  AcquisitionSettings settings;  ///< once the devices are known
};

// The object as the scanner will see it.
Mesh placeObject(const AcquireArguments& args, const ScannerProfile& profile, CommandContext& context) {
  const SimulationSettings& simulation = args.settings.simulation;
  const PlacementOptions placement{simulation.placement, simulation.unit};
  PlacedMesh object = loadPlacedMesh(simulation.object, placement, profile.viewingVolume,
                                     context.progress().part(0.0, 1.0, "read object"));
  requireClearUnit(simulation.object, placement, object.mesh, profile);
  if (const std::string repair = describe(object.repair); !repair.empty())
    context.note(args.settings.simulation.object + ": " + repair);
  if (simulation.unit) context.note("unit: 1 = " + number(*simulation.unit, 3) + " mm, as given");
  if (args.settings.simulation.placement == Placement::Fit)
    context.note("placed: scaled by " + number(object.transform.scale, 6) + ", moved by (" +
                 number(object.transform.translation.x(), 3) + ", " + number(object.transform.translation.y(), 3) +
                 ", " + number(object.transform.translation.z(), 3) + ") mm");
  if (!isInside(object.mesh, profile.viewingVolume))
    context.note("warning: the object reaches out of the viewing volume (radius " +
                 number(profile.viewingVolume.radius, 0) + " mm, height " + number(profile.viewingVolume.height, 0) +
                 " mm); --place fit moves it inside");
  return std::move(object.mesh);
}

void checkArguments(const AcquireArguments& args, const RigDescription& rig, const ScannerProfile& profile) {
  const bool simulated = isSimulated(rig);
  const bool byHand = std::holds_alternative<HandTableDevice>(rig.table);
  if (simulated && args.object.empty())
    throw InvalidInput("the simulated scanner needs something to look at: name a mesh with --object");
  if (!simulated && !args.object.empty())
    throw InvalidInput("--object is what the simulated scanner looks at: a real one sees what stands before it");
  if (args.course && (!simulated || byHand))
    throw InvalidInput(
        "--stands is for the simulated scanner and table, whose object turns over by itself: a real one is turned over "
        "by hand, which 'vantage-cli stand' begins");
  if (args.settings.firstView >= static_cast<int>(profile.workspace.size()))
    throw InvalidInput("--first-view is " + std::to_string(args.settings.firstView) +
                       ", the workspace has positions 0 to " + std::to_string(profile.workspace.size() - 1));
}

StandCourse courseFrom(const std::string& text) {
  try {
    return parseStandCourse(text);
  } catch (const InvalidInput& e) {
    throw CLI::ValidationError("--stands", e.what());
  }
}

void runAcquire(const AcquireArguments& given, CommandContext& context) {
  AcquireArguments args = given;
  const RigFile file = args.rig.described();
  const bool simulated = isSimulated(file.rig);
  args.settings = args.given.applied(simulated ? AcquisitionSettings() : withCut({}, file));
  args.settings.simulation.object = args.object;
  if (simulated) args.settings.simulation.unit = args.reading.options().unit;
  const std::string session = (std::filesystem::path(args.out) / "session.vantage").string();
  checkSessionPlace(session, args.replace);
  const AcquisitionResults results(args.out);
  if (!args.replace) results.mustBeNew();
  results.mustBeReplaceable({args.object, file.rig.scanner});
  const ProfileSource source = profileOf(file.rig);
  tellMemoryNeeded(raysSaidBy(source), args.settings, 0, context);
  const auto profile = std::make_shared<const ScannerProfile>(parseProfile(source));
  checkArguments(args, file.rig, *profile);
  std::shared_ptr<const Mesh> object;
  if (simulated) object = std::make_shared<const Mesh>(placeObject(args, *profile, context));
  NewFolder folder(args.out);
  const DeviceRun with{file.rig, object, args.reading.options(), args.events, args.course, {}};
  workOnNewSession({session, args.replace, true, {source, args.settings, object.get(), profile}}, context,
                   [&](Session& made) { runDevices(made, with, args.out, context); });
  folder.keep();
}

}  // namespace

void addAcquireCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<AcquireArguments>();
  CLI::App* command =
      app.add_subcommand("acquire", "Acquire an object until nothing scannable is left: a mesh, or a real one");
  command->add_option("--object", args->object, "Mesh to put in front of the simulated scanner");
  args->rig.addTo(*command);
  command->add_flag("--events", args->events,
                    "Say what goes on as JSON lines on standard output, for a program that turns the table");
  command->add_option("--out", args->out, "Folder for session, model and report")->required();
  command->add_flag("--replace", args->replace,
                    "Replace the session of that folder; it is kept aside until the new one is whole");
  command
      ->add_option_function<std::string>(
          "--stands", [args](const std::string& text) { args->course = courseFrom(text); },
          "Turn the object over by itself, up to so many stands, or until none would show anything more (auto)")
      ->type_name("N|auto");
  args->given.addTo(*command);
  args->given.addShorthand(*command, "--seed", "simulation.seed");
  args->given.addShorthand(*command, "--ideal", "simulation.ideal");
  args->given.addShorthand(*command, "--max-views", "max_views");
  args->given.addShorthand(*command, "--tolerance", "planner.tolerance");
  args->given.addShorthand(*command, "--place", "simulation.placement");
  args->reading.addTo(*command);
  args->given.addShorthand(*command, "--first-view", "first_view");
  args->given.addShorthand(*command, "--strategy", "strategy");
  context.addCommonOptions(*command);
  command->callback([args, &context] {
    static_cast<void>(args->given.applied({}));  // what is wrong in itself is wrong use
    runAcquire(*args, context);
  });
}

}  // namespace vantage
