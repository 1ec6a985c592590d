#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/point_arguments.h"
#include "cli/text.h"
#include "finishing/print_check.h"
#include "geometry/measures.h"
#include "geometry/ray_caster.h"
#include "io/file_kind.h"
#include "io/mesh_reader.h"
#include "io/model_reader.h"
#include "io/ply_header.h"
#include "measuring/circle_fit.h"
#include "measuring/plane_section.h"

namespace vantage {
namespace {

struct MeasureArguments {
  std::string model;
  std::vector<std::string> points;
  std::string plane;
  std::string section;
};

// A surface, and how much of it is invented: that is not measured.
struct Measured {
  Mesh whole;
  Mesh mesh;
  double inventedArea = 0.0;  // [mm^2]
};

Measured measuredOf(const Model& model) {
  Measured measured{model.mesh, model.mesh};
  measured.mesh.triangles.clear();
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
    if (model.triangleView[t] == kNoIndex)
      measured.inventedArea += triangleArea(model.mesh, model.mesh.triangles[t]);
    else
      measured.mesh.triangles.push_back(model.mesh.triangles[t]);
  }
  return measured;
}

Measured load(const std::string& path, CommandContext& context) {
  const FileKind kind = detectFileKind(path);
  if (kind == FileKind::Session) return measuredOf(*readSessionModel(path, context).model);
  const Progress progress = context.progress().part(0.0, 0.3, "read model");
  if (kind == FileKind::Ply && isModel(readPlyHeader(path))) return measuredOf(readModel(path, progress));
  Mesh mesh = loadMesh(path, {}, progress).mesh;
  return {mesh, std::move(mesh)};
}

nlohmann::ordered_json listOf(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

std::string said(const Vec3& p) {
  return "(" + number(p.x(), 3) + ", " + number(p.y(), 3) + ", " + number(p.z(), 3) + ")";
}

// What every surface has.
void addWhole(const Measured& measured, nlohmann::ordered_json& json, std::string& text, const Progress& progress) {
  const PrintCheck check = checkForPrint(measured.whole, progress);
  const double measuredArea = area(measured.mesh);
  const Vec3 size = measure(measured.mesh).box.size();
  json["size_mm"] = listOf(size);
  json["area_mm2"] = measuredArea;
  json["area_invented_mm2"] = measured.inventedArea;
  json["closed"] = check.closed();
  text += "size:    " + number(size.x(), 3) + " x " + number(size.y(), 3) + " x " + number(size.z(), 3) + " mm\n";
  text += "area:    " + number(measuredArea, 1) + " mm²";
  if (measured.inventedArea > 0.0) text += "; " + number(measured.inventedArea, 1) + " mm² more are invented";
  if (check.volume) {
    json["volume_mm3"] = *check.volume;
    text += "\nvolume:  " + number(*check.volume / 1000.0, 3) + " cm³" +
            (measured.inventedArea > 0.0 ? ", enclosed with what is invented" : "") + "\n";
  } else {
    text += "\nvolume:  none, the surface is not closed\n";
  }
}

// The points of the surface that are nearest to those named.
std::vector<Vec3> onSurface(const MeasureArguments& args, const Mesh& mesh) {
  std::vector<Vec3> points;
  if (args.points.empty()) return points;
  const RayCaster caster(mesh);
  for (const std::string& text : args.points) {
    const auto nearest = caster.closestPoint(pointOf(text), std::numeric_limits<double>::infinity());
    if (!nearest) throw InvalidInput(args.model + ": has no surface near (" + text + ")");
    points.push_back(nearest->point);
  }
  return points;
}

void addPoints(const MeasureArguments& args, const Mesh& mesh, nlohmann::ordered_json& json, std::string& text) {
  const std::vector<Vec3> points = onSurface(args, mesh);
  for (const Vec3& p : points) {
    json["points"].push_back(listOf(p));
    text += "point:   " + said(p) + " of the surface\n";
  }
  if (points.size() == 2) {
    json["distance_mm"] = (points[1] - points[0]).norm();
    text += "apart:   " + number((points[1] - points[0]).norm(), 3) + " mm\n";
  }
  if (points.size() == 3) {
    const Circle circle = circleThrough({points[0], points[1], points[2]});
    json["circle"] = {{"diameter_mm", circle.diameter()}, {"centre", listOf(circle.centre)}};
    text += "circle:  diameter " + number(circle.diameter(), 3) + " mm about " + said(circle.centre) + "\n";
  }
  if (args.plane.empty()) return;
  const SurfacePlane plane = planeOf(args.plane);
  for (const Vec3& p : points) {
    json["plane_distances_mm"].push_back(plane.distance(p));
    text += "plane:   " + number(plane.distance(p), 3) + " mm in front of it\n";
  }
}

void addSection(const MeasureArguments& args, const Mesh& mesh, nlohmann::ordered_json& json, std::string& text,
                const Progress& progress) {
  if (args.section.empty()) return;
  const PlaneSection section = sectionOf(mesh, planeOf(args.section), progress);
  nlohmann::ordered_json lines = nlohmann::ordered_json::array();
  text += "section: " + std::to_string(section.lines.size()) + (section.lines.size() == 1 ? " line, " : " lines, ") +
          number(section.length, 3) + " mm" +
          (section.area ? ", " + number(*section.area, 2) + " mm² inside\n" : std::string(", not closed\n"));
  for (const SectionLine& line : section.lines) {
    nlohmann::ordered_json one{{"length_mm", line.length}, {"closed", line.closed}, {"points", line.points.size()}};
    if (line.closed && line.points.size() > 2) {
      const Circle circle = circleFit(line.points);
      one["circle"] = {{"diameter_mm", circle.diameter()}, {"centre", listOf(circle.centre)}, {"rms_mm", circle.rms}};
      text += "         " + number(line.length, 3) + " mm; the nearest circle has the diameter " +
              number(circle.diameter(), 3) + " mm, the line is " + number(circle.rms, 3) + " mm off it in the mean\n";
    }
    lines.push_back(std::move(one));
  }
  json["section"] = {{"length_mm", section.length}, {"lines", std::move(lines)}};
  if (section.area) json["section"]["area_mm2"] = *section.area;
}

void runMeasure(const MeasureArguments& args, CommandContext& context) {
  if (!args.plane.empty() && args.points.empty())
    throw InvalidInput("distances to a plane need points: name them with --points");
  const Measured measured = load(args.model, context);
  if (measured.mesh.empty()) throw InvalidInput(args.model + ": has no surface to measure");
  nlohmann::ordered_json json;
  std::string text;
  addWhole(measured, json, text, context.progress().part(0.3, 0.7, "measure"));
  addPoints(args, measured.mesh, json, text);
  addSection(args, measured.mesh, json, text, context.progress().part(0.7, 1.0, "measure"));
  context.result(json, text);
}

}  // namespace

void addMeasureCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<MeasureArguments>();
  CLI::App* command =
      app.add_subcommand("measure", "Measure the surface of a model: size, area, volume, points, a section");
  command->add_option("model", args->model, "Session or mesh file")->required();
  command
      ->add_option("--points", args->points,
                   "Points X,Y,Z [mm], each replaced by the nearest of the surface: of two the distance, of three the "
                   "diameter of the circle through them")
      ->check(pointText())
      ->expected(1, 3);
  command->add_option("--plane", args->plane, "Plane NX,NY,NZ,D (n . p = d [mm]) from which the points are how far")
      ->check(planeText());
  command->add_option("--section", args->section, "Plane NX,NY,NZ,D that cuts the surface: length, area, circles")
      ->check(planeText());
  context.addCommonOptions(*command);
  command->callback([args, &context] { runMeasure(*args, context); });
}

}  // namespace vantage
