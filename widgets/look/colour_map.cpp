#include "look/colour_map.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace vantage {
namespace {

constexpr std::array<Rgb, 11> kViridis{{{0x44, 0x01, 0x54},
                                        {0x48, 0x24, 0x75},
                                        {0x41, 0x44, 0x87},
                                        {0x35, 0x5F, 0x8D},
                                        {0x2A, 0x78, 0x8E},
                                        {0x21, 0x90, 0x8C},
                                        {0x22, 0xA8, 0x84},
                                        {0x44, 0xBF, 0x70},
                                        {0x7A, 0xD1, 0x51},
                                        {0xBD, 0xDF, 0x26},
                                        {0xFD, 0xE7, 0x25}}};
constexpr std::array<Rgb, 12> kCividis{{{0x00, 0x20, 0x4D},
                                        {0x00, 0x30, 0x6F},
                                        {0x2A, 0x40, 0x6C},
                                        {0x48, 0x52, 0x6B},
                                        {0x5E, 0x62, 0x6E},
                                        {0x72, 0x73, 0x74},
                                        {0x87, 0x84, 0x79},
                                        {0x9E, 0x96, 0x77},
                                        {0xB6, 0xA9, 0x71},
                                        {0xD0, 0xBE, 0x67},
                                        {0xEA, 0xD3, 0x57},
                                        {0xFF, 0xEA, 0x46}}};
constexpr std::array<Rgb, 8> kCategories{{{0x00, 0x72, 0xB2},
                                          {0xE6, 0x9F, 0x00},
                                          {0x00, 0x9E, 0x73},
                                          {0xCC, 0x79, 0xA7},
                                          {0x56, 0xB4, 0xE9},
                                          {0xD5, 0x5E, 0x00},
                                          {0xF0, 0xE4, 0x42},
                                          {0x8C, 0x8C, 0x8C}}};
constexpr std::array<Rgb, kEdgeClasses> kEdgeColours{{{0xD5, 0x5E, 0x00},     // outer jump
                                                      {0x00, 0x72, 0xB2},     // inner jump
                                                      {0xCC, 0x79, 0xA7},     // line of sight jump
                                                      {0x00, 0x9E, 0x73},     // regular
                                                      {0x8C, 0x8C, 0x8C}}};   // rim
constexpr std::array<Rgb, kPatchStates> kStateColours{{{0xE6, 0x9F, 0x00},    // open
                                                       {0xF0, 0xE4, 0x42},    // looked at
                                                       {0x8C, 0x8C, 0x8C},    // answered
                                                       {0x33, 0x5C, 0x81},    // out of reach
                                                       {0xCC, 0x79, 0xA7},    // too steep
                                                       {0x56, 0xB4, 0xE9},    // light blocked
                                                       {0x00, 0x9E, 0x73},    // receiver blocked
                                                       {0xC8, 0xB8, 0x8A},    // too little to gain
                                                       {0xD5, 0x5E, 0x00}}};  // erased

std::span<const Rgb> anchors(ColourMap map) {
  if (map == ColourMap::Viridis) return kViridis;
  return kCividis;
}

Rgb mixed(const Rgb& a, const Rgb& b, double share) {
  Rgb result{};
  for (std::size_t c = 0; c < 3; ++c) result[c] = static_cast<std::uint8_t>(std::lround(a[c] + share * (b[c] - a[c])));
  return result;
}

double linear(std::uint8_t channel) {
  const double v = channel / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

}  // namespace

Rgb colourAt(ColourMap map, double value) {
  const std::span<const Rgb> colours = anchors(map);
  const double position =
      (value > 0.0 ? std::min(value, 1.0) : 0.0) * static_cast<double>(colours.size() - 1);  // also for NaN
  const auto below = std::min(static_cast<std::size_t>(position), colours.size() - 2);
  return mixed(colours[below], colours[below + 1], position - static_cast<double>(below));
}

Rgb categoryColour(std::size_t index) {
  constexpr double kLighter = 0.4;
  constexpr std::size_t kShades = 3;
  const Rgb base = kCategories[index % kCategories.size()];
  const std::size_t shade = (index / kCategories.size()) % kShades;
  return mixed(base, {0xFF, 0xFF, 0xFF}, kLighter * static_cast<double>(shade) / (kShades - 1) * 1.5);
}

Rgb edgeClassColour(EdgeClass edgeClass) {
  return kEdgeColours[static_cast<std::size_t>(edgeClass)];
}

PatchState patchState(const PatchOutlook& outlook, PlanOutcome outcome) {
  if (outlook.reason == EdgeReason::Erased) return PatchState::Erased;
  if (outlook.answered) return PatchState::Answered;
  if (outcome != PlanOutcome::Found) {
    if (outlook.reason == EdgeReason::OutOfReach) return PatchState::OutOfReach;
    if (outlook.reason == EdgeReason::TooSteep) return PatchState::TooSteep;
    if (outlook.reason == EdgeReason::LightBlocked) return PatchState::LightBlocked;
    if (outlook.reason == EdgeReason::ReceiverBlocked) return PatchState::ReceiverBlocked;
    return PatchState::TooLittle;
  }
  return outlook.looks > 0 ? PatchState::LookedAt : PatchState::Open;
}

Rgb patchStateColour(PatchState state) {
  return kStateColours[static_cast<std::size_t>(state)];
}

double lightness(const Rgb& colour) {
  const double y = 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
  constexpr double kKnee = 216.0 / 24389.0;
  return y > kKnee ? 116.0 * std::cbrt(y) - 16.0 : y * 24389.0 / 27.0;
}

}  // namespace vantage
