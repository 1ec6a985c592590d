#include "report/stands_report.h"

#include "acquisition/stand_composites.h"
#include "report/wording.h"

namespace vantage {
namespace {

using Json = nlohmann::ordered_json;

Json rotationJson(const Pose& T_object_table) {
  Json list = Json::array();
  const Eigen::Matrix3d R_table_object = T_object_table.linear().transpose();
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c < 3; ++c) list.push_back(R_table_object(r, c));
  return list;
}

Json poseJson(const Pose& pose) {
  Json list = Json::array();
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c < 4; ++c) list.push_back(pose.matrix()(r, c));
  return list;
}

Json candidateJson(const StandPose& pose, std::size_t index) {
  return {{"index", index},
          {"T_object_stand", poseJson(pose.T_object_stand)},
          {"overlap", pose.overlap},
          {"rms_mm", pose.rms},
          {"conflict", pose.conflict},
          {"table", pose.table},
          {"missing", pose.missing},
          {"score", pose.score},
          {"possible", pose.possible}};
}

}  // namespace

Json alignmentJson(const StandAlignment& alignment) {
  Json json{{"verdict", name(alignment.verdict)},
            {"reason", describe(alignment)},
            {"reason_code", name(alignment.reason)},
            {"same_surface", alignment.sameSurface},
            {"candidates", Json::array()}};
  for (const StandPose& pose : alignment.candidates)
    json["candidates"].push_back(candidateJson(pose, json["candidates"].size()));
  if (alignment.used) {
    json["used"] = *alignment.used;
    json["chosen_by"] = name(alignment.choice);
  }
  return json;
}

Json standsJson(const AcquisitionState& state) {
  const AcquisitionState object = withObject(state);
  Json stands = Json::array();
  for (int index = 0; index <= state.stand(); ++index) {
    const Stand& stand = state.stands[static_cast<std::size_t>(index)];
    const bool known = isOfObject(state, index);
    Json json{{"index", index},
              {"rotation", known ? rotationJson(*stand.T_object_table) : Json(nullptr)},
              {"views", Json::array()},
              {"scans", Json::array()}};
    std::size_t view = 0;
    for (const KeptScan& scan : object.scans) {
      const bool isIn = scan.status == ScanStatus::In;
      if (scan.station().stand == index) {
        json["scans"].push_back(scan.number);
        if (isIn) json["views"].push_back(view);
      }
      if (isIn) ++view;
    }
    if (index == referenceOf(state.stands)) {
      json["verdict"] = "reference";
      json["reason_code"] = index == 0 ? "first_stand" : "taken_as_reference";
      json["candidates"] = Json::array();
    } else if (stand.alignment) {
      json.update(alignmentJson(*stand.alignment));
    } else {
      json["verdict"] = known ? "good" : "failed";
      json["reason_code"] = known ? "placed_by_operator" : "not_aligned";
      json["candidates"] = Json::array();
    }
    if (stand.down) json["down"] = {stand.down->x(), stand.down->y(), stand.down->z()};
    stands.push_back(std::move(json));
  }
  return stands;
}

}  // namespace vantage
