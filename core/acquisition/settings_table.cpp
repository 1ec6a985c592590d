#include "acquisition/settings_table.h"

#include "acquisition/setting_member.h"

namespace vantage {
namespace {

using enum SettingAudience;
using namespace setting_member;

using Settings = AcquisitionSettings;
using Simulation = SimulationSettings;
using Cut = CutOptions;
using Thinning = ThinningOptions;
using Triangulation = TriangulationOptions;
using Icp = IcpOptions;
using Limits = VerdictLimits;
using Refinement = MultiViewOptions;
using Sampling = AlignmentSampling;
using Zipper = ZipperOptions;
using Consensus = ConsensusOptions;
using Planner = PlannerOptions;
using Void = VoidOptions;
using History = PatchHistoryOptions;
using End = TerminationOptions;
using Closing = ClosingOptions;
using Ledger = LedgerOptions;

constexpr double kMostViews = 1e6;
constexpr double kMostPoints = 1e8;
constexpr double kMostVoxels = 2e7;
constexpr double kMostSeed = 18446744073709551615.0;

// NOLINTBEGIN(readability-magic-numbers)
std::vector<SettingField> acquisitionFields() {
  return {
      number<&Settings::maxViews>(Basic, "max_views", "Most views", "", 1, kMostViews, "40",
                                  "Stop after so many views."),
      number<&Settings::firstView>(Basic, "first_view", "First position", "", 0, kMostViews, "0",
                                   "Position of the workspace that the first scan is taken from."),
      text<&Settings::strategy>(
          Expert, "strategy", "Strategy", "ps",
          "How the next position is chosen: ps by positional space, uniform:N and random to compare with."),
      text<&Settings::simulation, &Simulation::object>(Session, "simulation.object", "Object", "",
                                                       "Mesh that the simulated scanner looks at."),
      choice<&Settings::simulation, &Simulation::placement>(
          Basic, "simulation.placement", "Place object", {"as-is", "fit"}, "as-is",
          "Take the mesh where it is, or scale and centre it into the viewing volume."),
      number<&Settings::simulation, &Simulation::unit>(
          Basic, "simulation.unit", "Unit of the mesh", "mm", 1e-6, 1e6, "auto",
          "Millimetres in a unit of the mesh file: 10 for centimetres, 25.4 for inches, 1000 for metres."),
      number<&Settings::simulation, &Simulation::seed>(Basic, "simulation.seed", "Seed", "", 0, kMostSeed, "1",
                                                       "Seed of the simulated scanner's noise and mechanics."),
      onOff<&Settings::simulation, &Simulation::ideal>(Basic, "simulation.ideal", "Ideal scanner", "false",
                                                       "Switch the simulated noise and mechanical errors off."),
  };
}

std::vector<SettingField> planningFields() {
  return {
      number<&Settings::planner, &Planner::tolerance>(
          Basic, "planner.tolerance", "Least confidence", "", 0, 1, "0",
          "Surface sampled at a smaller cosine than this attracts another view; 0 switches it off."),
      number<&Settings::planner, &Planner::overlapShare>(
          Expert, "planner.overlap_share", "Least share of overlap", "", 0, 1, "0.1",
          "A view must overlap with at least this share of the model's area per view taken."),
      number<&Settings::planner, &Planner::overlapSamples>(
          Expert, "planner.overlap_samples", "Least samples of overlap", "", 0, 1e6, "300",
          "A view must overlap with at least the area of so many samples."),
      number<&Settings::planner, &Planner::leastOverlap>(
          Expert, "planner.least_overlap", "Least overlap", "mm2", 0, 1e9, "auto",
          "A view must overlap with the model by at least this area, in the place of share and samples."),
      number<&Settings::planner, &Planner::borderRings>(
          Expert, "planner.border_rings", "Rings of the border", "", 0, 100, "2",
          "Triangles this many rings of vertices from the model's border give no pairs to register a view with."),
      number<&Settings::planner, &Planner::maxRelaxations>(
          Expert, "planner.max_relaxations", "Most relaxations", "", 0, 20, "3",
          "So often the least overlap is halved and the pose error doubled when no position satisfies them."),
      number<&Settings::planner, &Planner::tableAloneShare>(Expert, "planner.table_alone_share", "By the table alone",
                                                            "", 0, 1, "1",
                                                            "When nothing overlaps enough, a view that promises more "
                                                            "than this share of the model's area is taken, placed "
                                                            "by the table alone and called doubtful; 1: never."),
      number<&Settings::planner, &Planner::poseSigmaShare>(
          Expert, "planner.pose_sigma_share", "Pose certainty", "samples", 0.001, 100, "0.2",
          "The overlap of a view must fix its pose to within this many sample spacings."),
      number<&Settings::planner, &Planner::overlapElements>(
          Expert, "planner.overlap_elements", "Elements of overlap", "", 10, kMostPoints, "2000",
          "So many surface elements predict how certain the pose of a view would be."),
      number<&Settings::planner, &Planner::pairsPerObservation>(
          Expert, "planner.pairs_per_observation", "Pairs per observation", "", 1, 1e6, "20",
          "Neighbouring samples share errors: so many pairs of a registration count as one observation."),
      number<&Settings::planner, &Planner::leastRangeSigma>(
          Expert, "planner.least_range_sigma", "Least error of a sample", "samples", 0, 100, "0.05",
          "Samples are taken to be no more exact than this, whatever the scanner's profile says."),
      onOff<&Settings::planner, &Planner::lookAhead>(
          Expert, "planner.look_ahead", "Look ahead", "true",
          "Void patches stand for the surface behind them; off, the objective is that of the paper."),
      number<&Settings::planner, &Planner::lookAheadReach>(
          Expert, "planner.look_ahead_reach", "Reach of the look-ahead", "samples", 0.01, 1000, "3",
          "So far ahead an open void patch stands for unseen surface."),
      number<&Settings::planner, &Planner::widestHole>(
          Expert, "planner.widest_hole", "Widest hole", "samples", 0.01, 10000, "16",
          "Patches that face each other across no more than this bound one hole."),
      number<&Settings::planner, &Planner::facingAngle>(
          Expert, "planner.facing_angle", "Facing angle", "deg", 0, 180, "60",
          "Patches face each other when either lies this near to where the other points."),
      number<&Settings::planner, &Planner::openingAngle>(
          Expert, "planner.opening_angle", "Opening angle", "deg", 0, 90, "85",
          "A view that looks farther than this from the normal of an opening hardly looks through it."),
      onOff<&Settings::planner, &Planner::forecast>(Expert, "planner.forecast", "Forecast surface", "false",
                                                    "Positions are ranked by the new surface that they are forecast to "
                                                    "show, from a prediction of what closes the "
                                                    "model; off, by void patches alone."),
      number<&Settings::planner, &Planner::patchShare>(
          Expert, "planner.patch_share", "Share of patches", "", 0, 100, "0.3",
          "In a forecast void patches count by so much of their area beside the predicted surface."),
      number<&Settings::planner, &Planner::forecastShare>(
          Expert, "planner.forecast_share", "Share worth a forecast", "", 0, 1, "0.0012",
          "A view must be forecast to show at least this share of the model's area."),
      number<&Settings::planner, &Planner::probeShare>(
          Expert, "planner.probe_share", "Share worth a probe", "", 0, 1, "0.5",
          "After a view that showed enough, a forecast of this share of the termination threshold is tried; 1 never."),
      number<&Settings::planner, &Planner::surfaceOffset>(
          Expert, "planner.surface_offset", "Offset from the surface", "samples", 0, 100, "0.25",
          "Lines of sight and observation rays begin this far in front of the surface."),
      number<&Settings::planner, &Planner::sightMargin>(
          Expert, "planner.sight_margin", "Margin of sight", "samples", 0, 100, "0.5",
          "What blocks a line of sight within this distance of either end does not count."),
      number<&Settings::planner, &Planner::tracedPositions>(
          Expert, "planner.traced_positions", "Traced positions", "", 1, 10000, "16",
          "So many positions at a time are judged with the scanner's own rays."),
      number<&Settings::planner, &Planner::planningTriangles>(
          Expert, "planner.planning_triangles", "Planning triangles", "", 1, kMostPoints, "30000",
          "So many triangles stand for the model's surface when it is projected into positional space."),
      number<&Settings::planner, &Planner::tracedTriangles>(
          Expert, "planner.traced_triangles", "Traced triangles", "", 1, kMostPoints, "300000",
          "A model of more triangles than this is decimated before rays are traced through it."),
      number<&Settings::planner, &Planner::planningError>(Expert, "planner.planning_error", "Error of decimation", "mm",
                                                          0, 100, "0.1",
                                                          "The decimated model is off by no more than this."),
      number<&Settings::planner, &Planner::closing, &Closing::side>(
          Expert, "closing.side", "Side of a voxel", "samples", 0.1, 1000, "2.5",
          "Unseen space is divided into voxels of this side."),
      number<&Settings::planner, &Planner::closing, &Closing::crossingAngle>(
          Expert, "closing.crossing_angle", "Crossing angle", "deg", 0, 90, "40",
          "Two rays that measured nothing free what lies where they cross at no less than this angle."),
      number<&Settings::planner, &Planner::closing, &Closing::silence>(
          Expert, "closing.silence", "Pull of silence", "", 0, 100, "0.3",
          "A single ray that measured nothing makes what it passed so likely to be free, beside 6 for the neighbours."),
      number<&Settings::planner, &Planner::closing, &Closing::mostVoxels>(
          Expert, "closing.most_voxels", "Most voxels", "", 1000, kMostVoxels, "1000000",
          "Voxels are larger where there would be more of them."),
      number<&Settings::planner, &Planner::closing, &Closing::clearOfBreakdown>(
          Expert, "closing.clear_of_breakdown", "Clear of breakdown", "deg", 0, 90, "6",
          "A view should have sampled predicted surface that it saw this much inside the breakdown angle."),
      number<&Settings::planner, &Planner::closing, &Closing::sweeps>(
          Expert, "closing.sweeps", "Sweeps", "", 1, 10000, "80",
          "So often the levels of unseen space are relaxed, a quarter of it after each look."),
      number<&Settings::planner, &Planner::closing, &Closing::mostLooks>(
          Expert, "closing.most_looks", "Most looks", "", 0, 100, "6",
          "So often predicted surface that views should have sampled is carved away."),
      number<&Settings::planner, &Planner::ledger, &Ledger::remembered>(
          Expert, "ledger.remembered", "Views remembered", "", 0, 1000, "4",
          "So many of the last views correct a forecast."),
      number<&Settings::planner, &Planner::ledger, &Ledger::priorArea>(
          Expert, "ledger.prior_area", "Weight beforehand", "", 0, 1e6, "60",
          "What is known beforehand of forecasts counts like a view that was forecast to show so many samples."),
      number<&Settings::planner, &Planner::ledger, &Ledger::priorFactor>(
          Expert, "ledger.prior_factor", "Share beforehand", "", 0.01, 10, "0.7",
          "Share of what is forecast that is found, as far as is known beforehand."),
      number<&Settings::planner, &Planner::ledger, &Ledger::priorSpread>(
          Expert, "ledger.prior_spread", "Spread beforehand", "", 0, 10, "0.5", "Standard deviation of that share."),
      number<&Settings::planner, &Planner::termination, &End::threshold>(
          Expert, "termination.threshold", "Termination threshold", "mm2", 0, 1e9, "auto",
          "A view must promise at least this area of void, in the place of edges and share."),
      number<&Settings::planner, &Planner::termination, &End::edges>(
          Expert, "termination.edges", "Edges worth a view", "", 0, 1e6, "17",
          "A view must promise what so many boundary edges of one sample spacing show."),
      number<&Settings::planner, &Planner::termination, &End::share>(
          Expert, "termination.share", "Share worth a view", "", 0, 1, "0.0005",
          "A view must promise at least this share of the model's area."),
      number<&Settings::planner, &Planner::termination, &End::mostShare>(
          Expert, "termination.most_share", "Share always worth a view", "", 0, 1000, "1000",
          "A view that promises this share of the model's area is worth it, however small that is."),
      number<&Settings::planner, &Planner::history, &History::clearOfBreakdown>(
          Expert, "history.clear_of_breakdown", "Clear of breakdown", "deg", 0, 90, "6",
          "A view has looked at a patch when it saw it this much inside the breakdown angle."),
      number<&Settings::planner, &Planner::history, &History::mostLooks>(
          Expert, "history.most_looks", "Most looks", "", 1, 1000, "2",
          "After so many views that looked at it without finding surface a patch attracts no more."),
      number<&Settings::planner, &Planner::history, &History::cosineGain>(
          Expert, "history.cosine_gain", "Gain of cosine", "", 0, 1, "0.07",
          "A patch attracts only views that see it at a cosine larger by this than any view before."),
      number<&Settings::planner, &Planner::history, &History::grazingAngle>(
          Expert, "history.grazing_angle", "Grazing angle", "deg", 0, 90, "85",
          "Views count as having seen a patch up to this angle, if only too steeply to sample it."),
      number<&Settings::planner, &Planner::voidSpace, &Void::jumpFactor>(
          Expert, "void.jump_factor", "Jump factor", "", 0.01, 100, "1.5",
          "Surface beside an edge counts as a jump when it is so many times deeper than a surface at the breakdown "
          "angle falls off."),
      number<&Settings::planner, &Planner::voidSpace, &Void::shadowReach>(
          Expert, "void.shadow_reach", "Reach of shadows", "samples", 0, 1000, "4",
          "So far beside an edge a shadow may begin that explains why nothing was sampled."),
      number<&Settings::planner, &Planner::voidSpace, &Void::normalRings>(
          Expert, "void.normal_rings", "Rings of normals", "", 0, 100, "2",
          "The frame of an edge uses the mean normal of so many rings of triangles; 0 takes the edge's own."),
      choice<&Settings::planner, &Planner::voidSpace, &Void::weight>(
          Expert, "void.weight", "Weight of a patch", {"spacing", "triangle"}, "spacing",
          "A void patch counts as edge length times sample spacing, or as the area of the edge's triangle."),
  };
}

std::vector<SettingField> cutFields() {
  return {
      onOff<&Settings::cut, &Cut::volume>(
          Basic, "cut.volume", "Cut to the viewing volume", "false",
          "What a scan shows of the table, and of what stands outside of the viewing volume, is not used."),
      number<&Settings::cut, &Cut::tableMargin>(
          Basic, "cut.table_margin", "Margin above the table", "mm", -1000, 1000, "auto",
          "What lies lower than this above the table is not used; auto follows spacing and noise of the samples."),
      number<&Settings::cut, &Cut::radiusMargin>(Expert, "cut.radius_margin", "Margin inside the radius", "mm", -1000,
                                                 1000, "0", "The cut is so much narrower than the viewing volume."),
      onOff<&Settings::cut, &Cut::flyingPixels>(Basic, "cut.flying_pixels", "Drop flying samples", "false",
                                                "Samples that lie between front and back of an edge are not used."),
      number<&Settings::cut, &Cut::flyingJump>(Expert, "cut.flying_jump", "Jump of a flying sample", "", 0.1, 100,
                                               "1.4",
                                               "Neighbours are apart by a jump when they are farther from each other "
                                               "than so many times what surface at the breakdown angle explains."),
      onOff<&Settings::cut, &Cut::isolated>(Basic, "cut.isolated", "Drop isolated samples", "false",
                                            "Samples that no neighbour belongs to are not used."),
      number<&Settings::cut, &Cut::smallestIsland>(Expert, "cut.smallest_island", "Smallest piece of a scan", "", 0,
                                                   1e6, "0", "Pieces of a scan of fewer samples are not used."),
  };
}

std::vector<SettingField> registrationFields() {
  return {
      number<&Settings::thinning, &Thinning::spacing>(
          Basic, "triangulation.spacing", "Spacing worked with", "mm", 0, 1000, "0",
          "Samples nearer to each other than this are thinned by whole rows and columns, in what is worked on and not "
          "in what is kept; 0: none are; auto: those of a scanner with more than 1.5 million rays."),
      number<&Settings::triangulation, &Triangulation::angleSlack>(
          Expert, "triangulation.angle_slack", "Slack of the breakdown angle", "deg", 0, 45, "auto",
          "How much farther than the breakdown angle noise may tilt a single triangle."),
      number<&Settings::triangulation, &Triangulation::discontinuityFactor>(
          Expert, "triangulation.discontinuity_factor", "Discontinuity factor", "", 0.1, 100, "1.4",
          "An edge is a jump in depth when it is so many times longer than that of a surface at the breakdown angle."),
      number<&Settings::registration, &Icp::coarseGate>(
          Expert, "registration.coarse_gate", "Coarse gate", "mm", 1e-6, 1e6, "10",
          "Largest distance of a pair at the beginning; auto follows the size of what a scan shows."),
      number<&Settings::registration, &Icp::finalGate>(
          Expert, "registration.final_gate", "Final gate", "mm", 1e-6, 1e6, "0.8",
          "Largest distance of a pair at the end; auto follows spacing and noise of the samples."),
      number<&Settings::registration, &Icp::coarseAngle>(
          Expert, "registration.coarse_angle", "Coarse angle", "deg", 1, 90, "45",
          "Largest angle between the normals of a pair at the beginning."),
      number<&Settings::registration, &Icp::finalAngle>(Expert, "registration.final_angle", "Final angle", "deg", 1, 90,
                                                        "35",
                                                        "Largest angle between the normals of a pair at the end."),
      number<&Settings::registration, &Icp::hiddenDepth>(
          Expert, "registration.hidden_depth", "Hidden depth", "mm", 0, 1e6, "10",
          "Model surface farther behind the view's counts as hidden; auto follows the size of what a scan shows."),
      number<&Settings::registration, &Icp::coarsePoints>(
          Expert, "registration.coarse_points", "Coarse points", "", 10, kMostPoints, "4000",
          "Points of the model that are looked up until the pose settles."),
      number<&Settings::registration, &Icp::finePoints>(Expert, "registration.fine_points", "Fine points", "", 10,
                                                        kMostPoints, "60000",
                                                        "Points of the model that are looked up in the last rounds."),
      number<&Settings::registration, &Icp::maxIterations>(Expert, "registration.max_iterations", "Most rounds", "", 1,
                                                           100000, "60",
                                                           "Rounds after which a registration is given up."),
      number<&Settings::registration, &Icp::tolerance>(Expert, "registration.tolerance", "Tolerance", "mm", 1e-9, 10,
                                                       "0.001",
                                                       "The pose has settled when points move less than this."),
      onOff<&Settings::registration, &Icp::searchRivals>(
          Expert, "registration.search_rivals", "Search for rivals", "true",
          "Look for other poses that fit as well, as repetitive shapes have them."),
      number<&Settings::registration, &Icp::limits, &Limits::minPairs>(Expert, "verdict.min_pairs", "Least pairs", "",
                                                                       0, kMostPoints, "100",
                                                                       "With fewer pairs a registration has failed."),
      number<&Settings::registration, &Icp::limits, &Limits::fewPairs>(Expert, "verdict.few_pairs", "Few pairs", "", 0,
                                                                       kMostPoints, "400",
                                                                       "With fewer pairs a registration is doubtful."),
      number<&Settings::registration, &Icp::limits, &Limits::minInlierShare>(
          Expert, "verdict.min_inlier_share", "Least share of inliers", "", 0, 1, "0.4",
          "With less of the expected overlap a registration has failed."),
      number<&Settings::registration, &Icp::limits, &Limits::lowInlierShare>(
          Expert, "verdict.low_inlier_share", "Low share of inliers", "", 0, 1, "0.75",
          "With less of the expected overlap a registration is doubtful."),
      number<&Settings::registration, &Icp::limits, &Limits::doubtfulConflicts>(
          Expert, "verdict.doubtful_conflicts", "Doubtful conflicts", "", 0, 1, "0.04",
          "With a larger share of points that the scanner looked through a registration is doubtful."),
      number<&Settings::registration, &Icp::limits, &Limits::maxConflicts>(
          Expert, "verdict.max_conflicts", "Most conflicts", "", 0, 1, "0.15",
          "With a larger share of points that the scanner looked through a registration has failed."),
      number<&Settings::registration, &Icp::limits, &Limits::doubtfulResidual>(
          Expert, "verdict.doubtful_residual", "Doubtful residual", "", 0, 1e6, "2",
          "With a residual of more than so many times what noise and spacing explain a registration is doubtful."),
      number<&Settings::registration, &Icp::limits, &Limits::maxResidual>(
          Expert, "verdict.max_residual", "Largest residual", "", 0, 1e6, "4",
          "With a residual of more than so many times what noise and spacing explain a registration has failed."),
      number<&Settings::registration, &Icp::limits, &Limits::doubtfulMotion>(
          Expert, "verdict.doubtful_motion", "Doubtful motion", "", 0, 1e6, "4",
          "Farther from the start pose than so many sigmas of the prior a registration is doubtful."),
      number<&Settings::registration, &Icp::limits, &Limits::maxMotion>(
          Expert, "verdict.max_motion", "Largest motion", "", 0, 1e6, "7",
          "Farther from the start pose than so many sigmas of the prior a registration has failed."),
      number<&Settings::registration, &Icp::limits, &Limits::heldTolerance>(
          Expert, "verdict.held_tolerance", "Tolerance of held scans", "", 0, 1e6, "1",
          "Where the mechanics alone hold a motion of a scan, it has failed when conflicts or residual exceed so many "
          "times what is doubtful."),
      number<&Settings::registration, &Icp::limits, &Limits::maxPoseSigma>(
          Expert, "verdict.max_pose_sigma", "Largest pose sigma", "mm", 0, 1e6, "0.1",
          "With a less certain pose, going by the pairs alone, a registration is doubtful; auto follows the spacing."),
      number<&Settings::refinement, &Refinement::coarseGate>(
          Expert, "refinement.coarse_gate", "Coarse gate", "mm", 1e-6, 1e6, "2",
          "Largest distance of a pair at the beginning; auto follows the final gate."),
      number<&Settings::refinement, &Refinement::finalGate>(
          Expert, "refinement.final_gate", "Final gate", "mm", 1e-6, 1e6, "0.8",
          "Largest distance of a pair at the end; auto follows spacing and noise of the samples."),
      number<&Settings::refinement, &Refinement::maxAngle>(Expert, "refinement.max_angle", "Largest angle", "deg", 1,
                                                           90, "35", "Largest angle between the normals of a pair."),
      number<&Settings::refinement, &Refinement::hiddenDepth>(
          Expert, "refinement.hidden_depth", "Hidden depth", "mm", 0, 1e6, "10",
          "Surface farther behind another view's counts as hidden; auto follows the size of what a scan shows."),
      number<&Settings::refinement, &Refinement::minOverlap>(
          Expert, "refinement.min_overlap", "Least overlap", "", 0, 1, "0.03",
          "Share of a view's points that must meet another view for the two to be tied."),
      number<&Settings::refinement, &Refinement::coarsePoints>(
          Expert, "refinement.coarse_points", "Coarse points", "", 10, kMostPoints, "30000",
          "Points that are looked up per round until the poses settle."),
      number<&Settings::refinement, &Refinement::finePoints>(Expert, "refinement.fine_points", "Fine points", "", 10,
                                                             kMostPoints, "300000",
                                                             "Points that are looked up in the last rounds."),
      number<&Settings::refinement, &Refinement::leastPoints>(
          Expert, "refinement.least_points", "Least points", "", 1, kMostPoints, "500",
          "Points that each direction of a pair of views gets at least."),
      number<&Settings::refinement, &Refinement::maxIterations>(Expert, "refinement.max_iterations", "Most rounds", "",
                                                                1, 100000, "40",
                                                                "Rounds after which the refinement is given up."),
      number<&Settings::refinement, &Refinement::tolerance>(Expert, "refinement.tolerance", "Tolerance", "mm", 1e-9, 10,
                                                            "0.002",
                                                            "The poses have settled when points move less than this."),
      number<&Settings::alignment, &Sampling::pointsPerView>(
          Expert, "alignment.points_per_view", "Points per view", "", 10, kMostPoints, "8000",
          "Points of every placed view that the next recorded scan is registered against."),
      number<&Settings::alignment, &Sampling::finePoints>(
          Expert, "alignment.fine_points", "Fine points", "", 10, kMostPoints, "15000",
          "Points that are looked up in the last rounds of the registration of a recorded scan."),
  };
}

std::vector<SettingField> integrationFields() {
  return {
      number<&Settings::zipper, &Zipper::surfaceTolerance>(
          Expert, "zipper.surface_tolerance", "Surface tolerance", "mm", 0, 1e6, "1",
          "Two surfaces that face the same way and are no farther apart than this are one."),
      number<&Settings::zipper, &Zipper::spacingTolerance>(
          Expert, "zipper.spacing_tolerance", "Spacing tolerance", "samples", 0, 1e6, "1",
          "Two surfaces are also one when they are no farther apart than so many sample spacings of the new view."),
      number<&Settings::zipper, &Zipper::normalTolerance>(
          Expert, "zipper.normal_tolerance", "Normal tolerance", "deg", 0, 180, "72",
          "Two surfaces face the same way when their normals enclose no more than this."),
      number<&Settings::zipper, &Zipper::steepest>(
          Expert, "zipper.steepest", "Steepest surface", "deg", 0, 90, "85",
          "Surface that leans farther than this from the new view's rays is not compared with it."),
      number<&Settings::zipper, &Zipper::confidenceMargin>(
          Expert, "zipper.confidence_margin", "Margin of confidence", "", 0, 1, "0.1",
          "The new view's confidence must exceed the model's by this for its surface to replace the model's."),
      number<&Settings::zipper, &Zipper::clearance>(
          Expert, "zipper.clearance", "Clearance of the seam", "samples", 0, 100, "0.35",
          "Samples of the new view nearer than this to the model's border are left out of the seam."),
      number<&Settings::zipper, &Zipper::discontinuityFactor>(
          Expert, "zipper.discontinuity_factor", "Discontinuity factor", "", 0.1, 100, "1.4",
          "A seam edge so many times longer than that of a surface at the breakdown angle is a gap."),
      number<&Settings::zipper, &Zipper::shortestEdge>(Expert, "zipper.shortest_edge", "Shortest edge", "samples", 0,
                                                       100, "0.3",
                                                       "Edges at the seam that are shorter than this are collapsed."),
      number<&Settings::zipper, &Zipper::maxHoleEdges>(
          Expert, "zipper.max_hole_edges", "Edges of a hole", "", 0, 100000, "16",
          "Holes with no more edges than this are closed where the views have seen surface."),
      number<&Settings::zipper, &Zipper::maxHoleChord>(Expert, "zipper.max_hole_chord", "Chord of a hole", "samples", 0,
                                                       10000, "2.5",
                                                       "Holes are closed when that takes no edge longer than this."),
      number<&Settings::zipper, &Zipper::minIslandTriangles>(Expert, "zipper.min_island_triangles", "Smallest piece",
                                                             "", 0, kMostPoints, "6",
                                                             "Pieces of fewer triangles are dropped."),
      onOff<&Settings::zipper, &Zipper::mend>(
          Expert, "zipper.mend", "Mend", "false",
          "Openings of a model of recorded scans are closed where a view has measured surface, and crumbs go."),
      number<&Settings::consensus, &Consensus::maxOffset>(
          Expert, "consensus.max_offset", "Largest offset", "mm", 0, 1e6, "0.6",
          "A view's surface farther than this along a vertex's normal is another surface."),
      number<&Settings::consensus, &Consensus::spacingOffset>(
          Expert, "consensus.spacing_offset", "Offset in spacings", "samples", 0, 1e6, "0.8",
          "A view's surface within so many of its sample spacings is never another surface."),
      number<&Settings::consensus, &Consensus::normalTolerance>(
          Expert, "consensus.normal_tolerance", "Normal tolerance", "deg", 0, 180, "60",
          "A view has no say when the normals enclose more than this."),
      number<&Settings::consensus, &Consensus::passes>(Expert, "consensus.passes", "Passes", "", 0, 1000, "1",
                                                       "How often the vertices are moved."),
  };
}
// NOLINTEND(readability-magic-numbers)

std::vector<SettingField> allFields() {
  std::vector<SettingField> fields;
  for (auto part : {acquisitionFields(), planningFields(), cutFields(), registrationFields(), integrationFields()})
    fields.insert(fields.end(), part.begin(), part.end());
  return fields;
}

}  // namespace

std::span<const SettingField> settingFields() {
  static const std::vector<SettingField> kFields = allFields();
  return kFields;
}

}  // namespace vantage
