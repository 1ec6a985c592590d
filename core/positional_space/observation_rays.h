#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/ray_caster.h"
#include "positional_space/positional_image.h"
#include "positional_space/scanner_images.h"

namespace vantage {

/// An observation ray and the cells of positional space that it is in: `cellCount` numbers of ObservationBatch::cells
/// from `firstCell` on, all with receivers on the same side of the ray. Its line of sight is that of `nearest`, the
/// cell among them whose ranging ray it is nearest to.
struct Observation {
  std::uint32_t source = 0;
  std::uint32_t firstCell = 0;
  std::uint32_t cellCount = 0;
  std::uint32_t nearest = 0;
  float confidence = 0.0F;
};

/// Observation rays in the order in which they are traced: rays[i] belongs to observations[i]. The direction of a ray
/// has the ray's length, which ends at far = 1.
struct ObservationBatch {
  std::vector<OcclusionRay> rays;
  std::vector<Observation> observations;
  std::vector<std::uint32_t> cells;

  void clear();
};

/// Lists the observation rays of sources (see `accumulate`). Made once for many sources; may be used from any thread.
class ObservationRays {
 public:
  /// @param scanner must outlive this.
  ObservationRays(const ScannerImages& scanner, double breakdownAngle, const AccumulationOptions& options);

  /// Appends the observation rays of a source. An observation ray is aimed at the point of the surface cell where it is
  /// collinear with a ranging ray; it counts if it leaves within the breakdown angle there. Without pruning, the rays
  /// through the middles of the other surface cells are appended too, with no cells.
  void append(const ObservationSource& source, std::uint32_t index, ObservationBatch& batch) const;

  /// Surface cells (row-major) whose middle the source sees within the breakdown angle of its normal, ascending.
  [[nodiscard]] std::vector<std::uint32_t> candidates(const ObservationSource& source) const;

 private:
  // A row of surface cells: they differ by a turn about z only.
  struct Row {
    float axial = 0.0F;       // distance of the middles from the axis
    float z = 0.0F;           // of the middles
    float normalAxial = 1.0F; // parts of the normal away from and along the axis
    float normalZ = 0.0F;
    float halfWidth = 0.0F;
    float halfHeight = 0.0F;
    float slack = 0.0F;       // see addRow
  };
  struct SlopeRange {
    float low;
    float high;
  };
  // Slopes of the ranging rays that cross an occupied cell's surface cell: an observation ray can be in the occupied
  // cell when the slopes by which its source sees the surface cell overlap these.
  struct FanRange {
    SlopeRange across;
    SlopeRange up;
  };
  // The occupied cells of a surface cell are listed by steps of their slopes, `up` first.
  struct Lookup {
    int firstUp;  // steps of `up` in use
    int lastUp;
    float margin; // half the widest fan range of `up`
    std::uint32_t start;  // of its steps in lookup_
  };
  // Which surface cells are asked for: those whose middle is within the breakdown angle, those of which any point may
  // be, or those among the latter that have occupied cells to match.
  enum class Purpose { Middles, All, Pruned };
  struct View;
  struct Candidate;
  struct Match;

  void addRow(int row);
  void addFanRanges();
  void addSlopeRanges();
  void addLookup();
  void addSteps(std::uint32_t first, std::uint32_t last);
  template <typename Visit>
  void forCandidates(const View& view, Purpose purpose, const Visit& visit) const;
  [[nodiscard]] bool reaches(const View& view, std::size_t row, Purpose purpose) const;
  [[nodiscard]] Candidate candidate(const View& view, std::size_t row, std::size_t column) const;
  void match(const Candidate& c, std::vector<Match>& matches) const;
  void matchCell(const Candidate& c, std::uint32_t number, std::vector<Match>& matches) const;
  void emit(const View& view, const Candidate& c, std::uint32_t source, std::span<const Match> matches,
            ObservationBatch& batch) const;

  const ScannerImages& scanner_;
  AccumulationOptions options_;
  float minCosine_;
  float minRange_;
  float maxRange_;
  std::size_t columns_;
  std::size_t columnsPerPeriod_;
  std::vector<Row> rows_;
  std::vector<float> cosine_;  // per column
  std::vector<float> sine_;
  std::vector<float> low_;     // per surface cell
  std::vector<float> high_;
  std::vector<SlopeRange> rowRange_;
  std::vector<FanRange> fans_;      // per entry of order_
  std::vector<std::uint32_t> order_;  // occupied cells by surface cell, step of `up`, slope across
  std::vector<Lookup> lookups_;     // per stored surface cell
  // Per step of `up` and of `across` where in order_ those cells begin and end whose fan reaches into the step.
  std::vector<std::array<std::uint32_t, 2>> lookup_;
};

}  // namespace vantage
