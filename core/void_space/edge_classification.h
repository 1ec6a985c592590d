#pragma once

#include "geometry/ray_caster.h"
#include "void_space/edge_frame.h"
#include "void_space/free_space_map.h"
#include "void_space/ray_index.h"
#include "void_space/void_patch.h"

namespace vantage {

struct ClassificationOptions {
  double breakdownAngle = radians(60.0);  ///< theta_b [rad]
  /// Surface beside an edge lies farther or nearer, instead of going on, when its depth differs from that of the edge
  /// by more than this many times spacing * tan(theta_b), the most that a sampled surface falls off from ray to
  /// ray. 1.5 leaves room for noise and agrees with the discontinuities of triangulate().
  double jumpFactor = 1.5;
  /// How many spacings beside an edge its shadow may begin: the outermost, steep part of what hides the place from the
  /// scanner or the receiver was not sampled itself and leaves a gap.
  int shadowReach = 4;
};

/// What one ranging ray says about an edge.
struct EdgeVerdict {
  EdgeClass edgeClass = EdgeClass::Regular;
  double rho = 0.0;  ///< angle of the ray about the edge, toward the scanner [rad]
  FreeSpaceMap freeSpace;
};

/// Classifies boundary edges of a partial model by ranging rays (Pito 1999, 4.3.1). Const, any number of threads.
class EdgeClassifier {
 public:
  /// @param model the partial model; it and the rays must outlive the classifier.
  EdgeClassifier(const RayCaster& model, const RayIndex& rays, const ClassificationOptions& options);

  /// The verdict of a ray r that passes the middle of e, from its neighbour r': the ray of the same view that passes e
  /// one local sample spacing farther on, perpendicular to e and r, on the side that is still unseen (angle rho +
  /// pi/2). For rays that share an origin, or turn about one, the paper's distance between origins says nothing; the
  /// spacing at the edge is what it stands for.
  ///
  /// What the view measured along r' counts first, for that is known even where the model lost its triangles; then what
  /// r' meets in the model. Surface within the jump depth of e goes on from it (regular, free up to it). Nearer: inner
  /// jump. Farther: outer jump, if the view sampled it there; if not, something hid it. Nothing: farther on, up to
  /// the shadow's reach or the view's next sample, it is an inner jump if that sample is nearer, a line-of-sight jump
  /// if the model hides a place from every receiver, whichever comes first; regular if neither. r' outside of the ray
  /// grid: rim.
  ///
  /// @param sampledEdge r is the ray that sampled e_T.
  [[nodiscard]] EdgeVerdict classify(const EdgeFrame& e, const RayPassage& r, bool sampledEdge) const;

  /// Whether an endpoint of e is visible by r: neither the model between it and the source or every receiver (leaving
  /// out one sample spacing at e), nor anything nearer that the view measured there. A ray so close to the direction of
  /// e that no surface through e could have been sampled by it does not count.
  [[nodiscard]] bool sees(const EdgeFrame& e, const RayPassage& r) const;

  /// Whether the view of r measured e itself: r meets e_T from the front and its sample is within the jump depth of e.
  [[nodiscard]] bool measured(const EdgeFrame& e, const RayPassage& r) const;

 private:
  enum class Beside { Nothing, Nearer, GoesOn, Farther };
  struct Meeting {
    Beside beside = Beside::Nothing;
    double depth = 0.0;  ///< behind e along r' [mm]
  };

  [[nodiscard]] Meeting follow(const RayPassage& neighbour) const;
  [[nodiscard]] EdgeClass shadow(const EdgeFrame& e, RayPassage neighbour, const Vec3& step,
                                 const std::vector<Vec3>& receivers) const;
  [[nodiscard]] Beside compare(double depth, const RayPassage& neighbour) const;
  [[nodiscard]] bool visible(const Vec3& p, const RayPassage& r, const std::vector<Vec3>& receivers) const;
  [[nodiscard]] bool seenByReceiver(const Vec3& p, const std::vector<Vec3>& receivers, double margin) const;
  [[nodiscard]] double lineOfSightAngle(const EdgeFrame& e, const RayPassage& r,
                                        const std::vector<Vec3>& receivers) const;
  [[nodiscard]] double breakdownAbout(const EdgeFrame& e, const RayPassage& r, bool sampledEdge) const;

  const RayCaster& model_;
  const RayIndex& rays_;
  ClassificationOptions options_;
};

}  // namespace vantage
