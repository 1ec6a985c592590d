#include "report/stands_html.h"

#include <algorithm>

#include "acquisition/stand_composites.h"
#include "report/svg_chart.h"
#include "report/wording.h"

namespace vantage {
namespace {

std::string percent(double share) {
  return decimalText(100.0 * share, 1);
}

std::string chosenText(PoseChoice choice) {
  switch (choice) {
    case PoseChoice::Evidence:
      return "decided by the evidence";
    case PoseChoice::Operator:
      return "chosen by the operator among the possible poses";
    case PoseChoice::Despite:
      break;
  }
  return "used by the operator although something speaks against it";
}

// What came of a stand, as a sentence.
std::string outcome(const AcquisitionState& state, int index) {
  if (index == referenceOf(state.stands)) return "The reference: the object's coordinates are those of its table.";
  const auto& alignment = state.stands[static_cast<std::size_t>(index)].alignment;
  const bool known = isOfObject(state, index);
  if (!alignment) return known ? "In place, as the operator said." : "Not aligned yet: its scans are not in the model.";
  const std::string verdict =
      "Verdict " + std::string(name(alignment->verdict)) + ": " + escapedHtml(describe(*alignment)) + ". ";
  if (!known) return verdict + "Its scans are not in the model.";
  if (!alignment->used) return verdict + "In place, as the operator said.";
  return verdict + "Pose " + std::to_string(*alignment->used + 1) + ", " + chosenText(alignment->choice) + ".";
}

struct ScanCounts {
  std::size_t views = 0;
  std::size_t aside = 0;
  std::size_t others = 0;
};

ScanCounts countsOf(const AcquisitionState& object, int stand) {
  ScanCounts counts;
  for (const KeptScan& scan : object.scans) {
    if (scan.station().stand != stand) continue;
    ++(scan.status == ScanStatus::In ? counts.views : scan.status == ScanStatus::Aside ? counts.aside : counts.others);
  }
  return counts;
}

std::string scansText(const ScanCounts& counts) {
  std::string text = std::to_string(counts.views) + (counts.views == 1 ? " view" : " views") + " in the model";
  if (counts.aside > 0) text += ", " + std::to_string(counts.aside) + " set aside";
  if (counts.others > 0) text += ", " + std::to_string(counts.others) + " not used";
  return text;
}

std::string posesHtml(const StandAlignment& alignment) {
  if (alignment.candidates.empty()) return {};
  std::string html = "<table>" + htmlRow({"Pose", "In common [%]", "Distance there [mm]", "Contradicted by rays [%]",
                                          "Below the table [%]", "Expected, not seen [%]", "Possible"},
                                         "th");
  for (std::size_t i = 0; i < alignment.candidates.size(); ++i) {
    const StandPose& pose = alignment.candidates[i];
    const bool used = alignment.used == static_cast<int>(i);
    html += htmlRow({std::to_string(i + 1) + (used ? ", in use" : ""), percent(pose.overlap), decimalText(pose.rms, 3),
                     percent(pose.conflict), percent(pose.table), percent(pose.missing), pose.possible ? "yes" : "no"});
  }
  return html + "</table>\n";
}

}  // namespace

std::string standsHtml(const AcquisitionState& state, const std::vector<ReportPicture>& pictures) {
  if (state.stands.size() < 2) return {};
  const AcquisitionState object = withObject(state);
  std::string html =
      "<h2>Stands</h2>\n<p class=\"faint\">How the object stood when it was scanned, and how it is known that the "
      "scans of each belong together. Shares are of the surface of both.</p>\n";
  html += picturesHtml(pictures);
  for (int index = 0; index <= state.stand(); ++index) {
    html += "<h3>Stand " + std::to_string(index) + "</h3>\n<p>" + scansText(countsOf(object, index)) + ". " +
            outcome(state, index) + "</p>\n";
    if (const auto& alignment = state.stands[static_cast<std::size_t>(index)].alignment) html += posesHtml(*alignment);
  }
  return html;
}

}  // namespace vantage
