#include "wizard/object_figures.h"

#include <QCoreApplication>

#include "acquisition/stand_composites.h"
#include "form_parts.h"
#include "geometry/measures.h"
#include "why_card.h"

namespace vantage {

bool hasAnyModel(const SharedState& state) {
  return state && (state->model || !state->aside.empty());
}

void addObject(FigureTable& figures, const AcquisitionState& state) {
  const AcquisitionState object = withObject(state);
  if (!object.model) return;
  figures.add(QCoreApplication::translate("ObjectFigures", "The object without it"), areaText(area(object.model->mesh)),
              QCoreApplication::translate("ObjectFigures", "%1 views; that is what is exported")
                  .arg(countScans(object, ScanStatus::In)));
}

}  // namespace vantage
