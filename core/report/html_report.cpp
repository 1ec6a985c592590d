#include "report/html_report.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string_view>

#include "acquisition/further_scan.h"
#include "base/errors.h"
#include "geometry/measures.h"
#include "planning/choice.h"
#include "report/areas_known.h"
#include "report/completeness.h"
#include "report/edges_left.h"
#include "report/html_parts.h"
#include "report/reading_words.h"
#include "report/report.h"
#include "report/stands_html.h"
#include "report/svg_chart.h"
#include "report/wording.h"

namespace vantage {
namespace {

constexpr std::string_view kStyle = R"(<style>
:root { --text: #1d2329; --faint: #5d6873; --line: #d3d9de; --bar: #8fb3d1; --mark: #b35900; --back: #ffffff; }
@media (prefers-color-scheme: dark) { :root { --text: #e4e8eb; --faint: #9aa6b0; --line: #3c454d; --bar: #4d7ea3;
  --mark: #f0a04b; --back: #1b1f23; } }
body { font: 15px/1.5 "DejaVu Sans", "Segoe UI", sans-serif; color: var(--text); background: var(--back);
  max-width: 980px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.6em; } h2 { font-size: 1.2em; margin-top: 2em; border-bottom: 1px solid var(--line); }
table { border-collapse: collapse; width: 100%; } td, th { padding: .3em .6em; text-align: right;
  border-bottom: 1px solid var(--line); } th:first-child, td:first-child { text-align: left; }
figure { margin: 0; } figcaption, .faint, svg text { color: var(--faint); fill: var(--faint); font-size: 12px; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(280px, 1fr)); gap: 1em; }
img { width: 100%; border: 1px solid var(--line); } svg { width: 100%; }
.wide { overflow-x: auto; }
@media print { body { max-width: none; margin: 0; font-size: 11px; } .wide table { font-size: 9px; }
  .wide { overflow: visible; } td, th { padding: .2em .3em; } h2 { break-after: avoid; }
  figure, tr, svg { break-inside: avoid; } }
.bar { fill: var(--bar); } .marked { fill: var(--mark); } .axis { stroke: var(--line); }
.threshold { stroke: var(--mark); stroke-dasharray: 5 4; } .line { fill: none; stroke: var(--bar); stroke-width: 2; }
</style>
)";

// How it ended, and what that leaves.
std::string endingText(const AcquisitionState& state) {
  const bool asAsked = state.termination == Termination::Finished && !state.plan;
  std::string text(asAsked ? "Finished: the views that were asked for were taken." : sentenceOf(state.termination));
  const auto further = furtherScan(state);
  if (further && further->predicted)
    text += " A view from position " + std::to_string(further->position) + " would still show " +
            decimalText(promise(*further->predicted), 0) + " mm².";
  return text;
}

// As what recorded scans were read, once for all that were read alike.
std::string readingRows(const AcquisitionState& state) {
  std::vector<std::string> said;
  for (const KeptScan& scan : state.scans) {
    if (!scan.record.reading) continue;
    const std::string text = english(phraseOf(*scan.record.reading));
    if (std::find(said.begin(), said.end(), text) == said.end()) said.push_back(text);
  }
  std::string html;
  for (const std::string& text : said) html += htmlRow({"Scans read as", escapedHtml(text)});
  return html;
}

// A report is handed on: where files were on this machine is nobody's business.
std::string fileName(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

std::string completenessRows(const AcquisitionState& state) {
  if (!state.model) return {};
  const Vec3 size = boundingBox(state.model->mesh).size();
  const Completeness complete = completenessOf(state);
  const bool hiddenIsKnown = state.plan && state.plan->voids && state.plan->outcome != PlanOutcome::Found;
  std::string html = htmlRow({"Size", decimalText(size.x(), 1) + " × " + decimalText(size.y(), 1) + " × " +
                                          decimalText(size.z(), 1) + " mm, all lengths in millimetres"});
  if (hiddenIsKnown)
    html += htmlRow({"Covered of what the scanner reaches", decimalText(100.0 * complete.scannableCovered, 1) + " %"});
  html += htmlRow({"Covered of the whole, at most", decimalText(100.0 * complete.wholeCovered, 1) + " %"});
  html += htmlRow({"Openings", std::to_string(complete.holes)});
  if (complete.erasedHoles > 0)
    html +=
        htmlRow({"Openings where the operator erased what is not the object", std::to_string(complete.erasedHoles)});
  html += htmlRow({"Loose pieces", std::to_string(complete.pieces)});
  return html + htmlRow({"Closed", complete.closed ? "yes" : "no"});
}

std::string summaryHtml(const AcquisitionState& state) {
  const AcquisitionSettings& settings = state.settings;
  const auto model = modelJson(state.model ? state.model->mesh : Mesh{});
  std::string html = "<p>" + endingText(state) + "</p>\n<table>";
  html += htmlRow({"Object", escapedHtml(settings.simulation.object.empty() ? "recorded scans"
                                                                            : fileName(settings.simulation.object))});
  html += htmlRow({"Scanner", escapedHtml(state.profile ? state.profile->name : "none: recorded scans")});
  html += htmlRow({"Views", std::to_string(countScans(state, ScanStatus::In)) + " integrated, " +
                                std::to_string(countScans(state, ScanStatus::Rejected)) + " not registered, " +
                                std::to_string(countScans(state, ScanStatus::LeftOut)) + " left out"});
  html += htmlRow(
      {"Model", model["triangles"].dump() + " triangles, " + decimalText(model["area_mm2"].get<double>(), 0) + " mm²"});
  html += readingRows(state);
  html += completenessRows(state);
  html += htmlRow({"Boundary", model["boundary_edges"].dump() + " edges"});
  return html + "</table>\n";
}

std::string coverageHtml(const AcquisitionState& state) {
  LineChart chart{"What the views of the model added when they were taken, summed [mm²]", {}};
  double area = 0.0;
  for (const KeptScan* scan : scansOf(state, ScanStatus::In)) {
    if (!areasKnown(scan->record)) return {};
    chart.values.push_back(area += scan->record.newArea);
  }
  return "<h2>Coverage</h2>\n<p class=\"faint\">" + escapedHtml(chart.title) + "</p>\n" + drawChart(chart);
}

std::string promisedCells(const ScanRecord& record) {
  if (!record.predicted) return htmlCell("–") + htmlCell("–");
  return htmlCell(decimalText(promise(*record.predicted), 0)) + htmlCell(decimalText(record.predicted->overlapArea, 0));
}

std::string positionText(const KeptScan& scan) {
  return scan.station().position ? std::to_string(*scan.station().position) : "–";
}

// Of scans that are not worked on whole, by how much: every scan of a scanner is thinned alike.
std::string thinningHtml(const AcquisitionState& state) {
  std::map<int, std::size_t> scans;
  for (const KeptScan& scan : state.scans)
    if (scan.record.everyNth > 1) ++scans[scan.record.everyNth];
  std::string html;
  for (const auto& [everyNth, count] : scans)
    html += "<p class=\"faint\">Of " + std::to_string(count) + (count == 1 ? " scan " : " scans ") +
            thinningText(everyNth) +
            " was worked on, see the setting triangulation.spacing; the session file has all samples.</p>\n";
  return html;
}

std::string viewsHtml(const AcquisitionState& state) {
  std::string html =
      "<h2>Views</h2>\n<p class=\"faint\">What the plan promised, and what came [mm²]; registration residual [mm]. A "
      "promise counts only the strip beside the border of the model that a view shows for certain, weighted by how "
      "squarely it is seen; the new area is all surface that the view brought, and as a rule much larger.</p>\n<div "
      "class=\"wide\"><table>";
  html += htmlRow({"Scan", "Position", "Samples", "Void promised", "Overlap promised", "New area", "Overlap",
                   "Residual", "Verdict"},
                  "th");
  for (const KeptScan* scan : scansOf(state, ScanStatus::In)) {
    const ScanRecord& r = scan->record;
    html += "<tr>" + htmlCell(std::to_string(scan->number)) + htmlCell(positionText(*scan)) +
            htmlCell(std::to_string(r.samples)) + promisedCells(r) +
            htmlCell(areasKnown(r) ? decimalText(r.newArea, 0) : "–") +
            htmlCell(areasKnown(r) ? decimalText(r.overlapArea, 0) : "–") +
            htmlCell(decimalText(r.registration.rms, 3)) + htmlCell(std::string(name(r.registration.verdict))) +
            "</tr>\n";
  }
  for (const KeptScan* scan : scansOf(state, ScanStatus::Rejected))
    html +=
        htmlRow({std::to_string(scan->number) + ", did not fit", positionText(*scan),
                 std::to_string(scan->record.samples), "", "", "", "", decimalText(scan->record.registration.rms, 3),
                 escapedHtml(describe(scan->record.registration.finding))});
  for (const KeptScan* scan : scansOf(state, ScanStatus::LeftOut))
    html +=
        htmlRow({std::to_string(scan->number) + ", left out", positionText(*scan), std::to_string(scan->record.samples),
                 "", "", "", "", decimalText(scan->record.registration.rms, 3), "by the operator"});
  return html + "</table></div>\n" + thinningHtml(state);
}

std::string objectiveFigure(const Plan& plan, const std::string& when) {
  BarChart chart{
      when + ": void that each position would show [mm²]", {}, plan.terminationThreshold, "F", plan.position};
  for (const PositionScore& score : plan.scores) chart.values.push_back(promise(score));
  return "<figure>" + drawChart(chart) + "<figcaption>" + escapedHtml(chart.title) +
         (plan.position ? "; proposed: position " + std::to_string(*plan.position) : "; nothing proposed") +
         (plan.tableAlone ? "; nothing overlaps enough, the table alone places it"
                          : "; least overlap t = " + decimalText(plan.leastOverlap, 0) + " mm²") +
         "</figcaption></figure>\n";
}

std::string objectiveHtml(const AcquisitionState& state) {
  std::string html;
  std::shared_ptr<const Plan> last;
  for (const KeptScan* scan : scansOf(state, ScanStatus::In)) {
    last = scan->record.planAfter;
    if (last && !last->scores.empty()) html += objectiveFigure(*last, "After scan " + std::to_string(scan->number));
  }
  // The plan that holds may be a later one: views were left out, or settings changed.
  if (state.plan && state.plan != last && !state.plan->scores.empty()) html += objectiveFigure(*state.plan, "Now");
  return html.empty() ? html : "<h2>Objective</h2>\n" + html;
}

std::string timesHtml(const AcquisitionState& state) {
  std::string html = "<h2>Time of each phase [s]</h2>\n<div class=\"wide\"><table>";
  std::vector<std::string> head{"Scan"};
  for (int phase = 0; phase < kPhases; ++phase) head.emplace_back(titleOf(static_cast<Phase>(phase)));
  html += htmlRow(head, "th");
  std::array<double, kPhases> total{};
  for (const KeptScan* scan : scansOf(state, ScanStatus::In)) {
    std::vector<std::string> cells{std::to_string(scan->number)};
    for (int phase = 0; phase < kPhases; ++phase) {
      const auto it = scan->record.seconds.find(static_cast<Phase>(phase));
      const double seconds = it == scan->record.seconds.end() ? 0.0 : it->second;
      total[static_cast<std::size_t>(phase)] += seconds;
      cells.push_back(decimalText(seconds, 2));
    }
    html += htmlRow(cells);
  }
  std::vector<std::string> sums{"All"};
  for (const double seconds : total) sums.push_back(decimalText(seconds, 2));
  return html + htmlRow(sums, "th") + "</table></div>\n";
}

std::string remainingHtml(const AcquisitionState& state) {
  if (!state.plan) return {};
  const Plan& plan = *state.plan;
  std::string html = "<h2>What is left, and why</h2>\n<table>" + htmlRow({"Reason", "Edges", "Length [mm]"}, "th");
  for (const EdgesLeft& left : edgesLeft(plan))
    html += htmlRow(
        {std::string(sentenceOf(left.reason, plan.outcome)), std::to_string(left.edges), decimalText(left.length, 0)});
  return html + "</table>\n";
}

}  // namespace

std::string makeHtmlReport(const AcquisitionState& state, const HtmlReportOptions& options) {
  if (!options.viewPictures.empty() && options.viewPictures.size() != countScans(state, ScanStatus::In))
    throw InvalidInput("the report was given " + std::to_string(options.viewPictures.size()) +
                       " pictures of views, expected " + std::to_string(countScans(state, ScanStatus::In)));
  if (!options.standPictures.empty() && options.standPictures.size() != state.stands.size())
    throw InvalidInput("the report was given " + std::to_string(options.standPictures.size()) +
                       " pictures of stands, expected " + std::to_string(state.stands.size()));
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>Vantage report</title>\n";
  html.append(kStyle).append("</head><body>\n<h1>Acquisition report</h1>\n");
  html += summaryHtml(state) + picturesHtml(options.pictures) + coverageHtml(state) + viewsHtml(state);
  html += standsHtml(state, options.standPictures);
  html += picturesHtml(options.viewPictures) + objectiveHtml(state) + timesHtml(state) + remainingHtml(state);
  return html + "<p class=\"faint\">Vantage " + escapedHtml(options.version) + ", seed " +
         std::to_string(state.settings.simulation.seed) + "</p>\n</body></html>\n";
}

}  // namespace vantage
