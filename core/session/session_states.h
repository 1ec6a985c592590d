#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "acquisition/history.h"
#include "acquisition/step_options.h"
#include "base/progress.h"
#include "session/loss.h"
#include "session/session_store.h"

namespace vantage {

/// What a scan and its ray grid are called in the file; 0 is the profile's grid.
struct StoredScan {
  std::int64_t number = 0;
  std::int64_t rays = 0;
};

/// Builds the states of a session from the pieces in its file. A piece that somebody holds is handed out again, so that
/// states share what did not change; one that nobody holds is not in memory. What is damaged is left out and named.
class SessionStates {
 public:
  /// Both must outlive it.
  SessionStates(SessionStore& store, std::vector<Loss>& losses) : store_(store), losses_(losses) {}

  /// Null without a source. @throws InvalidInput when it is no profile
  [[nodiscard]] static std::shared_ptr<const ScannerProfile> parsed(const std::optional<ProfileSource>& source);

  /// Of the session: to be set before anything is asked for.
  void setProfile(std::shared_ptr<const ScannerProfile> profile) { profile_ = std::move(profile); }
  [[nodiscard]] const std::shared_ptr<const ScannerProfile>& profile() const { return profile_; }

  /// Of what takes long; nothing is heard of it once it is reset to Progress().
  void setProgress(const Progress& progress) { progress_ = progress; }

  /// Takes steps out of a history that name positions or stands which there are not.
  void dropImpossible(StoredHistory& history);

  /// The state after an entry of the history, held against its hash. A model that is not there, or not what it was, is
  /// made again from the steps before it.
  [[nodiscard]] AcquisitionState state(const History& history, const HistoryEntry& entry);

  /// @throws InvalidInput when there is none or it is damaged
  [[nodiscard]] std::shared_ptr<const RangeImage> scan(std::int64_t number);
  /// Null when it is not there, damaged or of more views.
  [[nodiscard]] std::shared_ptr<const Model> model(std::int64_t step, std::size_t views);
  [[nodiscard]] std::shared_ptr<const Plan> plan(std::int64_t step);

  /// Writes a scan. @throws InvalidInput for one of no position
  [[nodiscard]] StoredScan keep(const RangeImage& image);
  /// A scan that was written for good.
  void remember(const StoredScan& scan, const std::shared_ptr<const RangeImage>& image);

  /// What a state that follows another consists of, and which of it is new.
  [[nodiscard]] StateOutline outline(const AcquisitionState& state, const StateOutline& before, std::int64_t step);
  /// The pieces of a state that was just written.
  void remember(const StateOutline& outline, const AcquisitionState& state);

 private:
  /// What was made of a scan, for as long as somebody holds it.
  struct KnownUse {
    CutOptions cut;
    ThinningOptions thinning;
    std::weak_ptr<const RangeImage> image;
    UsedImage rest;  // its image is unset
  };
  struct KnownMesh {
    std::weak_ptr<const RangeImage> image;  // that it is of
    std::weak_ptr<const ViewMesh> mesh;
  };

  /// Whether scans can be of a position; of none they can always be.
  [[nodiscard]] bool exists(std::optional<int> position) const;
  [[nodiscard]] std::shared_ptr<const RayGrid> raysOf(std::int64_t id);
  [[nodiscard]] bool fits(const Plan& plan) const;
  [[nodiscard]] UsedImage used(std::int64_t scan, const ScanUse& use, const Progress& progress);
  /// Makes the images and meshes of the scans of a state that are not in memory, on all threads; as long as they are
  /// held, keptScan finds them. What is damaged is left to it.
  [[nodiscard]] std::vector<View> piecesOf(const StateOutline& outline, const StepOptions& options);
  [[nodiscard]] std::shared_ptr<const ViewMesh> meshOf(std::int64_t scan,
                                                       const std::shared_ptr<const RangeImage>& image,
                                                       const TriangulationOptions& triangulation);
  /// Nothing when the scan is lost.
  [[nodiscard]] std::optional<KeptScan> keptScan(const OutlinedScan& outlined, const StepOptions& options);
  static void findSteps(OutlinedScan& scan, bool planned, const StateOutline& before, std::int64_t step);
  [[nodiscard]] std::int64_t stepOf(const std::shared_ptr<const Model>& model, const StateOutline& before,
                                    std::int64_t step) const;
  /// @param step that made the model
  [[nodiscard]] std::shared_ptr<const Model> modelOf(const AcquisitionState& state, int composite,
                                                     const History& history, std::int64_t step);
  [[nodiscard]] std::shared_ptr<const Model> replayedModel(const std::vector<View>& views, int composite,
                                                           const History& history, std::int64_t step);
  [[nodiscard]] AcquisitionState assembled(const History& history, const HistoryEntry& entry);
  /// Nothing when the step cannot be carried out again.
  [[nodiscard]] std::optional<AcquisitionState> replayed(const AcquisitionState& state, const History& history,
                                                         const HistoryEntry& entry);
  void lose(Loss loss);

  SessionStore& store_;
  std::vector<Loss>& losses_;
  std::shared_ptr<const ScannerProfile> profile_;
  Progress progress_;
  std::map<std::int64_t, std::weak_ptr<const RangeImage>> scans_;
  std::map<std::int64_t, KnownUse> uses_;
  std::weak_ptr<const RayGrid> thinnedRays_;  // of the last scan that was thinned
  std::map<std::int64_t, KnownMesh> meshes_;
  std::map<std::int64_t, std::weak_ptr<const RayGrid>> rays_;
  std::map<std::int64_t, std::weak_ptr<const Model>> models_;
  std::map<std::int64_t, std::weak_ptr<const Plan>> plans_;
};

}  // namespace vantage
