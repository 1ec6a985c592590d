#include "registration/pose_list.h"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr double kLeastTurn = radians(2.0);
const double kSameAxis = std::cos(radians(8.0));
constexpr std::array<double, 6> kUnits{1000.0, 0.001, 25.4, 1.0 / 25.4, 10.0, 0.1};
constexpr double kLeastTurnsFault = 0.01;
constexpr double kExplained = 0.5;  // of the differences that must go

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * kPi);
}

double turnAbout(const Pose& motion, const Vec3& axis) {
  const Eigen::Quaterniond q(Eigen::Matrix3d(motion.linear()));
  return wrapped(2.0 * std::atan2(q.vec().dot(axis), q.w()));
}

Pose turnAboutLine(const Vec3& point, const Vec3& axis, double angle) {
  Pose turn = Pose::Identity();
  turn.linear() = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  turn.translation() = point - turn.linear() * point;
  return turn;
}

// The direction that all turns share; nothing where they do not.
std::optional<Vec3> sharedAxis(const std::vector<Pose>& motions) {
  Vec3 sum = Vec3::Zero();
  for (const Pose& motion : motions) {
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(motion.linear()));
    const double weight = std::sin(0.5 * turn.angle());
    sum += (sum.dot(turn.axis()) < 0.0 ? -weight : weight) * turn.axis();
  }
  if (sum.norm() < std::sin(0.5 * kLeastTurn)) return std::nullopt;
  const Vec3 axis = sum.normalized();
  for (const Pose& motion : motions) {
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(motion.linear()));
    if (turn.angle() > 2.0 * kLeastTurn && std::abs(turn.axis().dot(axis)) < kSameAxis) return std::nullopt;
  }
  return axis;
}

// The point that the turns leave where it is, as near to the origin as there is one.
Vec3 pointOnAxis(const std::vector<Pose>& motions) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  for (const Pose& motion : motions) {
    const Eigen::Matrix3d a = Eigen::Matrix3d::Identity() - motion.linear();
    normal += a.transpose() * a;
    right += a.transpose() * motion.translation();
  }
  Eigen::JacobiSVD<Eigen::Matrix3d> svd(normal, Eigen::ComputeFullU | Eigen::ComputeFullV);
  svd.setThreshold(1e-3);
  return svd.solve(right);
}

double rms(const std::vector<double>& values) {
  double squares = 0.0;
  for (const double v : values) squares += v * v;
  return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(values.size(), 1)));
}

std::optional<PoseListFinding> turnsFault(const ListedTurns& listed, std::span<const Pose> found, double radius,
                                          double least) {
  double products = 0.0;
  double squares = 0.0;
  std::vector<double> turned{0.0};
  for (std::size_t i = 1; i < found.size(); ++i) {
    const double angle = turnAbout(found[i] * found.front().inverse(), listed.axis);
    // The whole turns that were not seen are those of the scan before.
    const double expected = turned.back() + (listed.angles[i] - listed.angles[i - 1]);
    turned.push_back(expected + wrapped(angle - expected));
    products += turned[i] * listed.angles[i];
    squares += listed.angles[i] * listed.angles[i];
  }
  if (squares <= 0.0) return std::nullopt;
  const double factor = products / squares;
  std::vector<double> before;
  std::vector<double> after;
  for (std::size_t i = 1; i < turned.size(); ++i) {
    before.push_back(radius * (turned[i] - listed.angles[i]));
    after.push_back(radius * (turned[i] - factor * listed.angles[i]));
  }
  if (std::abs(factor - 1.0) < kLeastTurnsFault || rms(before) < least || rms(after) > kExplained * rms(before))
    return std::nullopt;
  return PoseListFinding{PoseListFault::Turns, factor};
}

