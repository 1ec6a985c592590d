#include "earlier_versions.h"

#include <fstream>
#include <iterator>

#include "positional_space/scanner_images.h"
#include "support/simulation.h"

namespace vantage::testing {

const std::vector<std::string>& earlierSessions() {
  static const std::vector<std::string> names{"schema_1",         "schema_2_taken_over", "schema_2_ended",
                                              "schema_2_steered", "schema_2_imported",   "schema_3_steered",
                                              "schema_4_steered"};
  return names;
}

std::string earlierSession(const std::string& name) {
  return (sourceFolder() / "tests/core/session/data" / (name + ".vantage")).string();
}

std::string bytesOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

AcquisitionTools earlierTools(const Session& session) {
  // Version 1 did not keep the object; all of these scanners look at the same one.
  const Mesh object = Session::open(earlierSession("schema_2_ended"), SessionAccess::Read).object();
  const AcquisitionSettings settings = session.state()->settings;
  const SimulationOptions options{settings.simulation.seed, settings.simulation.ideal};
  return {simulation(object, session.profile(), options, static_cast<int>(session.scanCount())),
          std::make_shared<const ScannerImages>(computeScannerImages(*session.profile()))};
}

std::vector<std::string> textsOf(Database& database, const std::string& query) {
  std::vector<std::string> texts;
  Statement rows = database.prepare(query);
  while (rows.step()) texts.push_back(rows.text(0));
  return texts;
}

std::vector<std::byte> blobOf(const std::string& path, const std::string& query) {
  Database database(path, Database::Mode::Read);
  Statement row = database.prepare(query);
  return row.step() ? row.blob(0) : std::vector<std::byte>();
}

std::vector<std::byte> lastModelOf(const std::string& path) {
  return blobOf(path, "SELECT data FROM model ORDER BY step DESC LIMIT 1");
}

}  // namespace vantage::testing
