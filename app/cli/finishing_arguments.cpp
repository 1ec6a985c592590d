#include "cli/finishing_arguments.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.h"
#include "cli/point_arguments.h"
#include "cli/text.h"
#include "measuring/object_frame.h"

namespace vantage {
namespace {

bool isPositive(const std::string& text) {
  double number = 0.0;
  return CLI::detail::lexical_cast(text, number) && number > 0.0 && std::isfinite(number);
}

CLI::Validator positive() {
  return {[](std::string& text) { return isPositive(text) ? std::string() : "'" + text + "' is no number above 0"; },
          "NUMBER"};
}

// A number above 0, or a word for no limit.
CLI::Validator positiveOr(const std::string& all) {
  return {[all](std::string& text) {
            return text == all || isPositive(text) ? std::string()
                                                   : "'" + text + "' is neither a number above 0 nor '" + all + "'";
          },
          "NUMBER|" + all};
}

double numberOr(const std::string& text, const std::string& all) {
  return text == all ? std::numeric_limits<double>::infinity() : std::stod(text);
}

std::string sentenceFor(PrintFault fault, const PrintCheck& check) {
  switch (fault) {
    case PrintFault::Empty:
      return "nothing of it is left";
    case PrintFault::Open:
      return "it has " + counted(check.openings, "opening") + ", the widest " + number(check.widestOpening, 1) +
             " mm wide (close them with --close-holes)";
    case PrintFault::NonManifold:
      return counted(check.nonManifoldEdges, "edge") +
             " with more than two triangles, or with two that face opposite ways";
    case PrintFault::BowTies:
      return "surfaces only touch in " + counted(check.bowTies, "vertex", "vertices");
    case PrintFault::Inward:
      return counted(check.inwardPieces, "piece") + " of it lies inside out";
    case PrintFault::Crossings:
      return counted(check.crossings, "pair") + " of triangles pass through each other (close fewer openings)";
    case PrintFault::Pieces:
      break;
  }
  return "it is in " + counted(check.pieces, "piece") + " (leave the small ones out with --pieces)";
}

}  // namespace

void FinishingArguments::addTo(CLI::App& command) {
  command
      .add_option(
          "--close-holes", close_,
          "Close openings up to so many millimetres wide, or all of them, with smooth lids. Lids are made up and "
          "marked: 'invented' in PLY, a material in 3MF")
      ->check(positiveOr("all"));
  command
      .add_option("--pieces", leaveOut_,
                  "Leave out loose pieces up to so many square millimetres, or all but the largest")
      ->check(positiveOr("largest"));
  command.add_option("--max-triangles", maxTriangles_, "No more triangles than this; the error is measured and said")
      ->check(CLI::Range(std::size_t{1}, std::numeric_limits<std::size_t>::max()));
  command
      .add_option("--error", maxError_,
                  "Fewer triangles, as far as no point of either surface is farther from the other than this [mm]")
      ->check(positive());
  command.add_flag("--printable", printable_,
                   "Only write a model that can be printed: closed, its outside outside, in one piece");
  command
      .add_option(
          "--align", align_,
          "Three points X,Y,Z of the surface [mm]: the first becomes the origin, the second lies on the x axis, the "
          "third in the plane z = 0")
      ->check(pointText())
      ->expected(3);
  command.add_option("--units", unit_, "Of the coordinates in the file: mm or inch")
      ->check(CLI::IsMember({"mm", "inch"}))
      ->capture_default_str();
}

FinishingOptions FinishingArguments::options() const {
  FinishingOptions options;
  options.repair = printable_;
  if (!leaveOut_.empty()) options.leaveOut = numberOr(leaveOut_, "largest");
  if (!close_.empty()) {
    options.close.emplace();
    if (close_ != "all") options.close->maxWidth = numberOr(close_, "all");
  }
  if (maxTriangles_ || maxError_) options.simplify = SimplificationOptions{maxTriangles_, maxError_};
  return options;
}

LengthUnit FinishingArguments::unit() const {
  return lengthUnitNamed(unit_).value_or(LengthUnit::Millimetre);
}

std::optional<Pose> FinishingArguments::frame() const {
  if (align_.empty()) return std::nullopt;
  return frameFromPicks({pointOf(align_[0]), pointOf(align_[1]), pointOf(align_[2])});
}

void requirePrintable(const FinishedModel& finished) {
  const PrintCheck& check = finished.check;
  if (check.printable()) return;
  std::string why;
  for (const PrintFault fault : check.faults) why += (why.empty() ? "" : "; ") + sentenceFor(fault, check);
  throw InvalidInput("the model cannot be printed as one piece: " + why + "; nothing was written");
}

nlohmann::ordered_json finishingJson(const FinishedModel& finished) {
  const PrintCheck& check = finished.check;
  nlohmann::ordered_json json{{"closed", check.closed()},
                              {"printable", check.printable()},
                              {"openings", check.openings},
                              {"pieces", check.pieces},
                              {"crossings", check.crossings},
                              {"area_measured_mm2", finished.measuredArea},
                              {"area_invented_mm2", finished.inventedArea}};
  if (check.volume) json["volume_mm3"] = *check.volume;
  for (const PrintFault fault : check.faults) json["faults"].push_back(name(fault));
  json["openings_closed"] = finished.closed.size();
  for (const OpeningLeft& left : finished.left)
    json["left_open"].push_back({{"edges", left.edges}, {"width_mm", left.width}, {"reason", name(left.reason)}});
  json["pieces_left_out"] = finished.piecesLeftOut;
  json["area_left_out_mm2"] = finished.areaLeftOut;
  json["triangles_turned"] = finished.trianglesTurned;
  if (finished.simplified) {
    json["error_greatest_mm"] = finished.simplified->error.greatest;
    json["error_rms_mm"] = finished.simplified->error.rms;
    json["max_triangles_reached"] = finished.simplified->reached;
  }
  return json;
}

std::string finishingLines(const FinishedModel& finished) {
  std::string text;
  if (finished.piecesLeftOut > 0)
    text += counted(finished.piecesLeftOut, "loose piece") + " left out, " + number(finished.areaLeftOut, 1) + " mm²\n";
  if (!finished.closed.empty())
    text += counted(finished.closed.size(), "opening") + " closed: " + number(finished.inventedArea, 1) +
            " mm² of the surface are invented, " + number(finished.measuredArea, 1) + " mm² were measured\n";
  if (!finished.left.empty()) {
    const auto widest = std::max_element(finished.left.begin(), finished.left.end(),
                                         [](const auto& a, const auto& b) { return a.width < b.width; });
    text += counted(finished.left.size(), "opening") + " left open, the widest " + number(widest->width, 1) + " mm\n";
  }
  if (finished.check.crossings > 0)
    text += counted(finished.check.crossings, "pair") + " of triangles pass through each other\n";
  if (finished.simplified)
    text += "simplified: no farther than " + number(finished.simplified->error.greatest, 3) + " mm from the model, " +
            number(finished.simplified->error.rms, 3) + " mm in the mean (measured both ways)" +
            (finished.simplified->reached ? "\n" : "; with fewer triangles the border would have moved\n");
  if (finished.check.volume) text += "encloses " + number(*finished.check.volume / 1000.0, 3) + " cm³\n";
  return text;
}

}  // namespace vantage
