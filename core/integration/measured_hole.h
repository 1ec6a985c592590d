#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "integration/model_editor.h"
#include "integration/testimony.h"

namespace vantage {

struct ClosedHoles {
  std::size_t count = 0;
  std::vector<std::uint32_t> vertices;  ///< of the model, around them
};

/// Closes holes that are none: openings between the views with triangles between the vertices around them, where views
/// have measured nine tenths of what lies between and have not looked through it. Judged on the surface of least area across
/// the opening. Where borders overlap instead of gaping, up to three rings of triangles along them are replaced, too.
/// An opening of three or four edges, no wider than a single square of samples, needs no witness but no view may look
/// through it. Openings of very many edges are left to the planner.
/// @pre no bow ties
/// @throws Cancelled
ClosedHoles closeMeasuredHoles(ModelEditor& editor, const Witnesses& witnesses, const ZipperOptions& options,
                               const Progress& progress = {});

}  // namespace vantage
