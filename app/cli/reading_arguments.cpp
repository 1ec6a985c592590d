#include "cli/reading_arguments.h"

#include <map>

#include "base/errors.h"
#include "io/file_kind.h"
#include "io/text_scanner.h"
#include "report/reading_words.h"
#include "scanner/length_unit.h"

namespace vantage {
namespace {

std::optional<FrameChoice> frameIn(const std::string& text) {
  try {
    return parseFrame(text);
  } catch (const InvalidInput& e) {
    throw CLI::ValidationError("--frame", e.what());
  }
}

GridSize gridIn(const std::string& text) {
  const std::size_t cross = text.find('x');
  const auto rows = parseInteger(std::string_view(text).substr(0, cross));
  const auto columns =
      cross == std::string::npos ? std::nullopt : parseInteger(std::string_view(text).substr(cross + 1));
  if (!rows || !columns || *rows < 2 || *columns < 2)
    throw CLI::ValidationError("--grid", "is '" + text + "', expected ROWSxCOLUMNS, for instance 480x640");
  return {static_cast<std::size_t>(*rows), static_cast<std::size_t>(*columns)};
}

Axis axisIn(const std::string& text) {
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z})
    if (name(axis) == text) return axis;
  throw CLI::ValidationError("--up", "is '" + text + "', expected x, y or z");
}

// "PLY", "PCD", "PTX"
std::string formatOf(const std::string& file) {
  std::string format = extensionOf(file);
  for (char& c : format) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  return format;
}

}  // namespace

double unitNamed(const std::string& text) {
  const auto unit = lengthUnitNamed(text);
  if (!unit) throw CLI::ValidationError("--unit", "is '" + text + "', expected mm, cm, inch or m");
  return millimetresIn(*unit);
}

void ReadingArguments::addTo(CLI::App& command) {
  command
      .add_option_function<std::string>(
          "--unit", [this](const std::string& text) { options_.unit = unitNamed(text); },
          "Unit of the range files and their poses: mm, cm, inch or m; found where it is not given")
      ->type_name("UNIT");
  command
      .add_option_function<double>(
          "--no-sample", [this](double value) { options_.noSample = value; },
          "A cell is no sample where z, or every coordinate, has this value; (0, 0, 0), points that repeat and "
          "constant "
          "far planes are found")
      ->type_name("VALUE");
  command
      .add_option_function<std::string>(
          "--grid", [this](const std::string& text) { options_.grid = gridIn(text); },
          "Rows and columns of points as text, one line for every cell, where the file does not say them")
      ->type_name("ROWSxCOLUMNS");
  command
      .add_option_function<std::string>(
          "--frame", [this](const std::string& text) { options_.frame = frameIn(text); },
          "Where the scanner looks in the axes of the files: camera (z+), gl (z-), x+, x-, y+, y-, z+, z-; world: "
          "points "
          "are in the object's coordinates; cylinder: columns go around an axis; profile: points are in the "
          "coordinates of the scanner's profile, which has camera, gl and world besides")
      ->type_name("FRAME")
      ->default_str("auto");
  command
      .add_option_function<std::string>(
          "--up", [this](const std::string& text) { options_.up = axisIn(text); },
          "The axis that is up in the coordinates of the object: x, y or z; it becomes z")
      ->type_name("AXIS")
      ->default_str("z");
}

void requireSaidUnit(const std::vector<std::string>& files, const std::vector<ReadScan>& scans) {
  for (const ReadScan& scan : scans) {
    if (scan.reading.unitKnownBy != KnownBy::Evidence || scan.reading.unit == 1.0) continue;
    const auto known = lengthUnitOf(scan.reading.unit);
    const std::string unit = known ? std::string(name(*known)) : std::to_string(scan.reading.unit) + " mm";
    throw InvalidInput(files[scan.file] + ": seems to be in " + unit +
                       ", in which its points are before the scanner and on its rays, not in mm: say --unit " + unit +
                       ", or the unit that it is in");
  }
}

std::string readingLines(const std::vector<std::string>& files, const std::vector<ReadScan>& scans) {
  std::vector<std::pair<std::string, std::string>> said;  // text, first file
  for (const ReadScan& scan : scans) {
    std::string text = english(phraseOf(scan.reading));
    if (said.empty() || said.back().first != text) said.emplace_back(std::move(text), files[scan.file]);
  }
  if (said.size() == 1) return formatOf(said.front().second) + " read as: " + said.front().first + "\n";
  std::string lines;
  for (const auto& [text, file] : said) lines += file + " read as: " + text + "\n";
  return lines;
}

}  // namespace vantage
