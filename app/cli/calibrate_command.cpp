#include <memory>

#include "base/errors.h"
#include "calibration/calibration_scans.h"
#include "calibration/table_calibrator.h"
#include "cli/calibration_rig.h"
#include "cli/command.h"
#include "cli/reading_arguments.h"
#include "cli/rig_arguments.h"
#include "cli/text.h"
#include "io/output_file.h"
#include "scanner/calibration_file.h"

namespace vantage {
namespace {

struct CalibrateArguments {
  RigArguments rig;
  std::string scanner;
  std::string out;
  int scans = 6;
  std::vector<std::string> ranges;
  std::vector<double> angles;
  ReadingArguments reading;
};

std::vector<CalibrationScan> recordedScans(const CalibrateArguments& args, const ScannerProfile& profile,
                                           const Progress& progress) {
  if (args.angles.size() != args.ranges.size())
    throw InvalidInput("--angles has " + std::to_string(args.angles.size()) + " angles for " +
                       std::to_string(args.ranges.size()) + " range files, expected one for each");
  std::vector<ReadScan> read = readScans(args.ranges, nullptr, &profile, args.reading.options(), progress);
  std::vector<CalibrationScan> scans;
  for (std::size_t k = 0; k < read.size(); ++k)
    scans.push_back({std::make_shared<const RangeImage>(std::move(read[k].image)), args.angles[k]});
  return scans;
}

std::vector<CalibrationScan> scansOf(const CalibrateArguments& args,
                                     const std::shared_ptr<const ScannerProfile>& profile, const Progress& progress) {
  if (!args.ranges.empty()) return recordedScans(args, *profile, progress);
  if (!args.rig.given())
    throw InvalidInput("calibrate needs --sensor and --table, or --ranges and --angles of recorded scans");
  const std::vector<double> angles = calibrationAngles(args.scans);
  const CalibrationRig rig =
      openCalibrationRig(args.rig.described().rig, args.reading.options(), profile, progress.part(0.0, 0.1));
  return takeCalibrationScans(*rig.sensor, *rig.table, angles, progress.part(0.1, 1.0), rig.startsByItself);
}

nlohmann::ordered_json jsonOf(const CalibrationResult& result, const CalibrateArguments& args) {
  nlohmann::ordered_json json = calibrationJson(result.calibration);
  json["plane_sigma_mm"] = result.planeSigma;
  json["plane_known_by"] = result.planeSeen ? "scans" : "guess";
  json["scans"] = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < result.scans.size(); ++k) {
    const ScanResidual& scan = result.scans[k];
    nlohmann::ordered_json item;
    if (k < args.ranges.size()) item["file"] = args.ranges[k];
    item.update({{"table_deg", scan.tableAngle},
                 {"used", scan.used},
                 {"turned_deg", degrees(scan.turned)},
                 {"off_deg", degrees(scan.off)},
                 {"rms_mm", scan.rms},
                 {"pairs", scan.pairs},
                 {"moving_samples", scan.moving}});
    json["scans"].push_back(std::move(item));
  }
  return json;
}

std::string textOf(const CalibrationResult& result) {
  const TableCalibration& c = result.calibration;
  auto triple = [](const Vec3& v, int decimals) {
    return "(" + number(v.x(), decimals) + ", " + number(v.y(), decimals) + ", " + number(v.z(), decimals) + ")";
  };
  std::string text = "calibration: " + std::string(name(c.verdict)) + "\n";
  if (c.verdict == CalibrationVerdict::Failed) return text;
  text += "axis: through " + triple(c.axisPoint, 2) + " mm along " + triple(c.axisDirection, 5) + ", sure to " +
          number(c.sigma, 3) + " mm and " + number(degrees(c.angleSigma), 3) + " degrees\n";
  text += "table plane: " + number((tableCentre(c) - c.axisPoint).norm(), 2) + " mm below that point, " +
          (result.planeSeen ? "sure to " : "not seen but guessed, to ") + number(result.planeSigma, 2) + " mm\n";
  text += "turning: " + std::string(c.sense > 0 ? "counter-clockwise" : "clockwise") +
          " seen from above as it counts upwards, " + number(c.degreesPerCommandedDegree, 4) +
          " degrees for every degree\n";
  for (const ScanResidual& scan : result.scans)
    text += "scan at " + number(scan.tableAngle, 2) + " degrees: " +
            (scan.used ? "turned " + number(degrees(scan.turned), 2) + ", off by " + number(degrees(scan.off), 2) +
                             " degrees, residual " + number(scan.rms, 3) + " mm\n"
                       : "not used, it shows too little that turns\n");
  return text;
}

std::vector<Remark> remarksOf(const CalibrationResult& result) {
  std::vector<Remark> remarks;
  for (const CalibrationFinding& finding : result.findings)
    remarks.push_back({std::string(name(finding.reason)), describe(finding), finding.scan,
                       worthOf(finding) != CalibrationVerdict::Good});
  return remarks;
}

void runCalibrate(const CalibrateArguments& args, CommandContext& context) {
  std::vector<std::string> inputs = args.ranges;
  inputs.push_back(args.scanner);
  checkOutput(args.out, OutputKind::Json, inputs);
  ProfileSource source = readProfileSource(args.scanner);
  const auto profile = std::make_shared<const ScannerProfile>(parseProfile(source));
  if (profile->calibration) context.note("the profile has a calibration; the new one is to replace it");
  const Progress progress = context.progress();
  const auto scans = scansOf(args, profile, progress.part(0.0, 0.4, "scan"));
  const CalibrationResult result = calibrateTable(scans, *profile, {}, progress.part(0.4, 1.0, "calibrate"));
  nlohmann::ordered_json json = jsonOf(result, args);
  if (result.calibration.verdict == CalibrationVerdict::Failed) {
    context.result(std::move(json), textOf(result), remarksOf(result));
    throw InvalidInput("the table is not calibrated, nothing was written: " + describe(result.findings.front()));
  }
  (void)parseProfile(withCalibration(std::move(source), result.calibration));
  writeTextFile(args.out, calibrationText(result.calibration));
  json["written"] = args.out;
  context.result(std::move(json), textOf(result) + "written: " + args.out + "\n", remarksOf(result));
}

}  // namespace

void addCalibrateCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<CalibrateArguments>();
  CLI::App* command = app.add_subcommand(
      "calibrate", "Find where a turntable stands before a scanner and how it turns, from scans of any object on it");
  command->add_option("--scanner", args->scanner, "Scanner profile (JSON)")->required();
  command->add_option("--out", args->out, "File (JSON) to write the calibration to")->required();
  args->rig.addDevicesTo(*command);
  command->add_option("--scans", args->scans, "How many scans to take")
      ->check(CLI::Range(3, 12))
      ->capture_default_str();
  command->add_option("--ranges", args->ranges, "Recorded range files, instead of --sensor and --table");
  command->add_option("--angles", args->angles, "Where the table counted to stand in each of them [degrees]")
      ->type_name("DEG,...")
      ->delimiter(',');
  args->reading.addTo(*command);
  context.addCommonOptions(*command);
  command->callback([args, &context] { runCalibrate(*args, context); });
}

}  // namespace vantage
