#include "calibration/calibration_finding.h"

#include <cmath>
#include <cstdio>

namespace vantage {
namespace {

std::string decimals(double value, int count) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", count, value);
  return text;
}

}  // namespace

std::string_view name(CalibrationReason reason) {
  switch (reason) {
    case CalibrationReason::NothingTurns:
      return "nothing_turns";
    case CalibrationReason::TooSmallTurn:
      return "too_small_turn";
    case CalibrationReason::RotationNotObservable:
      return "rotation_not_observable";
    case CalibrationReason::NoCommonAxis:
      return "no_common_axis";
    case CalibrationReason::Slip:
      return "slip";
    case CalibrationReason::Rival:
      return "rival";
    case CalibrationReason::Unsure:
      return "unsure";
    case CalibrationReason::ResidualLarge:
      return "residual_large";
    case CalibrationReason::PlaneLeans:
      return "plane_leans";
    case CalibrationReason::TableNotSeen:
      return "table_not_seen";
    case CalibrationReason::TurnsOtherWay:
      return "turns_other_way";
    case CalibrationReason::OtherRatio:
      break;
  }
  return "other_ratio";
}

std::string describe(const CalibrationFinding& finding) {
  const double value = finding.value.value_or(0.0);
  const std::string scan = finding.scan ? "scan " + std::to_string(*finding.scan + 1) : std::string("a scan");
  switch (finding.reason) {
    case CalibrationReason::NothingTurns:
      return "next to nothing moves between the scans (" + scan + " has " + decimals(value, 0) +
             " samples that do): put an object that is not round on the table, where the scanner sees it, and see that "
             "the table turns";
    case CalibrationReason::TooSmallTurn:
      return "the table turned by " + decimals(value, 1) +
             " degrees in all, which is too little to tell its axis: scan at angles that span 60 degrees or more";
    case CalibrationReason::RotationNotObservable:
      return "what was scanned looks nearly the same however it is turned (the axis is unsure by " +
             decimals(value, 1) + " mm): put an object with edges or a handle on the table";
    case CalibrationReason::NoCommonAxis:
      return "no turn about one axis brings the scans together (" + decimals(100.0 * value, 0) +
             " % of what should coincide does not): the object may have moved on the table, the angles may belong to "
             "other scans, or the scans overlap too little: use smaller turns";
    case CalibrationReason::Slip:
      return "from " + scan + " on the table stands " + decimals(std::abs(value), 1) + " degrees " +
             (value < 0.0 ? "short of" : "beyond") +
             " where it counts: it slips or was knocked; see to belt, speed and load, and scan again";
    case CalibrationReason::Rival:
      return "a table that turns " + decimals(value, 2) +
             " degrees for every degree that it counts would fit nearly as well: use an object with less symmetry, or "
             "angles that are no multiples of each other";
    case CalibrationReason::Unsure:
      return "the axis is unsure by " + decimals(value, 2) +
             " mm: scan at angles that span more, or an object that shows more of itself";
    case CalibrationReason::ResidualLarge:
      return "the scans differ by " + decimals(value, 1) + " times of what noise explains (most in " + scan +
             "): see that object and scanner stand firm";
    case CalibrationReason::PlaneLeans:
      return "the table top leans by " + decimals(value, 2) +
             " degrees against the axis: the table wobbles, or what was taken for its top is not";
    case CalibrationReason::TurnsOtherWay:
      return "the table counts upwards as it turns clockwise: its angles are reversed from here on";
    case CalibrationReason::TableNotSeen:
      return "no scan shows the table top: its height is guessed from the profile and the lowest sample, and may be "
             "off "
             "by " +
             decimals(value, 1) +
             " mm (the axis is not touched by that): let the scanner look down on the table, or put a flat thing on it "
             "that reaches above its lowest rays, and calibrate again; else cut no closer to the table than that";
    case CalibrationReason::OtherRatio:
      break;
  }
  return "the table turns " + decimals(value, 4) +
         " degrees for every degree that it counts: its angles are corrected from here on";
}

CalibrationVerdict worthOf(const CalibrationFinding& finding) {
  switch (finding.reason) {
    case CalibrationReason::NothingTurns:
    case CalibrationReason::TooSmallTurn:
    case CalibrationReason::RotationNotObservable:
    case CalibrationReason::NoCommonAxis:
    case CalibrationReason::Slip:
      return CalibrationVerdict::Failed;
    case CalibrationReason::Rival:
    case CalibrationReason::Unsure:
    case CalibrationReason::ResidualLarge:
    case CalibrationReason::PlaneLeans:
    case CalibrationReason::TableNotSeen:
      return CalibrationVerdict::Doubtful;
    case CalibrationReason::TurnsOtherWay:
    case CalibrationReason::OtherRatio:
      break;
  }
  return CalibrationVerdict::Good;
}

}  // namespace vantage
