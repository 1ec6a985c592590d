#include "settings/acquisition_fields.h"

#include <QCoreApplication>
#include <limits>

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(AcquisitionForm)
};

}  // namespace

AcquisitionForm AcquisitionForm::of(const AcquisitionSettings& settings) {
  AcquisitionForm form;
  form.placement = settings.simulation.placement == Placement::Fit ? 1 : 0;
  form.maxViews = settings.maxViews;
  form.tolerance = settings.planner.tolerance;
  form.firstView = settings.firstView;
  form.seed = static_cast<int>(settings.simulation.seed);
  form.ideal = settings.simulation.ideal;
  return form;
}

void AcquisitionForm::writeTo(AcquisitionSettings& settings) const {
  settings.simulation.placement = placement == 1 ? Placement::Fit : Placement::AsIs;
  settings.maxViews = maxViews;
  settings.planner.tolerance = tolerance;
  settings.firstView = firstView;
  settings.simulation.seed = static_cast<std::uint64_t>(seed);
  settings.simulation.ideal = ideal;
}

FieldTable<AcquisitionForm> acquisitionFields() {
  using F = Field<AcquisitionForm>;
  using Form = AcquisitionForm;
  return {{"placement", Text::tr("Place object"),
           Text::tr("Take the mesh where it is, or scale and centre it into the viewing volume."),
           F::Choice{&Form::placement, {Text::tr("As it is"), Text::tr("Fit into volume")}}},
          {"max_views", Text::tr("Most views"), Text::tr("Stop after so many views."),
           F::Whole{&Form::maxViews, 1, 10000, {}}},
          {"tolerance", Text::tr("Least confidence"),
           Text::tr("Surface sampled at a smaller cosine than this attracts another view; 0 switches it off."),
           F::Number{&Form::tolerance, 0.0, 1.0, 2, {}}},
          {"first_view", Text::tr("First position"), Text::tr("Where the first scan is taken."),
           F::Whole{&Form::firstView, 0, 9999, {}}},
          {"seed", Text::tr("Seed"), Text::tr("Of the simulated scanner's noise and mechanics."),
           F::Whole{&Form::seed, 0, std::numeric_limits<int>::max(), {}}},
          {"ideal", Text::tr("Ideal scanner"), Text::tr("Switch the simulated noise and mechanical errors off."),
           F::Switch{&Form::ideal}}};
}

}  // namespace vantage
