#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/ray_caster.h"
#include "positional_space/cell_lookup.h"
#include "positional_space/positional_image.h"
#include "positional_space/scanner_images.h"

namespace vantage {

/// A cell of positional space that a source meets.
struct AimedCell {
  std::uint32_t cell = 0;
  float front =
      0.0F;  ///< [mm] (q - p) . n for the source p and the point q of the surface cell that it is seen through
  float square = 1.0F;  ///< [mm^2] |q - p|^2

  [[nodiscard]] float confidence() const { return std::min(front / std::sqrt(square), 1.0F); }  ///< c(o)
};

/// An observation ray and the cells of positional space that it is in: `count` entries of ObservationBatch::cells from
/// `first` on, all with receivers on the same side of the ray. Its line of sight is that of the first of them, the one
/// whose ranging ray it is collinear with.
struct Observation {
  std::uint32_t source = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// Observation rays in the order in which they are traced: rays[i] belongs to observations[i]. The direction of a ray
/// has the ray's length, which ends at far = 1.
struct ObservationBatch {
  std::vector<OcclusionRay> rays;
  std::vector<Observation> observations;
  std::vector<AimedCell> cells;

  void clear();
};

/// Lists the observation rays of sources (see `accumulate`). Works on one source at a time in buffers of its own: one
/// per thread.
class ObservationRays {
 public:
  /// @param scanner, lookup must outlive this.
  ObservationRays(const ScannerImages& scanner, const CellLookup& lookup, double breakdownAngle,
                  const AccumulationOptions& options);

  /// Appends the observation rays of a source. An observation ray is aimed at the point of the surface cell where it is
  /// collinear with a ranging ray; it counts if it leaves within the breakdown angle there.
  void append(const ObservationSource& source, std::uint32_t index, ObservationBatch& batch);

 private:
  // What differs between rows of surface cells; the cells of a row differ by a turn about z only.
  struct Rows {
    std::vector<float> axial;        // distance of the middles from the axis
    std::vector<float> z;            // of the middles
    std::vector<float> normalAxial;  // parts of the normal away from and along the axis
    std::vector<float> normalZ;
    std::vector<float> halfWidth;
    std::vector<float> halfHeight;
    std::vector<float> taper;
    std::vector<float> widest;  // half width anywhere
    std::vector<float> slack;   // by which rays aimed elsewhere in the cell can be nearer to the normal
    std::vector<float> low;     // bounds of the fans of all of the row's occupied cells
    std::vector<float> high;
    std::vector<std::int32_t> reached;  // by the source
  };
  struct Columns {
    std::vector<float> cosine;
    std::vector<float> sine;
    std::vector<float> along;              // of the source's centre, along the column's direction
    std::vector<float> aside;              // and sideways
    std::vector<float> normalAlong;        // of the source's normal
    std::vector<std::int32_t> keep;        // candidates of a row
    std::vector<std::uint32_t> inPeriod;   // column of the period that it repeats
    std::vector<std::uint32_t> firstCell;  // number of the first cell of positional space of its period
  };
  // Candidates of a row as the source p with normal n sees them: their middles q in the cell's frame, the slopes to
  // their sides and the steps of those in the lookup.
  struct Views {
    std::vector<float> ahead, across, up;
    std::vector<float> front;         // (q - p) . n
    std::vector<float> square;        // |q - p|^2
    std::vector<float> normalAcross;  // n . across
    std::vector<float> normalUp;      // n . up
    std::vector<float> low, high, lowUp, highUp;
    std::vector<std::int32_t> firstStep, lastStep, firstStepUp, lastStepUp;
  };
  struct Source {
    float px, py, pz;
    float nx, ny, nz;
    float ox, oy, oz;   // where its rays begin
    float axial;        // distance of the centre from the axis
    float normalAxial;  // part of the normal away from the axis
    float inward;       // centre . normal in the horizontal plane
    std::uint32_t index;
  };
  // Where in a surface cell an observation ray is collinear with the ranging ray of an occupied cell.
  struct Aim {
    std::uint32_t column;
    std::uint32_t cell;
    std::uint32_t side;
    float across, up;
    float front, square;  // as in AimedCell
  };
  void addRow(std::size_t row);
  void addColumns();
  void face(const ObservationSource& source, std::uint32_t index);
  void markRows();
  void markColumns(std::size_t row);
  void viewRun(std::size_t row, std::size_t begin, std::size_t end);
  void viewSteps(std::size_t row, std::size_t begin, std::size_t end);
  void appendRun(std::size_t row, std::size_t begin, std::size_t end, ObservationBatch& batch);
  void findSeen(std::size_t row, std::size_t begin, std::size_t end);
  void aim(std::size_t row);
  void emitAims(std::size_t row, std::span<Aim> aims, ObservationBatch& batch) const;
  [[nodiscard]] std::size_t emitTogether(std::size_t row, std::span<Aim> aims, ObservationBatch& batch) const;
  void emitRay(std::size_t row, std::size_t column, float across, float up, ObservationBatch& batch) const;

  const ScannerImages& scanner_;
  const CellLookup& lookup_;
  AccumulationOptions options_;
  float minCosine_;
  float together_;  // squared angle up to which occupied cells share an observation ray
  std::size_t columnsPerPeriod_;
  Rows rows_;
  Columns columns_;
  // Per surface cell: bounds of the fans of its occupied cells, and as CellLookup has them.
  std::vector<float> low_;
  std::vector<float> high_;
  std::vector<float> margin_;
  std::vector<std::int32_t> firstUp_;
  std::vector<std::int32_t> lastUp_;
  Source source_{};
  Views views_;
  // Of a run of candidates, by column; one is written beyond those that count.
  std::vector<SeenCell> seen_;
  std::size_t seenCount_ = 0;
  std::vector<Aim> aims_;
  std::size_t aimCount_ = 0;
};

}  // namespace vantage
