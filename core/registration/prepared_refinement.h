#pragma once

#include <span>

#include "registration/multi_view.h"
#include "registration/view_network.h"

namespace vantage {

/// refineViews of views that are prepared already, one each. @throws as refineViews
[[nodiscard]] MultiViewResult refinePrepared(std::span<const View> views, std::span<const PreparedView> prepared,
                                             const MultiViewOptions& options, const Progress& progress);

}  // namespace vantage
