#include "cli/command_line.h"

// The commands that draw: vantage-cli hands them on to this program, so that it needs no OpenGL itself.
int main(int argc, char** argv) {
  return vantage::runCommandLine(argc, argv, [](CLI::App& app, vantage::CommandContext& context) {
    vantage::addRenderCommand(app, context);
    vantage::addReportCommand(app, context);
  });
}
