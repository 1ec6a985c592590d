#include <filesystem>
#include <memory>

#include "base/errors.h"
#include "calibration/profile_from_scans.h"
#include "cli/command.h"
#include "cli/reading_arguments.h"
#include "cli/text.h"
#include "io/output_file.h"

namespace vantage {
namespace {

struct ProfileArguments {
  std::vector<std::string> ranges;
  std::string out;
  std::vector<double> receiver;
  std::string name;
  int steps = 90;
  ReadingArguments reading;
};

std::vector<RangeImage> imagesOf(const ProfileArguments& args, const Progress& progress) {
  std::vector<RangeImage> images;
  for (ReadScan& scan : readScans(args.ranges, nullptr, nullptr, args.reading.options(), progress))
    images.push_back(std::move(scan.image));
  return images;
}

// The ray table has the name of the profile beside it.
std::string rayFileOf(const std::string& out) {
  return std::filesystem::path(out).stem().string() + "_rays.csv";
}

void runProfile(const ProfileArguments& args, CommandContext& context) {
  checkOutput(args.out, OutputKind::Json, args.ranges);
  const std::string rayFile = rayFileOf(args.out);
  const std::string rayPath = (std::filesystem::path(args.out).parent_path() / rayFile).string();
  if (!args.receiver.empty() && args.receiver.size() != 3)
    throw InvalidInput("--receiver has " + std::to_string(args.receiver.size()) +
                       " numbers, expected three: right, up and forward of the light [mm]");
  ProfileFitOptions options;
  options.rayFile = rayFile;
  options.steps = args.steps;
  if (!args.name.empty()) options.name = args.name;
  if (!args.receiver.empty()) options.receiver = Vec3(args.receiver[0], args.receiver[1], args.receiver[2]);
  const Progress progress = context.progress();
  const ProfileFit fit =
      profileFromScans(imagesOf(args, progress.part(0.0, 0.5, "read scans")), options, progress.part(0.5, 1.0, "fit"));
  for (const auto& [name, text] : fit.source.attachments) {
    if (std::filesystem::exists(rayPath))
      throw InvalidInput(rayPath + ": is there already, expected no file: the table of rays is to be written there");
    writeTextFile(rayPath, text);
  }
  writeTextFile(args.out, fit.source.text);

  nlohmann::ordered_json json{{"written", args.out}, {"type", fit.type}};
  if (!fit.source.attachments.empty()) json["rays"] = rayPath;
  json.update({{"residual_mm", fit.residual},
               {"range_sigma_mm", fit.noise},
               {"noise_from", fit.noiseFromRepeats ? "repeated_scans" : "even_patches"},
               {"breakdown_angle_deg", degrees(fit.breakdownAngle)},
               {"breakdown_angle_between_deg", {degrees(fit.end.from), degrees(fit.end.to)}},
               {"nearest_mm", fit.nearest},
               {"farthest_mm", fit.farthest}});
  const std::string text =
      "rays: " + std::string(fit.type == "pinhole" ? "a depth camera" : "a table of rays, " + rayPath) +
      "; samples lie " + number(fit.residual, 3) + " mm beside them\n" + "noise: " + number(fit.noise, 3) +
      " mm along the rays, " + (fit.noiseFromRepeats ? "from scans of the same" : "from even patches") + "\n" +
      "samples end at " + number(degrees(fit.breakdownAngle), 0) + " degrees (between " +
      number(degrees(fit.end.from), 0) + " and " + number(degrees(fit.end.to), 0) + "), and lie " +
      number(fit.nearest, 0) + " to " + number(fit.farthest, 0) + " mm away\n" + "written: " + args.out + "\n";
  context.result(json, text);
  context.note("where the table stands is for vantage-cli calibrate to find, with this profile");
}

}  // namespace

void addProfileCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<ProfileArguments>();
  CLI::App* command = app.add_subcommand("profile", "Write the profile of a scanner from scans that it took");
  command
      ->add_option("range", args->ranges, "Range files of one scanner: PLY with rows and columns, organised PCD, PTX")
      ->required();
  command->add_option("--out", args->out, "Profile (JSON) to write")->required();
  command
      ->add_option("--receiver", args->receiver,
                   "Where the receiver is from the light: right, up, forward [mm]; without it the scanner does not "
                   "triangulate")
      ->type_name("R,U,F")
      ->delimiter(',');
  command->add_option("--name", args->name, "Name of the scanner");
  command->add_option("--steps", args->steps, "Positions of the turntable in a full turn")
      ->check(CLI::Range(3, 36000))
      ->capture_default_str();
  args->reading.addTo(*command);
  context.addCommonOptions(*command);
  command->callback([args, &context] { runProfile(*args, context); });
}

}  // namespace vantage
