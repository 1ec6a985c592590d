#include "session/table_note.h"

#include <cmath>
#include <memory>
#include <utility>

#include "acquisition/table_place.h"
#include "session/json_fields.h"

namespace vantage {
namespace {

constexpr const char* kNote = "table";

class RemarkedPositioner final : public Positioner {
 public:
  RemarkedPositioner(std::shared_ptr<Positioner> positioner, Session& session)
      : positioner_(std::move(positioner)), session_(session) {}

  [[nodiscard]] std::string identity() const override { return positioner_->identity(); }
  void open(const Progress& progress) override { positioner_->open(progress); }
  void close() noexcept override { positioner_->close(); }
  [[nodiscard]] std::optional<std::string> notReady() const override { return positioner_->notReady(); }
  void standsFarther(double angle) override { positioner_->standsFarther(angle); }
  [[nodiscard]] std::optional<ReachedPose> where() const override { return positioner_->where(); }

  [[nodiscard]] ReachedPose moveTo(int position, const Progress& progress) override {
    remark({{"under_way", true}, {"position", position}});
    try {
      const ReachedPose reached = positioner_->moveTo(position, progress);
      remarkPlace(reached);
      return reached;
    } catch (...) {
      if (const auto here = positioner_->where()) remarkPlace(*here);
      throw;
    }
  }

 private:
  void remarkPlace(const ReachedPose& pose) {
    const Pose& nominal = session_.profile()->workspace.poses[static_cast<std::size_t>(pose.position)];
    remark({{"under_way", false},
            {"position", pose.position},
            {"counted", turnAboutAxis(pose.T_table_scanner * nominal.inverse())}});
  }
  void remark(nlohmann::json note) {
    note["stand"] = session_.state()->stand();
    session_.setNote(kNote, note.dump());
  }

  std::shared_ptr<Positioner> positioner_;
  Session& session_;
};

}  // namespace

Rig remarked(Rig rig, Session& session) {
  rig.positioner = std::make_shared<RemarkedPositioner>(std::move(rig.positioner), session);
  return rig;
}

std::optional<TableLeft> tableLeft(const Session& session) {
  const auto known = tableStand(session);
  const std::string note = session.note(kNote);
  if (!known || note.empty()) return known ? std::optional(TableLeft{*known, {}}) : std::nullopt;
  const std::string what = session.path() + ": the remark of its table";
  const nlohmann::json json = jsonObject(note, what);
  const JsonFields fields(json, what);
  const auto positions = static_cast<std::int64_t>(session.profile()->workspace.size());
  const auto position = static_cast<int>(fields.integer("position", 0, positions - 1));
  if (fields.integer("stand") != session.state()->stand()) return TableLeft{*known, {}};
  if (fields.flag("under_way")) return TableLeft{*known, position};
  return TableLeft{{position, fields.number("counted"), known->farther}, {}};
}

}  // namespace vantage
