#include "acquisition/scan_source.h"

#include <memory>

namespace vantage {

ScanSource countedScans(ScannerDevice& scanner) {
  return [&scanner, number = std::int64_t{0}](int position, const Progress& progress) mutable {
    return NumberedScan{number++, std::make_shared<const RangeImage>(scanner.scan(position, progress))};
  };
}

}  // namespace vantage
