#include "io/text_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/errors.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

constexpr std::size_t kPerCheckpoint = 65536;
constexpr std::size_t kMostFields = 16;
constexpr int kWordLines = 20;
constexpr double kMissing = -9999.0;

// How the numbers of a file are written.
struct Notation {
  bool commaDivides = false;  // else it is a decimal sign
};

// The numbers of a line.
struct Line {
  std::array<double, kMostFields> values{};
  std::size_t count = 0;
  bool words = false;        // holds something that is no number
  bool wholes = true;        // all are whole numbers
  std::size_t decimals = 0;  // behind the decimal sign of the last number
};

bool isDivider(char c, const Notation& notation) {
  return c == ' ' || c == '\t' || c == ';' || (notation.commaDivides && c == ',');
}

std::string_view takeField(std::string_view& line, const Notation& notation) {
  std::size_t begin = 0;
  while (begin < line.size() && isDivider(line[begin], notation)) ++begin;
  std::size_t end = begin;
  while (end < line.size() && !isDivider(line[end], notation)) ++end;
  std::string_view field = line.substr(begin, end - begin);
  line.remove_prefix(end);
  while (field.ends_with(',')) field.remove_suffix(1);  // "1.5, 2.5"
  return field;
}

// A comma divides where it must: fields of a line without other dividers.
Notation notationOf(std::string_view line) {
  Notation notation;
  std::string_view rest = line;
  const std::string_view first = takeField(rest, notation);
  notation.commaDivides = std::count(first.begin(), first.end(), ',') >= 2;
  return notation;
}

Line parseLine(std::string_view text, const Notation& notation) {
  Line line;
  for (std::string_view field = takeField(text, notation); !field.empty() && line.count < kMostFields;
       field = takeField(text, notation)) {
    const auto value = parseDecimal(field);
    if (!value) {
      line.words = true;
      return line;
    }
    const std::size_t sign = field.find_first_of(".,");
    line.decimals = sign == std::string_view::npos ? 0 : field.size() - sign - 1;
    line.wholes &= sign == std::string_view::npos && *value == std::floor(*value);
    line.values[line.count++] = *value;
  }
  return line;
}

bool isComment(std::string_view line) {
  return line.empty() || line.starts_with('#') || line.starts_with("//");
}

bool areColours(const Line& line, std::size_t first) {
  for (std::size_t k = first; k < first + 3; ++k)
    if (line.values[k] < 0.0 || line.values[k] > 255.0 || line.values[k] != std::floor(line.values[k])) return false;
  return true;
}

// Reads a file line by line.
class TextPointsReader {
 public:
  TextPointsReader(const FileBytes& file, const Progress& progress)
      : file_(file), progress_(progress), text_(file.text(), file.path()) {}

  GridFile read(const std::optional<GridSize>& said) {
    while (readLine()) {
    }
    requireWhole();
    GridFile file;
    std::optional<GridSize> size = said;
    if (said && said->rows * said->columns != points_.size())
      throw InvalidInput(file_.path() + ": has " + std::to_string(points_.size()) + " points, expected " +
                         std::to_string(said->rows) + " x " + std::to_string(said->columns) + " as --grid says");
    if (!size && headCount_ == 2) size = sizeInHead();
    if (!size && headCount_ != 2) size = recogniseGrid(points_);
    file.organised = size.has_value();
    if (!size) {
      file.samples = scatteredPoints(std::move(points_), colours());
      return file;
    }
    std::vector<Colour> kept = colours();
    file.samples = gridOf(size->rows, size->columns, std::move(points_), file_.path());
    file.samples.colours = std::move(kept);
    return file;
  }

 private:
  bool readLine() {
    std::string_view rest = text_.restOfLine();
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    while (rest.ends_with(' ') || rest.ends_with('\t')) rest.remove_suffix(1);
    if (!isComment(rest)) take(rest);
    return text_.nextLine();
  }

  void take(std::string_view rest) {
    if (points_.empty() && headCount_ == 0) notation_ = notationOf(rest);
    const Line line = parseLine(rest, notation_);
    if (line.words && points_.empty() && headCount_ == 0 && wordLines_++ < kWordLines) return;
    if (!line.words && line.count < 3 && line.wholes && points_.empty() && headCount_ == 0) {
      head_ = {line.values[0], line.values[1]};
      headCount_ = line.count;
      return;
    }
    if (line.words || line.count < 3)
      text_.fail("has " + inQuotes(rest) + ", expected the three coordinates of a point" +
                 (line.words ? "" : ": the file may have ended early"));
    takePoint(line);
  }

