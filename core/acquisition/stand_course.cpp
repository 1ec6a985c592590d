#include "acquisition/stand_course.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "acquisition/stand_composites.h"
#include "base/errors.h"
#include "geometry/measures.h"

namespace vantage {
namespace {

// Fewer views have too little surface to be told apart.
constexpr int kLeastViews = 3;
// More stands than an object has sides worth showing.
constexpr int kMostStands = 12;
// So many stands in a row that came to nothing say that no other will come to more.
constexpr int kMostUseless = 2;
// A stand that shows so many times what another shows is the better one to fit further stands to.
constexpr double kMuchMore = 2.0;
// What is worth turning the object over and scanning it a few times, as a share of what is known of it.
constexpr double kWorthAStand = 0.005;

// The area of the object that no stand before this one had shown [mm^2]. Views come into a model in their order, and
// every triangle is of the first view that shows it.
double addedBy(const AcquisitionState& object, int stand) {
  if (!object.model) return 0.0;
  const std::vector<const KeptScan*> views = scansOf(object, ScanStatus::In);
  const Mesh& mesh = object.model->mesh;
  double added = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (views[object.model->triangleView[t]]->station().stand == stand) added += triangleArea(mesh, mesh.triangles[t]);
  return added;
}

// The stands up to the one of now that found no place, or added no more to the object than is worth a stand.
int uselessInARow(const AcquisitionState& state) {
  const AcquisitionState object = withObject(state);
  const double known = object.model ? area(object.model->mesh) : 0.0;
  const double least = std::max(leastGain(state), kWorthAStand * known);
  int useless = 0;
  for (int stand = state.stand(); stand > 0; --stand, ++useless)
    if (isOfObject(state, stand) && addedBy(object, stand) > least) break;
  return useless;
}

// The best pose of a stand where the choice makes no difference, as with a body that is symmetric all over.
std::optional<int> anyPoseOf(const AcquisitionState& state, int stand) {
  const auto& alignment = state.stands[static_cast<std::size_t>(stand)].alignment;
  if (isOfObject(state, stand) || !alignment || !alignment->sameSurface) return std::nullopt;
  for (std::size_t i = 0; i < alignment->candidates.size(); ++i)
    if (alignment->candidates[i].possible) return static_cast<int>(i);
  return std::nullopt;
}

// The largest of the stands that are models of their own and fit nowhere, where it shows much more than the only stand
// of the object.
std::optional<int> betterReference(const AcquisitionState& state) {
  const auto areaOf = [&](int composite) {
    const AcquisitionState one = withComposite(state, composite);
    return one.model ? area(one.model->mesh) : 0.0;
  };
  std::optional<int> best;
  double most = kMuchMore * areaOf(referenceOf(state.stands));
  for (const int stand : standsToAlign(state)) {
    const auto& alignment = state.stands[static_cast<std::size_t>(stand)].alignment;
    if (!alignment || alignment->verdict != AlignmentVerdict::Failed || TakeReference{stand}.mayDo(state)) continue;
    const double shown = areaOf(stand);
    if (shown <= most) continue;
    most = shown;
    best = stand;
  }
  return best;
}

}  // namespace

double leastGain(const AcquisitionState& state) {
  if (state.plan) return state.plan->terminationThreshold;
  for (auto scan = state.scans.rbegin(); scan != state.scans.rend(); ++scan)
    if (scan->record.planAfter) return scan->record.planAfter->terminationThreshold;
  return 0.0;
}

StandCourse parseStandCourse(const std::string& text) {
  if (text == "auto") return {};
  int stands = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), stands);
  if (error != std::errc() || end != text.data() + text.size() || stands < 1 || stands > 1000)
    throw InvalidInput("stands \"" + text + "\" are neither auto nor a number from 1 to 1000");
  return {stands};
}

std::string name(const StandCourse& course) {
  return course.stands ? std::to_string(*course.stands) : "auto";
}

bool mayFindItsPlace(const AcquisitionState& state) {
  if (isOfObject(state, state.stand())) return false;
  return countScans(state, ScanStatus::In) >= kLeastViews && state.scans.back().status == ScanStatus::In;
}

bool hasUntriedStand(const AcquisitionState& state) {
  const std::vector<int> open = standsToAlign(state);
  return std::any_of(open.begin(), open.end(),
                     [&](int stand) { return state.stands[static_cast<std::size_t>(stand)].alignment == nullptr; });
}

bool alignStands(Acquisition& acquisition, bool keepFailures, const Progress& progress) {
  const int now = acquisition.state()->stand();
  std::vector<int> open;
  std::vector<int> failed;
  for (const int stand : standsToAlign(*acquisition.state()))
    (stand == now || !acquisition.state()->stands[static_cast<std::size_t>(stand)].alignment ? open : failed)
        .push_back(stand);
  while (!open.empty()) {
    const int stand = open.back();
    open.pop_back();
    const auto keep = [&](const AcquisitionState& after) { return keepFailures || isOfObject(after, stand); };
    acquisition.carryOutIf(AlignStand{stand}, keep, progress);
    if (const auto pose = anyPoseOf(*acquisition.state(), stand); pose && keepFailures)
      acquisition.carryOut(ChooseStandPose{stand, *pose}, progress);
    if (!isOfObject(*acquisition.state(), stand)) {
      failed.push_back(stand);
      continue;
    }
    // There is more of the object to fit them to.
    open.insert(open.begin(), failed.begin(), failed.end());
    failed.clear();
  }
  // Others may fit to what shows more of the object.
  if (const auto reference = betterReference(*acquisition.state()); reference && keepFailures) {
    acquisition.carryOut(TakeReference{*reference}, progress);
    return alignStands(acquisition, keepFailures, progress);
  }
  return isOfObject(*acquisition.state(), now);
}

bool findPlaces(Acquisition& acquisition, const Progress& progress) {
  const auto state = acquisition.state();
  const bool ended = state->termination != Termination::Running;
  if (ended ? !hasUntriedStand(*state) : !mayFindItsPlace(*state)) return false;
  static_cast<void>(alignStands(acquisition, ended, progress));
  return true;
}

std::optional<StandAdvice> nextStand(const AcquisitionState& state, const StandCourse& course,
                                     const Progress& progress) {
  if (state.termination == Termination::EndedByOperator || state.termination == Termination::Cancelled) return {};
  if (state.stand() + 1 >= course.stands.value_or(kMostStands)) return {};
  if (!course.stands && uselessInARow(state) >= kMostUseless) return {};
  const std::vector<StandAdvice> advice = adviseStands(state, progress);
  if (advice.empty()) return {};
  const StandAdvice& best = advice.front();
  if (!course.stands && (!best.isNew || best.gain <= leastGain(state))) return {};
  return best;
}

}  // namespace vantage
