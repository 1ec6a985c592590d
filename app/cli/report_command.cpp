#include <memory>

#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/picture_application.h"
#include "cli/picture_arguments.h"
#include "cli/text.h"
#include "io/output_file.h"
#include "osmesa/osmesa_window.h"
#include "program/version.h"
#include "report/html_report.h"
#include "report_pictures.h"
#include "scenes/model_scene.h"

namespace vantage {
namespace {

// The model from a few sides, with the void that is left by its reason.
std::vector<ReportPicture> modelPictures(const std::shared_ptr<const AcquisitionState>& state) {
  if (!state->model) return {};
  const QSize size(640, 480);
  ModelScene scene;
  ModelViewOptions options;
  options.voidColouring = VoidColouring::State;
  scene.setTheme(lightTheme());
  scene.setOptions(options);
  scene.set(makeSnapshot(state), prepareGeometryOf(*state));
  const auto window = osmesaWindows()();
  std::vector<ReportPicture> pictures;
  for (const auto& [preset, caption] :
       {std::pair{CameraPreset::Oblique, "The model, and by colour why the void beside it is left"},
        std::pair{CameraPreset::Front, "From the front"}, std::pair{CameraPreset::Top, "From above"}}) {
    scene.scene().setCamera(scene.camera(preset, static_cast<double>(size.width()) / size.height()));
    pictures.push_back(
        toReportPicture(makePicture(scene.scene(), scene.overlay(), lightTheme(), *window, size, 1.0), caption));
  }
  return pictures;
}

void runReport(const ReportArguments& args, CommandContext& context) {
  checkOutput(args.out, OutputKind::Report, std::vector{args.session});
  const auto state = readObject(args.session, context);
  HtmlReportOptions options;
  options.version = programVersion();
  const PictureApplication application;
  options.pictures = modelPictures(state);
  options.viewPictures = scanPictures(*state);
  options.standPictures = standPictures(*state);
  writeTextFile(args.out, makeHtmlReport(*state, options));
  context.result({{"file", args.out}, {"views", countScans(*state, ScanStatus::In)}},
                 args.out + ": report of " + std::to_string(countScans(*state, ScanStatus::In)) + " views\n");
}

}  // namespace

void addReportCommand(CLI::App& app, CommandContext& context) {
  const auto args = std::make_shared<ReportArguments>();
  CLI::App* command = args->addTo(app);
  context.addCommonOptions(*command);
  command->callback([args, &context] { runReport(*args, context); });
}

}  // namespace vantage
