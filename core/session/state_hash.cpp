#include "session/state_hash.h"

#include "geometry/geometry_hash.h"

namespace vantage {
namespace {

void addMotions(ContentHash& hash, const WeakMotions& motions) {
  for (const WeakMotion& motion : motions) {
    hash.add(motion.kind);
    hash.add(std::as_bytes(std::span(motion.axis.data(), 3)));
  }
}

void addFinding(ContentHash& hash, const Finding& finding) {
  hash.add(finding.reason);
  hash.add(finding.value.has_value());
  hash.add(finding.value.value_or(0.0));
  addMotions(hash, finding.motions);
  if (!finding.rivals.empty()) hash.add(finding.rivals);
}

void addScore(ContentHash& hash, const PositionScore& score) {
  hash.add(score.position);
  hash.add(score.voidArea);
  hash.add(score.overlapArea);
  hash.add(score.tracedVoidArea.value_or(-1.0));
  hash.add(score.poseSigma.value_or(-1.0));
  addMotions(hash, score.weakMotions);
  hash.add(score.constraint);
  hash.add(score.shortBy);
  hash.add(score.patches);
  if (score.uncorrected) hash.add(*score.uncorrected);
}

void addForecast(ContentHash& hash, const PlanForecast& forecast) {
  hash.add(forecast.trust.factor);
  hash.add(forecast.trust.spread);
  hash.add(forecast.probing);
  if (!forecast.left) return;
  hash.add(forecast.left->area);
  hash.add(forecast.left->least);
  hash.add(forecast.left->most);
}

void addPlan(ContentHash& hash, const Plan& plan) {
  hash.add(plan.outcome);
  hash.add(plan.position.value_or(-1));
  hash.add(plan.leastOverlap);
  hash.add(plan.terminationThreshold);
  hash.add(plan.voidLeft);
  hash.add(plan.relaxations);
  if (plan.tableAlone) hash.add(plan.tableAlone);
  hash.add(plan.angularError);
  for (const PositionScore& score : plan.scores) addScore(hash, score);
  if (plan.forecast) addForecast(hash, *plan.forecast);
}

void addPatches(ContentHash& hash, const Plan& plan) {
  if (plan.voids) {
    for (const VoidPatch& p : plan.voids->patches) {
      hash.add(p.triangle);
      addPoint(hash, p.centre);
      hash.add(p.angle);
      hash.add(p.weight);
      hash.add(p.edgeClass);
    }
  }
  for (const PatchOutlook& o : plan.outlook) {
    hash.add(o.looks);
    hash.add(o.answered);
    hash.add(o.reason);
    hash.add(o.promise);
  }
}

void addRegistration(ContentHash& hash, const RegistrationResult& r) {
  addPose(hash, r.T_object_scanner);
  hash.add(r.verdict);
  addFinding(hash, r.finding);
  hash.add(r.rms);
  hash.add(r.inlierShare);
  hash.add(static_cast<std::uint64_t>(r.pairs));
  hash.add(r.iterations);
}

void addStation(ContentHash& hash, const Station& station) {
  hash.add(station.stand);
  hash.add(station.position.has_value());
  hash.add(station.position.value_or(0));
}

void addImage(ContentHash& hash, const RangeImage& image) {
  addStation(hash, image.station);
  hash.add(image.poseKnownBy);
  addPose(hash, image.T_table_scanner);
  hash.add(image.range);
  // What no scan of earlier versions had counts for nothing where it is not there.
  if (image.poseUncertainty) {
    hash.add(image.poseUncertainty->angleSigma);
    hash.add(image.poseUncertainty->positionSigma);
  }
  if (!image.colours.empty()) hash.add(image.colours);
}

void addReading(ContentHash& hash, const ScanReading& reading) {
  hash.add(reading.unit);
  hash.add(reading.unitKnownBy);
  hash.add(reading.sightKind);
  addPoint(hash, reading.sight);
  hash.add(reading.sightKnownBy);
  hash.add(reading.noSample);
  hash.add(static_cast<std::uint64_t>(reading.dropped));
  hash.add(reading.exchanged);
  hash.add(reading.placed);
  addPoint(hash, reading.offset);
  hash.add(reading.poseUnit);
  hash.add(reading.poseUnitKnownBy);
  hash.add(reading.up);
}

void addScan(ContentHash& hash, const KeptScan& scan) {
  const ScanRecord& record = scan.record;
  hash.add(scan.number);
  hash.add(scan.status);
  addPose(hash, scan.view.T_object_scanner);
  if (scan.view.image) addImage(hash, *scan.view.image);
  addRegistration(hash, record.registration);
  hash.add(record.newArea);
  hash.add(record.overlapArea);
  hash.add(record.predicted.has_value());
  if (record.predicted) addScore(hash, *record.predicted);
  if (record.reading) addReading(hash, *record.reading);
  hash.add(record.planAfter != nullptr);
  if (record.planAfter) addPlan(hash, *record.planAfter);
}

void addAlignment(ContentHash& hash, const StandAlignment& alignment) {
  hash.add(alignment.verdict);
  hash.add(alignment.reason);
  hash.add(alignment.value.has_value());
  hash.add(alignment.value.value_or(0.0));
  for (const StandPose& pose : alignment.candidates) {
    addPose(hash, pose.T_object_stand);
    for (const double number : {pose.overlap, pose.rms, pose.conflict, pose.table, pose.missing, pose.score})
      hash.add(number);
    hash.add(pose.possible);
  }
  hash.add(alignment.sameSurface);
  hash.add(alignment.picked);
  hash.add(alignment.used.value_or(-1));
  hash.add(alignment.choice);
}

// What no stand of earlier versions had counts for nothing where it is not there.
void addStand(ContentHash& hash, const Stand& stand) {
  hash.add(stand.T_object_table.has_value());
  if (stand.T_object_table) addPose(hash, *stand.T_object_table);
  if (stand.down) addPoint(hash, *stand.down);
  if (stand.reference != 0) hash.add(stand.reference);
  if (stand.alignment) addAlignment(hash, *stand.alignment);
  for (const ErasedRegion& erased : stand.erased) {
    hash.add(erased.number);
    addRegion(hash, erased.region->region());
  }
}

void addModel(ContentHash& hash, const Model& model) {
  hash.add(contentHash(model.mesh));
  hash.add(model.confidence);
  hash.add(model.vertexView);
  hash.add(model.vertexSample);
  hash.add(model.triangleView);
}

}  // namespace

std::uint64_t stateHash(const AcquisitionState& state) {
  ContentHash hash;
  hash.add(settingsHash(state.settings));
  hash.add(state.mode);
  hash.add(static_cast<std::uint64_t>(state.stands.size()));
  for (const Stand& stand : state.stands) addStand(hash, stand);
  for (const KeptScan& scan : state.scans) addScan(hash, scan);
  hash.add(state.plan != nullptr);
  if (state.plan) {
    addPlan(hash, *state.plan);
    addPatches(hash, *state.plan);
  }
  if (state.model) addModel(hash, *state.model);
  for (const ModelAside& aside : state.aside) {
    hash.add(aside.composite);
    addModel(hash, *aside.model);
  }
  hash.add(state.chosenPosition.has_value());
  hash.add(state.chosenPosition.value_or(0));
  hash.add(state.termination);
  return hash.value();
}

}  // namespace vantage
