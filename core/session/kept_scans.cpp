#include "session/kept_scans.h"

namespace vantage {

ScanSource keptScans(ScannerDevice& scanner, Session& session) {
  return [&scanner, &session](int position, const Progress& progress) {
    const auto unused = session.unusedScan();
    if (unused && unused->image->position == position) return *unused;
    return session.keepScan(scanner.scan(position, progress));
  };
}

}  // namespace vantage
