#include "cli/picture_arguments.h"

namespace vantage {

const std::vector<std::string>& renderedSurfaces() {
  static const std::vector<std::string> surfaces{"plain", "confidence", "view", "age", "colours", "stand"};
  return surfaces;
}

CLI::App* RenderArguments::addTo(CLI::App& app) {
  static const std::vector<std::string> views{"model", "void", "ps-void", "ps-seen", "ps-scanner", "objective"};
  CLI::App* command = app.add_subcommand("render", "Draw a view of a session as a PNG picture, without a display");
  command->add_option("session", session, "Session file")->required();
  command->add_option("--view", view, "What to draw")->check(CLI::IsMember(views))->capture_default_str();
  command
      ->add_option("--surface", surface,
                   "What --view model and void colour the surface by; where scans have colours, by these")
      ->check(CLI::IsMember(renderedSurfaces()));
  command->add_option("--step", step, "The session as it was after so many views; the last by default");
  command->add_option("--out", out, "PNG file to write")->required();
  command->add_option("--size", size, "Width and height in pixels")->capture_default_str();
  command->add_flag("--dark", dark, "Draw in the dark theme");
  return command;
}

CLI::App* ReportArguments::addTo(CLI::App& app) {
  CLI::App* command = app.add_subcommand("report", "Write the report of a session as one HTML page with pictures");
  command->add_option("session", session, "Session file")->required();
  command->add_option("--out", out, "HTML file to write")->required();
  return command;
}

}  // namespace vantage
