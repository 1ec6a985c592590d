#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "layers/model_options.h"
#include "measuring/plane_section.h"

namespace vantage {

/// How a model is looked at, beside what is shown of it.
struct ViewTools {
  bool parallel = false;   ///< projected in parallel: what is far is as large as what is near
  bool measuring = false;  ///< clicks pick places to measure between
  std::vector<Vec3> measured;
  std::optional<PlaneSection> section;  ///< of the model, once it is computed
};

/// What is said in a view of its tools, a line for each that is on: nobody takes a model that is cut for one that ends.
[[nodiscard]] QStringList toolNotes(const ModelViewOptions& options, const ViewTools& tools);

/// The straight distance of two places, and its parts along the axes.
[[nodiscard]] QString distanceText(const Vec3& from, const Vec3& to);

/// "x ≤ 12.0 mm": what a cut leaves.
[[nodiscard]] QString sectionPlaceText(const Section& section);

/// Length and, where it is closed, area of the outline that a plane cuts.
[[nodiscard]] QString sectionText(const PlaneSection& section);

}  // namespace vantage