// Poses that differ by (R_i - R_0) b, b a shift in the scanner's frame: the axis is b beside where the list has it.
std::optional<PoseListFinding> axisFault(std::span<const Pose> given, std::span<const Pose> found, double least) {
  const Pose T_found_given = found.front() * given.front().inverse();
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  const auto difference = [&](std::size_t i) -> Vec3 {
    return found[i].translation() - T_found_given * given[i].translation();
  };
  const auto lever = [&](std::size_t i) -> Eigen::Matrix3d { return found[i].linear() - found.front().linear(); };
  for (std::size_t i = 1; i < given.size(); ++i) {
    normal += lever(i).transpose() * lever(i);
    right += lever(i).transpose() * difference(i);
  }
  Eigen::JacobiSVD<Eigen::Matrix3d> svd(normal, Eigen::ComputeFullU | Eigen::ComputeFullV);
  svd.setThreshold(1e-2);
  const Vec3 beside = svd.solve(right);
  std::vector<double> before;
  std::vector<double> after;
  for (std::size_t i = 1; i < given.size(); ++i) {
    before.push_back(difference(i).norm());
    after.push_back((difference(i) - lever(i) * beside).norm());
  }
  if (beside.norm() < least || rms(before) < least || rms(after) > kExplained * rms(before)) return std::nullopt;
  return PoseListFinding{PoseListFault::Axis, beside.norm()};
}

}  // namespace

std::optional<ListedTurns> turnsOf(std::span<const Pose> poses) {
  if (poses.size() < 2) return std::nullopt;
  std::vector<Pose> motions;
  for (const Pose& pose : poses) motions.push_back(pose * poses.front().inverse());
  const auto axis = sharedAxis(motions);
  if (!axis) return std::nullopt;
  ListedTurns turns{*axis, pointOnAxis(motions), {0.0}};
  for (std::size_t i = 1; i < poses.size(); ++i)
    turns.angles.push_back(turns.angles.back() +
                           wrapped(turnAbout(motions[i], *axis) - turnAbout(motions[i - 1], *axis)));
  return turns;
}

MendedList withTurns(std::span<const Pose> poses, const ListedTurns& turns, double factor) {
  MendedList list{{PoseListFault::Turns, factor}, {}};
  for (std::size_t i = 0; i < poses.size(); ++i)
    list.poses.push_back(turnAboutLine(turns.point, turns.axis, (factor - 1.0) * turns.angles[i]) * poses[i]);
  return list;
}

std::vector<MendedList> mendedLists(std::span<const Pose> poses) {
  std::vector<MendedList> lists;
  MendedList inverted{{PoseListFault::Inverted, 1.0}, {}};
  for (const Pose& pose : poses) inverted.poses.push_back(pose.inverse());
  lists.push_back(std::move(inverted));
  for (const double unit : kUnits) {
    MendedList list{{PoseListFault::Unit, unit}, {poses.begin(), poses.end()}};
    for (Pose& pose : list.poses) pose.translation() *= unit;
    lists.push_back(std::move(list));
  }
  for (int axis = 0; axis < 3; ++axis) {
    MendedList list{{PoseListFault::Frame, axis + 1.0}, {poses.begin(), poses.end()}};
    Vec3 signs = -Vec3::Ones();
    signs[axis] = 1.0;
    for (Pose& pose : list.poses) pose.linear() = Eigen::Matrix3d(pose.linear() * signs.asDiagonal());
    lists.push_back(std::move(list));
  }
  return lists;
}

std::optional<PoseListFinding> commonFault(std::span<const Pose> given, std::span<const Pose> found, double least) {
  if (given.size() != found.size()) throw InvalidInput("a list of poses is compared with as many found poses");
  if (given.size() < 3) return std::nullopt;
  const auto listed = turnsOf(given);
  if (!listed) return std::nullopt;
  double radius = 0.0;
  for (const Pose& pose : given) radius = std::max(radius, (pose.translation() - listed->point).norm());
  // Scans about the axis itself are as far from it as one millimetre on a turn of one radian shows.
  if (auto turns = turnsFault(*listed, found, std::max(radius, 20.0 * least), least)) return turns;
  return axisFault(given, found, least);
}

}  // namespace vantage