  void takePoint(const Line& line) {
    if (points_.size() == kMaxGridCells) text_.fail("has more points than a range file can have");
    if (points_.size() % kPerCheckpoint == 0) progress_.checkpoint(0.5);
    Vec3 p(line.values[0], line.values[1], line.values[2]);
    if (p == Vec3::Constant(kMissing)) p = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    if (points_.empty()) colourAt_ = line.count >= 7 ? 4 : line.count == 6 ? 3 : 0;
    if (colourAt_ > 0 && (line.count < colourAt_ + 3 || !areColours(line, colourAt_))) colourAt_ = 0;
    if (colourAt_ > 0) {
      Colour colour{};
      for (std::size_t k = 0; k < 3; ++k) colour[k] = static_cast<std::uint8_t>(line.values[colourAt_ + k]);
      colours_.push_back(colour);
    }
    points_.push_back(p);
    leastDecimals_ = std::min(leastDecimals_, decimals_);
    decimals_ = line.decimals;
  }

  // Normals are no colours, and not all of them are whole numbers above 1.
  std::vector<Colour> colours() {
    const bool lit = std::any_of(colours_.begin(), colours_.end(),
                                 [](const Colour& c) { return *std::max_element(c.begin(), c.end()) > 1; });
    if (colours_.size() != points_.size() || !lit) return {};
    return std::move(colours_);
  }

  // A program that is interrupted leaves a piece of a line.
  void requireWhole() const {
    const std::size_t expected = headCount_ == 2   ? static_cast<std::size_t>(std::max(0.0, head_[0] * head_[1]))
                                 : headCount_ == 1 ? static_cast<std::size_t>(std::max(0.0, head_[0]))
                                                   : points_.size();
    if (points_.size() != expected)
      throw InvalidInput(file_.path() + ": has " + std::to_string(points_.size()) +
                         " points, but says that there are " + std::to_string(expected) +
                         (points_.size() < expected ? ": it ends early, wait until it is whole or save it again" : ""));
    const bool ended = file_.text().ends_with('\n') || file_.text().ends_with('\r');
    if (headCount_ == 0 && !ended && points_.size() > 1 && decimals_ < leastDecimals_)
      throw InvalidInput(file_.path() +
                         ": ends within a number: it ends early, wait until it is whole or save it again");
  }

  // Columns and rows, or rows and columns: whichever puts neighbours beside each other.
  [[nodiscard]] GridSize sizeInHead() const {
    const auto a = static_cast<std::size_t>(head_[0]);
    const auto b = static_cast<std::size_t>(head_[1]);
    const auto found = recogniseGrid(points_);
    if (found && found->columns == b && found->rows == a) return {a, b};
    return {b, a};
  }

  const FileBytes& file_;
  const Progress& progress_;
  TextScanner text_;
  Notation notation_;
  int wordLines_ = 0;
  std::array<double, 2> head_{};
  std::size_t headCount_ = 0;
  std::vector<Vec3> points_;
  std::vector<Colour> colours_;
  std::size_t colourAt_ = 0;
  std::size_t decimals_ = std::numeric_limits<std::size_t>::max();
  std::size_t leastDecimals_ = std::numeric_limits<std::size_t>::max();
};

bool isSample(const Vec3& p) {
  return p.allFinite() && !p.isZero(0.0);
}

// The median distance of points that are so many lines apart; infinite where hardly any are samples.
double medianStep(const std::vector<Vec3>& points, std::size_t lines) {
  constexpr std::size_t kMostPairs = 4000;
  constexpr std::size_t kLeastPairs = 16;
  const std::size_t stride = std::max<std::size_t>(1, (points.size() - lines) / kMostPairs) | 1U;
  std::vector<double> steps;
  for (std::size_t i = 0; i + lines < points.size(); i += stride)
    if (isSample(points[i]) && isSample(points[i + lines])) steps.push_back((points[i + lines] - points[i]).norm());
  if (steps.size() < kLeastPairs) return std::numeric_limits<double>::infinity();
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

}  // namespace

std::optional<GridSize> recogniseGrid(const std::vector<Vec3>& points) {
  constexpr std::size_t kLeast = 8;  // rows and columns
  constexpr double kClearly = 0.75;  // of the next best
  constexpr double kSquare = 4.0;    // a row lies so many steps of it, or less, beside the next
  const double step = medianStep(points, 1);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  double next = least;
  for (std::size_t columns = kLeast; columns * kLeast <= points.size(); ++columns) {
    if (points.size() % columns != 0) continue;
    const double across = medianStep(points, columns);
    if (across < least) {
      next = least;
      least = across;
      best = columns;
    } else {
      next = std::min(next, across);
    }
  }
  if (best == 0 || !(least <= kClearly * next) || !(least <= kSquare * step)) return std::nullopt;
  return GridSize{points.size() / best, best};
}

GridFile readTextPoints(const FileBytes& file, const std::optional<GridSize>& size, const Progress& progress) {
  return TextPointsReader(file, progress).read(size);
}

}  // namespace vantage
