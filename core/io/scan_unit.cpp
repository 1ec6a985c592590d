#include "io/scan_unit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vantage {
namespace {

// What scanners of objects do, as middle [mm] and spread [log].
struct Usual {
  double middle;
  double spread;
};
constexpr Usual kSize{150.0, 1.8};
constexpr Usual kPitch{0.6, 1.6};
constexpr Usual kDistance{500.0, 1.2};
constexpr double kUsualFormat = 3.0;  // how much a format counts [log]
constexpr double kClearly = 2.0;

// With equal units the scans must lie farther apart than their size, and another ratio bring them so much nearer.
constexpr double kBetter = 0.3;
constexpr double kNear = 1.6;

double logLikelihood(const Usual& usual, double value) {
  const double off = std::log(std::max(value, 1e-300) / usual.middle) / usual.spread;
  return -0.5 * off * off;
}

double scoreOf(const UnitEvidence& evidence, LengthUnit unit) {
  const double mm = millimetresIn(unit);
  double score = logLikelihood(kSize, mm * evidence.size) + logLikelihood(kPitch, mm * evidence.pitch);
  if (evidence.distance) score += logLikelihood(kDistance, mm * *evidence.distance);
  if (evidence.usuallyMetres && unit == LengthUnit::Metre) score += kUsualFormat;
  return score;
}

// Twice the mean squared distance of the scans' middles from each other, as a + 2 b r + c r^2 of the ratio r.
struct Scatter {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;

  [[nodiscard]] double at(double r) const { return a + 2.0 * b * r + c * r * r; }
};

Scatter scatterOf(const std::vector<Vec3>& middles, const std::vector<Pose>& poses) {
  Vec3 turnedMean = Vec3::Zero();
  Vec3 movedMean = Vec3::Zero();
  const auto count = static_cast<double>(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    turnedMean += poses[i].linear() * middles[i] / count;
    movedMean += poses[i].translation() / count;
  }
  Scatter scatter;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vec3 turned = poses[i].linear() * middles[i] - turnedMean;
    const Vec3 moved = poses[i].translation() - movedMean;
    scatter.a += turned.squaredNorm() / count;
    scatter.b += turned.dot(moved) / count;
    scatter.c += moved.squaredNorm() / count;
  }
  return scatter;
}

}  // namespace

UnitGuess guessUnit(const UnitEvidence& evidence) {
  const double millimetre = scoreOf(evidence, LengthUnit::Millimetre);
  const double metre = scoreOf(evidence, LengthUnit::Metre);
  return {metre > millimetre ? LengthUnit::Metre : LengthUnit::Millimetre, std::abs(metre - millimetre) >= kClearly};
}

double poseUnitRatio(const std::vector<Vec3>& middles, const std::vector<Pose>& poses, double size) {
  if (poses.size() < 2) return 1.0;
  const Scatter scatter = scatterOf(middles, poses);
  if (!(scatter.c > 0.0) || !(-scatter.b > 0.0)) return 1.0;
  const double best = -scatter.b / scatter.c;
  double ratio = 1.0;
  for (const LengthUnit of : kLengthUnits)
    for (const LengthUnit in : kLengthUnits) {
      const double other = millimetresIn(of) / millimetresIn(in);
      if (std::abs(std::log(other / best)) < std::abs(std::log(ratio / best))) ratio = other;
    }
  const bool near = std::abs(std::log(ratio / best)) < std::log(kNear);
  const bool apart = scatter.at(1.0) > size * size;
  return near && apart && scatter.at(ratio) < kBetter * scatter.at(1.0) ? ratio : 1.0;
}

}  // namespace vantage
