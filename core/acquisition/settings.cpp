#include "acquisition/settings.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "acquisition/setting_lookup.h"
#include "acquisition/settings_table.h"
#include "base/content_hash.h"
#include "base/errors.h"

namespace vantage {
namespace {

// Settings of which the first must not exceed the second.
using Ascending = std::array<std::string_view, 2>;
constexpr std::array<Ascending, 10> kAscending{{{"registration.final_gate", "registration.coarse_gate"},
                                                {"registration.final_angle", "registration.coarse_angle"},
                                                {"registration.coarse_points", "registration.fine_points"},
                                                {"verdict.min_pairs", "verdict.few_pairs"},
                                                {"verdict.min_inlier_share", "verdict.low_inlier_share"},
                                                {"verdict.doubtful_conflicts", "verdict.max_conflicts"},
                                                {"verdict.doubtful_residual", "verdict.max_residual"},
                                                {"verdict.doubtful_motion", "verdict.max_motion"},
                                                {"refinement.final_gate", "refinement.coarse_gate"},
                                                {"refinement.coarse_points", "refinement.fine_points"}}};

// Settings that an acquisition keeps once it has scans.
constexpr std::array<std::string_view, 13> kLasting{"simulation.object",
                                                    "simulation.placement",
                                                    "simulation.unit",
                                                    "cut.volume",
                                                    "cut.table_margin",
                                                    "cut.radius_margin",
                                                    "cut.flying_pixels",
                                                    "cut.flying_jump",
                                                    "cut.isolated",
                                                    "cut.smallest_island",
                                                    "triangulation.spacing",
                                                    "triangulation.angle_slack",
                                                    "triangulation.discontinuity_factor"};

// Nothing for what is left to the program.
std::optional<double> magnitudeOf(const SettingValue& value) {
  if (const auto* whole = std::get_if<std::uint64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::nullopt;
}

const Ascending* contradictionIn(const AcquisitionSettings& settings) {
  const auto magnitude = [&](std::string_view key) { return magnitudeOf(valueOf(settingField(key), settings)); };
  for (const Ascending& pair : kAscending)
    if (const auto least = magnitude(pair[0]), most = magnitude(pair[1]); least && most && *least > *most) return &pair;
  return nullptr;
}

const SettingField* lastingChange(const AcquisitionSettings& before, const AcquisitionSettings& after) {
  for (const std::string_view key : kLasting) {
    const SettingField& field = settingField(key);
    if (field.get(before) != field.get(after)) return &field;
  }
  return nullptr;
}

}  // namespace

Strategy parseStrategy(std::string_view text) {
  if (text == "ps") return {};
  if (text == "random") return {Strategy::Kind::Random, 0};
  constexpr std::string_view kUniform = "uniform:";
  if (text.starts_with(kUniform)) {
    Strategy strategy{Strategy::Kind::Uniform, 0};
    const std::string_view count = text.substr(kUniform.size());
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), strategy.uniformViews);
    if (error == std::errc() && end == count.data() + count.size() && strategy.uniformViews >= 1) return strategy;
  }
  throw InvalidInput("strategy is '" + std::string(text) + "', expected ps, uniform:N with N >= 1, or random");
}

std::string name(const Strategy& strategy) {
  switch (strategy.kind) {
    case Strategy::Kind::PositionalSpace:
      return "ps";
    case Strategy::Kind::Uniform:
      return "uniform:" + std::to_string(strategy.uniformViews);
    case Strategy::Kind::Random:
      return "random";
  }
  return "";
}

AcquisitionSettings settingsBefore() {
  AcquisitionSettings settings;
  for (const SettingField& field : settingFields()) setText(field, settings, field.before);
  return settings;
}

bool agree(const AcquisitionSettings& settings) {
  return contradictionIn(settings) == nullptr;
}

void checkSettings(const AcquisitionSettings& settings) {
  const Ascending* contradiction = contradictionIn(settings);
  if (contradiction == nullptr) return;
  const auto& [smaller, larger] = *contradiction;
  throw InvalidInput(std::string(smaller) + " is " + textOf(settingField(smaller), settings) +
                     ", expected no more than " + std::string(larger) + ", which is " +
                     textOf(settingField(larger), settings));
}

bool mayFollow(const AcquisitionSettings& before, const AcquisitionSettings& after) {
  return lastingChange(before, after) == nullptr;
}

void checkChange(const AcquisitionSettings& before, const AcquisitionSettings& after) {
  const SettingField* changed = lastingChange(before, after);
  if (changed == nullptr) return;
  throw InvalidInput(std::string(changed->key) + " is " + textOf(*changed, after) + ", expected " +
                     textOf(*changed, before) + " as the session was begun");
}

bool operator==(const AcquisitionSettings& a, const AcquisitionSettings& b) {
  const auto fields = settingFields();
  return std::all_of(fields.begin(), fields.end(), [&](const SettingField& f) { return f.get(a) == f.get(b); });
}

std::uint64_t settingsHash(const AcquisitionSettings& settings) {
  ContentHash hash;
  for (const SettingField& field : settingFields()) {
    const std::string text = textOf(field, settings);
    if (text == field.before) continue;
    hash.add(field.key);
    hash.add(text);
  }
  return hash.value();
}

}  // namespace vantage
