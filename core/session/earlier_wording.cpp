#include "session/earlier_wording.h"

#include <array>
#include <charconv>
#include <utility>

namespace vantage {
namespace {

// The front of a text is taken off as it is understood.
bool take(std::string_view& text, std::string_view wanted) {
  if (!text.starts_with(wanted)) return false;
  text.remove_prefix(wanted.size());
  return true;
}

std::optional<double> takeNumber(std::string_view& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

struct Measured {
  VerdictReason reason;
  std::string_view before;
  std::string_view after;
  double unit;  // the number in the sentence is so many times what was measured
};

constexpr std::array<Measured, 7> kMeasured{
    {{VerdictReason::Inliers, "", " % of the expected overlap fits", 100.0},
     {VerdictReason::FewInliers, "only ", " % of the expected overlap fits", 100.0},
     {VerdictReason::FewPairs, "only ", " points overlap with the model", 1.0},
     {VerdictReason::Conflicts, "the scanner looked through ", " % of the model's surface", 100.0},
     {VerdictReason::Residual, "the surfaces differ ", " times as much as their noise explains", 1.0},
     {VerdictReason::Motion, "it moved ", " sigma away from where the mechanics put it", 1.0},
     {VerdictReason::Rival, "a pose ", " mm away fits as well", 1.0}}};

constexpr std::array<std::pair<std::string_view, VerdictReason>, 5> kPlain{
    {{"", VerdictReason::NotRegistered},
     {"the first view defines the frame", VerdictReason::FirstView},
     {"the first view is where the others go", VerdictReason::FirstImported},
     {"registered by an earlier version", VerdictReason::EarlierVersion},
     {"the pose had not come to rest when the iterations ran out", VerdictReason::NotSettled}}};

constexpr std::string_view kHeldBefore = "the surface ";
constexpr std::string_view kHeldAfter = ": that part of the pose is the mechanics' word alone";

std::optional<double> measuredIn(std::string_view sentence, const Measured& measured) {
  if (!take(sentence, measured.before)) return std::nullopt;
  const auto value = takeNumber(sentence);
  if (!value || sentence != measured.after) return std::nullopt;
  return *value / measured.unit;
}

std::optional<Vec3> takeAxis(std::string_view& text) {
  for (int k = 0; k < 3; ++k)
    if (take(text, std::string_view("xyz").substr(static_cast<std::size_t>(k), 1))) return Vec3::Unit(k);
  Vec3 axis;
  for (int k = 0; k < 3; ++k) {
    if (!take(text, k == 0 ? "(" : ", ")) return std::nullopt;
    const auto part = takeNumber(text);
    if (!part) return std::nullopt;
    axis[k] = *part;
  }
  if (!take(text, ")") || !axis.allFinite()) return std::nullopt;
  return axis;
}

std::optional<WeakMotion> takeMotion(std::string_view& text) {
  if (take(text, "moves freely")) return WeakMotion{};
  const bool slide = take(text, "slides along ");
  if (!slide && !take(text, "turns about ")) return std::nullopt;
  const auto axis = takeAxis(text);
  if (!axis) return std::nullopt;
  return WeakMotion{slide ? WeakMotion::Kind::Slide : WeakMotion::Kind::Turn, *axis};
}

}  // namespace

Finding findingFromEarlier(std::string_view sentence) {
  for (const auto& [text, reason] : kPlain)
    if (sentence == text) return {reason, std::nullopt, {}};
  for (const Measured& measured : kMeasured)
    if (const auto value = measuredIn(sentence, measured)) return {measured.reason, value, {}};
  if (sentence.starts_with(kHeldBefore) && sentence.ends_with(kHeldAfter)) {
    sentence.remove_prefix(kHeldBefore.size());
    sentence.remove_suffix(kHeldAfter.size());
    return {VerdictReason::HeldByMechanics, std::nullopt, weakMotionsFromEarlier(sentence)};
  }
  return {VerdictReason::EarlierVersion, std::nullopt, {}};
}

WeakMotions weakMotionsFromEarlier(std::string_view sentence) {
  WeakMotions motions;
  while (!sentence.empty()) {
    if (!motions.empty() && !take(sentence, " and ")) return {};
    const auto motion = takeMotion(sentence);
    if (!motion) return {};
    motions.push_back(*motion);
  }
  return motions;
}

std::optional<Phase> phaseFromEarlier(std::string_view step) {
  if (const auto phase = phaseNamed(step)) return phase;
  constexpr std::array<std::pair<std::string_view, Phase>, 5> kSteps{{{"Registering", Phase::Register},
                                                                      {"Refining all views", Phase::Register},
                                                                      {"Preparing the views", Phase::Register},
                                                                      {"zippering", Phase::Integrate},
                                                                      {"consensus", Phase::Integrate}}};
  for (const auto& [text, phase] : kSteps)
    if (step == text) return phase;
  return std::nullopt;
}

}  // namespace vantage
