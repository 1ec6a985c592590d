#include "report/reading_words.h"

#include <cmath>
#include <string>
#include <utility>

namespace vantage {
namespace {

Phrase why(KnownBy knownBy) {
  switch (knownBy) {
    case KnownBy::Default:
      return words("assumed");
    case KnownBy::Evidence:
      return words("told by the numbers");
    case KnownBy::File:
      return words("as the file says");
    case KnownBy::Operator:
      break;
  }
  return words("as given");
}

Phrase directionPhrase(const Vec3& direction) {
  for (int k = 0; k < 3; ++k)
    if (std::abs(direction[k]) == 1.0)
      return asIs(std::string(direction[k] > 0.0 ? "+" : "-") + std::string(1, "xyz"[k]));
  return words("(%1, %2, %3)", {figure(direction.x(), 2), figure(direction.y(), 2), figure(direction.z(), 2)});
}

Phrase sightPhrase(const ScanReading& reading) {
  switch (reading.sightKind) {
    case SightKind::Grid:
      return words("the scanner looks along %1 (%2)", {directionPhrase(reading.sight), why(reading.sightKnownBy)});
    case SightKind::Point:
      return words("measured from one point in all directions (%1)", {why(reading.sightKnownBy)});
    case SightKind::Turntable:
      return words("the columns go around an axis, like a cylinder (%1)", {why(reading.sightKnownBy)});
    case SightKind::Profile:
      break;
  }
  return words("the rays are those of the profile");
}

Phrase markPhrase(const ScanReading& reading) {
  const Phrase cells = asIs(std::to_string(reading.dropped));
  switch (reading.noSample) {
    case NoSampleMark::Given:
      return words("%1 cells with the value given for no sample left out", {cells});
    case NoSampleMark::Zero:
      return words("%1 cells with the point (0, 0, 0) left out as no samples", {cells});
    case NoSampleMark::Repeated:
      return words("%1 cells with one and the same point left out as no samples", {cells});
    case NoSampleMark::FarPlane:
      return words("%1 cells at one constant depth left out as no samples", {cells});
    case NoSampleMark::Outlier:
    case NoSampleMark::None:
      break;
  }
  return words("%1 cells out of all proportion left out", {cells});
}

void add(Phrase& phrase, Phrase more) {
  phrase = words("%1, %2", {std::move(phrase), std::move(more)});
}

void addPoses(Phrase& phrase, const ScanReading& reading) {
  if (reading.placed) add(phrase, words("the points are in the object's coordinates already, no pose is applied"));
  if (reading.poseUnit != reading.unit)
    add(phrase, words("the poses have another unit: 1 = %1 mm (%2)",
                      {figure(reading.poseUnit, 3), why(reading.poseUnitKnownBy)}));
  if (reading.up != Axis::Z) add(phrase, words("%1 is up", {asIs(std::string(name(reading.up)))}));
  if (reading.up == Axis::Z && reading.turnsAbout && *reading.turnsAbout != Axis::Z)
    add(phrase,
        words("z is taken for up although the poses turn about %1", {asIs(std::string(name(*reading.turnsAbout)))}));
}

}  // namespace

Phrase phraseOf(const ScanReading& reading) {
  Phrase phrase = words("1 unit = %1 mm (%2)", {figure(reading.unit, 3), why(reading.unitKnownBy)});
  add(phrase, sightPhrase(reading));
  if (reading.dropped > 0) add(phrase, markPhrase(reading));
  if (reading.exchanged) add(phrase, words("rows and columns are exchanged"));
  addPoses(phrase, reading);
  if (!reading.offset.isZero(0.0))
    add(phrase, words("an offset of (%1, %2, %3) mm was taken off",
                      {figure(reading.offset.x()), figure(reading.offset.y()), figure(reading.offset.z())}));
  return phrase;
}

}  // namespace vantage
