#include "scanner/station.h"

namespace vantage {

bool operator==(const Station& a, const Station& b) {
  return a.stand == b.stand && a.position == b.position;
}

std::string_view name(PoseSource source) {
  switch (source) {
    case PoseSource::Unknown:
      return "unknown";
    case PoseSource::Commanded:
      return "commanded";
    case PoseSource::Reported:
      return "reported";
    case PoseSource::ByHand:
      break;
  }
  return "hand";
}

}  // namespace vantage
