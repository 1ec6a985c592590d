#include <QBuffer>
#include <algorithm>
#include <memory>
#include <optional>

#include "acquisition/steps.h"
#include "base/errors.h"
#include "charts/objective_chart.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/picture_application.h"
#include "cli/picture_arguments.h"
#include "cli/text.h"
#include "integration/colouring.h"
#include "io/output_file.h"
#include "osmesa/osmesa_window.h"
#include "planning/plan_images.h"
#include "positional_space/scanner_images_cache.h"
#include "program/user_folders.h"
#include "scenes/model_scene.h"
#include "scenes/positional_scene.h"

namespace vantage {
namespace {

constexpr int kLargestSide = 8192;
QSize parseSize(const std::string& text) {
  int width = 0;
  int height = 0;
  char rest = 0;
  const bool numbers = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2;
  if (!numbers || width < 64 || height < 64 || width > kLargestSide || height > kLargestSide)
    throw InvalidInput("--size is \"" + text + "\", expected WIDTHxHEIGHT with sides from 64 to " +
                       std::to_string(kLargestSide));
  return {width, height};
}

// The last state of the history that has so many views; without a step that at the cursor.
std::shared_ptr<const AcquisitionState> stateAt(const Session& session, const RenderArguments& args) {
  const History& history = session.history();
  if (!args.step) return session.state();
  for (std::size_t k = history.cursor() + 1; k-- > 0;)
    if (static_cast<int>(countScans(*history.entry(k).outline, ScanStatus::In)) == *args.step) return session.state(k);
  throw InvalidInput("--step is " + std::to_string(*args.step) + ", " + args.session + " has steps 0 to " +
                     std::to_string(countScans(*history.current().outline, ScanStatus::In)));
}

// What the views need, as far as the view that is asked for needs it.
SharedSnapshot snapshotFor(const RenderArguments& args, const Session& session, CommandContext& context) {
  const auto state = stateAt(session, args);
  const bool positional = args.view.starts_with("ps-");
  if (positional && !state->profile)
    throw InvalidInput(args.session + ": holds recorded scans without a scanner profile, --view " + args.view +
                       " needs one");
  if (!state->model) return makeSnapshot(state);
  const bool needsPlan = state->profile != nullptr && args.view != "model" && args.view != "ps-scanner";
  const bool needsImages = positional || (needsPlan && !state->plan);
  std::shared_ptr<const ScannerImages> images;
  if (needsImages)
    images = std::make_shared<const ScannerImages>(loadScannerImages(
        *state->profile, cacheDirectory(), context.progress().part(0.2, 0.3, "positional space of the scanner")));
  auto plan = state->plan;
  if (needsPlan && !plan)
    plan = std::make_shared<const Plan>(
        planAfter(*state, *images, stepOptionsFor(*state), context.progress().part(0.3, 0.6)));
  std::shared_ptr<const PlanImages> planImages;
  if (args.view == "ps-void" || args.view == "ps-seen") {
    const Progress progress = context.progress().part(0.6, 0.9, "project");
    const PlanningScene scene(planInputOf(*state), plan->voids, stepOptionsFor(*state).planner,
                              progress.part(0.0, 0.4));
    planImages = std::make_shared<const PlanImages>(computePlanImages(scene, *images, progress.part(0.4, 1.0)));
  }
  auto snapshot = std::make_shared<ViewSnapshot>(*makeSnapshot(state, images, planImages));
  snapshot->plan = plan;
  return snapshot;
}

std::shared_ptr<const ModelGeometry> geometryOf(const ViewSnapshot& snapshot) {
  return prepareGeometryOf(*snapshot.state);
}

template <typename PictureScene, typename Options>
QImage pictureOf(const Options& options, const SharedSnapshot& snapshot, const QSize& size, const Theme& theme) {
  PictureScene scene;
  scene.setTheme(theme);
  scene.setOptions(options);
  scene.set(snapshot, geometryOf(*snapshot));
  scene.scene().setCamera(
      scene.camera(CameraPreset::Oblique, static_cast<double>(size.width()) / static_cast<double>(size.height())));
  return makePicture(scene.scene(), scene.overlay(), theme, *osmesaWindows()(), size, 1.0);
}

// By themselves models are in their colours.
std::optional<ModelColouring> colouringOf(const RenderArguments& args, const ViewSnapshot& snapshot) {
  if (args.surface.empty()) return std::nullopt;
  const auto found = std::find(renderedSurfaces().begin(), renderedSurfaces().end(), args.surface);
  const auto colouring = static_cast<ModelColouring>(found - renderedSurfaces().begin());
  if (colouring == ModelColouring::Colours && !haveColours(snapshot.views))
    throw InvalidInput(args.session + ": none of its scans has colours, --surface colours needs some");
  if (colouring == ModelColouring::Stand && !haveStands(snapshot.views))
    throw InvalidInput(args.session + ": all of its views are of one stand, --surface stand needs several");
  return colouring;
}

QImage modelPicture(const RenderArguments& args, const SharedSnapshot& snapshot, const QSize& size,
                    const Theme& theme) {
  ModelViewOptions options;
  options.voidPatches = args.view == "void";
  options.colouring = colouringOf(args, *snapshot);
  options.voidColouring = snapshot->proposed() ? VoidColouring::EdgeClass : VoidColouring::State;
  return pictureOf<ModelScene>(options, snapshot, size, theme);
}

QImage positionalPicture(const RenderArguments& args, const SharedSnapshot& snapshot, const QSize& size,
                         const Theme& theme) {
  PositionalViewOptions options;
  if (args.view == "ps-seen") options.kind = PositionalImageKind::Seen;
  if (args.view == "ps-scanner") {
    options.kind = PositionalImageKind::Scanner;
    options.position = snapshot->foremost();
  }
  return pictureOf<PositionalScene>(options, snapshot, size, theme);
}

QImage objectivePicture(const SharedSnapshot& snapshot, const QSize& size, const Theme& theme) {
  QImage image(size, QImage::Format_RGB888);
  QPainter painter(&image);
  const auto data = objectiveChartData(*snapshot);
  const QRectF area(0.0, 0.0, size.width(), size.height());
  const double half = 0.5 * area.width();
  paintObjective(painter, area.adjusted(0.0, 0.0, -half, 0.0), data, ObjectiveStyle::Dial, {}, theme);
  paintObjective(painter, area.adjusted(half, 0.0, 0.0, 0.0), data, ObjectiveStyle::Bars, {}, theme);
  return image;
}

// Whole or not at all.
void writePicture(const QImage& picture, const std::string& path) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!picture.save(&buffer, "PNG")) throw IoError(path, "the picture cannot be written as PNG");
  writeTextFile(path, bytes.toStdString());
}

void runRender(const RenderArguments& args, CommandContext& context) {
  const QSize size = parseSize(args.size);
  const Theme& theme = args.dark ? darkTheme() : lightTheme();
  checkOutput(args.out, OutputKind::Picture, std::vector{args.session});
  const Session session = openSession(args.session, SessionAccess::Read, context);
  const SharedSnapshot snapshot = snapshotFor(args, session, context);
  const PictureApplication application;
  QImage picture;
  if (args.view == "objective")
    picture = objectivePicture(snapshot, size, theme);
  else if (args.view.starts_with("ps-"))
    picture = positionalPicture(args, snapshot, size, theme);
  else
    picture = modelPicture(args, snapshot, size, theme);
  writePicture(picture, args.out);
  context.result({{"file", args.out}, {"width", size.width()}, {"height", size.height()}}, args.out + "\n");
}

}  // namespace

void addRenderCommand(CLI::App& app, CommandContext& context) {
  const auto args = std::make_shared<RenderArguments>();
  CLI::App* command = args->addTo(app);
  context.addCommonOptions(*command);
  command->callback([args, &context] { runRender(*args, context); });
}

}  // namespace vantage
