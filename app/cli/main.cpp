#include "cli/command_line.h"

int main(int argc, char** argv) {
  return vantage::runCommandLine(argc, argv, [](CLI::App& app, vantage::CommandContext& context) {
    vantage::addAcquireCommand(app, context);
    vantage::addResumeCommand(app, context);
    vantage::addImportCommand(app, context);
    vantage::addBatchCommand(app, context);
    vantage::addPlanCommand(app, context);
    vantage::addStepCommand(app, context);
    vantage::addTakeCommand(app, context);
    vantage::addEraseCommand(app, context);
    vantage::addExportCommand(app, context);
    vantage::addMeasureCommand(app, context);
    vantage::addInfoCommand(app, context);
    vantage::addEvaluateCommand(app, context);
    vantage::addRenderCommand(app, context);
    vantage::addReportCommand(app, context);
    vantage::addOptionsCommand(app, context);
    vantage::addDevicesCommand(app, context);
    vantage::addCalibrateCommand(app, context);
    vantage::addProfileCommand(app, context);
    vantage::addStandCommand(app, context);
    vantage::addAlignCommand(app, context);
  });
}
