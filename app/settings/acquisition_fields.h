#pragma once

#include "acquisition/acquisition_state.h"
#include "settings/field_table.h"

namespace vantage {

/// The settings of an acquisition as a form edits them.
struct AcquisitionForm {
  int placement = 0;  ///< as it is, fitted
  int maxViews = 40;
  double tolerance = 0.0;  ///< u
  int firstView = 0;
  int seed = 1;
  bool ideal = false;

  [[nodiscard]] static AcquisitionForm of(const AcquisitionSettings& settings);
  /// Writes the fields into settings, whose other members stay.
  void writeTo(AcquisitionSettings& settings) const;
};

[[nodiscard]] FieldTable<AcquisitionForm> acquisitionFields();

}  // namespace vantage
