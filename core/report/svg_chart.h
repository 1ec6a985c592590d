#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vantage {

/// One column per value, drawn from zero up.
struct BarChart {
  std::string title;                ///< what is drawn and in which unit
  std::vector<double> values;       ///< not negative, finite
  std::optional<double> threshold;  ///< a dashed line at this value
  std::string thresholdName;
  std::optional<int> marked;  ///< index of the column that stands out
};

/// A line through one point per view.
struct LineChart {
  std::string title;
  std::vector<double> values;  ///< not negative, finite; the first belongs to view 1
};

/// Charts as inline SVG that takes its colours from the style sheet of the page (classes bar, marked, threshold, line,
/// axis). The same input gives the same bytes.
/// @throws InvalidInput for a value that is negative or not finite.
[[nodiscard]] std::string drawChart(const BarChart& chart);
[[nodiscard]] std::string drawChart(const LineChart& chart);

/// Text with what HTML reserves replaced.
[[nodiscard]] std::string escapedHtml(std::string_view text);

}  // namespace vantage
