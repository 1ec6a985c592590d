#include "report/svg_chart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr double kWidth = 640.0;
constexpr double kHeight = 180.0;
constexpr double kLeft = 70.0;    // room for the values of the axis
constexpr double kBottom = 24.0;  // and for the numbers below it
constexpr double kTop = 12.0;

std::string decimal(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string place(double value) {
  return decimal(value, 1);
}

void check(const std::vector<double>& values, const std::string& title) {
  for (const double value : values)
    if (!std::isfinite(value) || value < 0.0)
      throw InvalidInput("chart '" + title + "': the value " + std::to_string(value) +
                         " cannot be drawn, expected 0 or more");
}

// A round number that is no less than the value, and not much more.
double roundedUp(double value) {
  if (value <= 0.0) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 1.2, 1.6, 2.0, 2.4, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (factor * power >= value) return factor * power;
  return 10.0 * power;
}

// The frame that both charts share: axis, numbers and the place of a value in the picture.
class Frame {
 public:
  Frame(double largest, std::size_t count) : top_(roundedUp(largest)), count_(std::max<std::size_t>(1, count)) {}

  [[nodiscard]] double step() const { return (kWidth - kLeft - 8.0) / static_cast<double>(count_); }
  [[nodiscard]] double x(double index) const { return kLeft + index * step(); }
  [[nodiscard]] double y(double value) const { return kHeight - kBottom - value / top_ * (kHeight - kBottom - kTop); }

  [[nodiscard]] std::string open(const std::string& title) const {
    std::string svg = "<svg viewBox=\"0 0 " + decimal(kWidth, 0) + " " + decimal(kHeight, 0) +
                      "\" role=\"img\" aria-label=\"" + escapedHtml(title) + "\"><title>" + escapedHtml(title) +
                      "</title>\n";
    for (const double share : {0.0, 0.5, 1.0}) {
      const std::string at = place(y(share * top_));
      svg += "<line class=\"axis\" x1=\"" + place(kLeft) + "\" x2=\"" + place(kWidth - 8.0) + "\" y1=\"" + at +
             "\" y2=\"" + at + "\"/><text x=\"" + place(kLeft - 6.0) + "\" y=\"" + place(y(share * top_) + 4.0) +
             "\" text-anchor=\"end\">" + decimal(share * top_, top_ < 10.0 ? 1 : 0) + "</text>\n";
    }
    return svg;
  }

  // Numbers under the axis, at most about a dozen.
  [[nodiscard]] std::string numbers(int first) const {
    const std::size_t every = std::max<std::size_t>(1, count_ / 12);
    std::string svg;
    for (std::size_t i = 0; i < count_; i += every)
      svg += "<text x=\"" + place(x(static_cast<double>(i) + 0.5)) + "\" y=\"" + place(kHeight - 7.0) +
             "\" text-anchor=\"middle\">" + std::to_string(static_cast<int>(i) + first) + "</text>";
    return svg + "\n";
  }

 private:
  double top_;
  std::size_t count_;
};

}  // namespace

std::string drawChart(const BarChart& chart) {
  check(chart.values, chart.title);
  double largest = chart.threshold.value_or(0.0);
  for (const double value : chart.values) largest = std::max(largest, value);
  const Frame frame(largest, chart.values.size());
  std::string svg = frame.open(chart.title);
  for (std::size_t i = 0; i < chart.values.size(); ++i) {
    const double top = frame.y(chart.values[i]);
    svg += std::string("<rect class=\"") + (static_cast<int>(i) == chart.marked ? "marked" : "bar") + "\" x=\"" +
           place(frame.x(static_cast<double>(i))) + "\" y=\"" + place(top) + "\" width=\"" +
           place(std::max(1.0, frame.step() - 1.0)) + "\" height=\"" + place(frame.y(0.0) - top) + "\"/>";
  }
  if (chart.threshold) {
    const std::string at = place(frame.y(*chart.threshold));
    svg += "<line class=\"threshold\" x1=\"" + place(kLeft) + "\" x2=\"" + place(kWidth - 8.0) + "\" y1=\"" + at +
           "\" y2=\"" + at + "\"/><text x=\"" + place(kWidth - 10.0) + "\" y=\"" +
           place(frame.y(*chart.threshold) - 4.0) + "\" text-anchor=\"end\">" + escapedHtml(chart.thresholdName) +
           "</text>";
  }
  return svg + frame.numbers(0) + "</svg>\n";
}

std::string drawChart(const LineChart& chart) {
  check(chart.values, chart.title);
  const double largest = chart.values.empty() ? 0.0 : *std::max_element(chart.values.begin(), chart.values.end());
  const Frame frame(largest, chart.values.size());
  std::string points;
  std::string dots;
  for (std::size_t i = 0; i < chart.values.size(); ++i) {
    const std::string x = place(frame.x(static_cast<double>(i) + 0.5));
    const std::string y = place(frame.y(chart.values[i]));
    points += x + "," + y + " ";
    dots += "<circle class=\"marked\" cx=\"" + x + "\" cy=\"" + y + "\" r=\"3\"/>";
  }
  return frame.open(chart.title) + "<polyline class=\"line\" points=\"" + points + "\"/>" + dots + frame.numbers(1) +
         "</svg>\n";
}

std::string escapedHtml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace vantage
