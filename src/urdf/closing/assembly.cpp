// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/assembly.h"

#include "model/linear_algebra.h"
#include "urdf/closing/freedom.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int random_starts = 24;
constexpr int starts_beside = 24;
constexpr int starts_beside_good = 4;  // where only the platform may lack a way to move, or be no platform
constexpr double least_distance_beside = 0.02, max_distance_beside = 0.5;  // of motions of unit length
constexpr int wanted_assemblies = 6;
constexpr int iterations = 120;
constexpr int few_iterations = 40;  // where most mechanisms that are asked about do not close
constexpr int polishing_steps = 12;
constexpr unsigned seed = 20240117;

constexpr double share_inside = 0.05;  // of its range that an actuated joint is moved from a limit

// Of the closures and the actuated joints, and of the platform, away from singularities.
constexpr double good_conditioning = 0.02, good_platform_conditioning = 0.005, usable_conditioning = 0.002;

double largest(const Eigen::VectorXd& vector) {
  return vector.size() > 0 ? vector.lpNorm<Eigen::Infinity>() : 0.0;
}

// Where a joint that turns all the way round has its limits makes no difference.
void clamp_to_limits(const Tree& tree, Eigen::VectorXd& values) {
  for (std::size_t k = 0; k < tree.movable.size(); ++k) {
    if (turns_freely(tree.joint_of(k))) continue;
    double& value = values[static_cast<Eigen::Index>(k)];
    value = std::clamp(value, tree.joint_of(k).limits.lower, tree.joint_of(k).limits.upper);
  }
}

// Of joints that turn all the way round: by whole turns.
void turn_into_limits(const Tree& tree, Eigen::VectorXd& values) {
  for (std::size_t k = 0; k < tree.movable.size(); ++k) {
    const JointLimits& limits = tree.joint_of(k).limits;
    double& value = values[static_cast<Eigen::Index>(k)];
    if (!turns_freely(tree.joint_of(k)) || limits.contain(value) || !limits.limited()) continue;
    const double middle = !std::isfinite(limits.upper)   ? limits.lower + EIGEN_PI
                          : !std::isfinite(limits.lower) ? limits.upper - EIGEN_PI
                                                         : 0.5 * (limits.lower + limits.upper);
    value = middle + std::remainder(value - middle, 2.0 * EIGEN_PI);
  }
}

// The joints that a solver may move, of all the joint values.
class FreeJoints {
 public:
  FreeJoints(const ClosureSystem& system, const std::vector<bool>& held) : system_(system) {
    for (std::size_t k = 0; k < held.size(); ++k)
      if (!held[k] && system.in_loop()[k]) indices_.push_back(static_cast<Eigen::Index>(k));
  }

  bool none() const { return indices_.empty(); }

  /// Columns of the closure Jacobian.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& values) const {
    const Eigen::MatrixXd all = system_.jacobian(values);
    Eigen::MatrixXd columns(all.rows(), static_cast<Eigen::Index>(indices_.size()));
    for (std::size_t k = 0; k < indices_.size(); ++k)
      columns.col(static_cast<Eigen::Index>(k)) = all.col(indices_[k]);
    return columns;
  }

  /// `values` less `step`, of the free joints.
  Eigen::VectorXd moved(Eigen::VectorXd values, const Eigen::VectorXd& step) const {
    for (std::size_t k = 0; k < indices_.size(); ++k)
      values[indices_[k]] -= step[static_cast<Eigen::Index>(k)];
    return values;
  }

 private:
  const ClosureSystem& system_;
  std::vector<Eigen::Index> indices_;
};

// Levenberg-Marquardt.
Eigen::VectorXd closer(const ClosureSystem& system, Eigen::VectorXd values, const FreeJoints& free,
                       int most) {
  double damping = 1e-2;
  clamp_to_limits(system.tree(), values);
  Eigen::VectorXd residual = system.residual(values);
  for (int step = 0; step < most && largest(residual) > 1e-9 * system.size(); ++step) {
    const Eigen::MatrixXd jacobian = free.jacobian(values);
    Eigen::MatrixXd normal = product(jacobian.transpose(), jacobian);
    normal.diagonal().array() += damping * std::max(normal.diagonal().maxCoeff(), 1e-12);
    Eigen::VectorXd next =
        free.moved(values, positive_definite_solution(normal, jacobian.transpose() * residual));
    clamp_to_limits(system.tree(), next);
    const Eigen::VectorXd next_residual = system.residual(next);
    const bool better = next_residual.squaredNorm() < residual.squaredNorm();
    damping = better ? std::max(0.2 * damping, 1e-12) : 5.0 * damping;
    if (damping > 1e8) break;
    if (!better) continue;
    values = next;
    residual = next_residual;
  }
  return values;
}

// Minimum-norm Gauss-Newton steps: quadratic convergence, also where the closures are redundant. A joint that
// runs into a limit stays there.
Eigen::VectorXd polished(const ClosureSystem& system, Eigen::VectorXd values, std::vector<bool> held) {
  double error = largest(system.residual(values));
  for (int step = 0; step < polishing_steps && error > 0.0; ++step) {
    const FreeJoints free(system, held);
    if (free.none()) break;
    const Eigen::VectorXd step_back =
        least_squares_solution(free.jacobian(values), system.residual(values), rank_tolerance);
    const Eigen::VectorXd wanted = free.moved(values, step_back);
    Eigen::VectorXd next = wanted;
    clamp_to_limits(system.tree(), next);
    bool stopped = false;
    for (Eigen::Index k = 0; k < next.size(); ++k) {
      if (next[k] == wanted[k] || held[static_cast<std::size_t>(k)]) continue;
      held[static_cast<std::size_t>(k)] = stopped = true;
    }
    const double next_error = largest(system.residual(next));
    if (!stopped && !(next_error < error)) break;
    values = next;
    error = next_error;
  }
  return values;
}

struct Candidate {
  Assembly assembly;
  double conditioning = 0.0;    // 0 at a singularity of the closures or actuated joints
  PlatformFreedom platform;     // less where legs are stretched or folded
  std::size_t at_limits = 0;    // passive joints that stand on a limit, where legs may be stretched by chance
  std::size_t turned_over = 0;  // revolute closures whose axes are not the way round that is meant

  bool joints_move() const { return conditioning > rank_tolerance; }

  bool is_good() const {
    return at_limits == 0 && conditioning > good_conditioning &&
           platform.conditioning > good_platform_conditioning;
  }

  bool is_usable(std::size_t actuated_joints) const {
    return at_limits == 0 && platform.is_full(actuated_joints) &&
           std::min(conditioning, platform.conditioning) > usable_conditioning;
  }
};

// Columns of the joints inside the loops, with lengths counted in sizes of the robot.
Eigen::MatrixXd loop_scaling(const ClosureSystem& system) {
  const auto& in_loop = system.in_loop();
  Eigen::MatrixXd scaling =
      Eigen::MatrixXd::Zero(system.tree().variables(), std::count(in_loop.begin(), in_loop.end(), true));
  Eigen::Index column = 0;
  for (std::size_t k = 0; k < in_loop.size(); ++k) {
    if (!in_loop[k]) continue;
    const bool prismatic = system.tree().joint_of(k).motion == JointMotion::prismatic;
    scaling(static_cast<Eigen::Index>(k), column++) = prismatic ? system.size() : 1.0;
  }
  return scaling;
}

// How independent the rows are: 0 when there are more of them than columns.
double smallest_singular_value(const Eigen::MatrixXd& rows) {
  if (rows.rows() == 0 || rows.rows() > rows.cols()) return 0.0;
  return singular_values(rows).minCoeff();
}

// Of those that can move: what the loops hold still stands there everywhere.
std::size_t passive_joints_at_limits(const ClosureSystem& system, const Assembly& assembly,
                                     const std::vector<std::size_t>& actuated_joints) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < system.in_loop().size(); ++k) {
    const JointLimits& limits = system.tree().joint_of(k).limits;
    const auto row = static_cast<Eigen::Index>(k);
    const double value = assembly.values[row];
    const double unit = system.tree().joint_of(k).motion == JointMotion::prismatic ? system.size() : 1.0;
    const bool driven = std::find(actuated_joints.begin(), actuated_joints.end(), k) != actuated_joints.end();
    const bool is_still = assembly.motions.row(row).norm() < velocity_tolerance * unit;
    if (system.in_loop()[k] && !driven && !is_still && limits.lower < limits.upper &&
        !turns_freely(system.tree().joint_of(k)))
      count += std::min(value - limits.lower, limits.upper - value) < closing_tolerance;
  }
  return count;
}

// Actuated joints that move independently come first: a mechanism may have other branches, as a parallelogram
// that is crossed. Then least mobility; then a platform that moves in most ways; then good ones, away from
// limits; then the earliest, which is nearest to zero, unless a later one is much better conditioned.
bool is_better(const Candidate& one, const Candidate& other) {
  if (one.joints_move() != other.joints_move()) return one.joints_move();
  const Eigen::Index mobility = one.assembly.motions.cols(), other_mobility = other.assembly.motions.cols();
  if (mobility != other_mobility) return mobility < other_mobility;
  if (one.platform.ways() != other.platform.ways()) return one.platform.ways() > other.platform.ways();
  if (one.turned_over != other.turned_over) return one.turned_over < other.turned_over;
  if (one.is_good() != other.is_good()) return one.is_good();
  return one.conditioning > 5.0 * other.conditioning;
}

// Looks for assembled configurations, and keeps the best.
class Assembler {
 public:
  Assembler(const ClosureSystem& system, const std::vector<std::size_t>& actuated_joints,
            std::size_t platform_link)
      : system_(system),
        actuated_joints_(actuated_joints),
        platform_link_(platform_link),
        none_held_(static_cast<std::size_t>(system.tree().variables()), false),
        pins_(system) {}

  AssemblyResult run() {
    const auto is_wanting = [this] {
      return moving_ < wanted_assemblies || good_ == 0 || best_->turned_over > 0;
    };
    try_from(Eigen::VectorXd::Zero(system_.tree().variables()));
    if (best_ && best_->at_limits > 0) try_from(inside_limits(best_->assembly.values));
    for (int trial = 0; trial < random_starts && is_wanting(); ++trial)
      try_from(random_start(system_, random_));
    const int most = good_ > 0 ? starts_beside_good : starts_beside;
    for (int trial = 0; trial < most && is_poor(); ++trial) try_from(beside_best());
    if (best_) move_inside();
    if (best_) result_.assembly = best_->assembly;
    return std::move(result_);
  }

 private:
  // Where nothing moves there is no way aside.
  bool is_poor() const { return best_ && best_->joints_move() && !best_->is_usable(actuated_joints_.size()); }

  void try_from(const Eigen::VectorXd& start) {
    Eigen::VectorXd values = close_loops(system_, start, none_held_);
    turn_into_limits(system_.tree(), values);
    const double error = largest(system_.residual(values));
    if (error < least_) result_.closest = values;
    least_ = std::min(least_, error);
    if (!(error < closing_tolerance * system_.size())) return;
    const Candidate candidate = judged(values);
    if (candidate.joints_move()) ++moving_;
    if (candidate.is_good()) ++good_;
    if (!best_ || is_better(candidate, *best_)) best_ = candidate;
  }

  // Of their limits: the actuated joints that stand on one, where the rest stays as good, or good enough.
  void move_inside() {
    Eigen::VectorXd start = best_->assembly.values;
    std::vector<bool> held = none_held_;
    for (const std::size_t joint : actuated_joints_) {
      double& value = start[static_cast<Eigen::Index>(joint)];
      held[joint] = inside_limits(joint, value) != value;
      value = inside_limits(joint, value);
    }
    if (held == none_held_) return;
    Eigen::VectorXd values = close_loops(system_, start, held);
    turn_into_limits(system_.tree(), values);
    if (!(largest(system_.residual(values)) < closing_tolerance * system_.size())) return;
    const Candidate moved = judged(values);
    if (!is_better(*best_, moved) || serves_as_well(moved)) best_ = moved;
  }

  bool serves_as_well(const Candidate& moved) const {
    return moved.assembly.motions.cols() == best_->assembly.motions.cols() &&
           moved.is_usable(actuated_joints_.size()) &&
           on_limits(moved.assembly.values) < on_limits(best_->assembly.values);
  }

  std::ptrdiff_t on_limits(const Eigen::VectorXd& values) const {
    return std::count_if(actuated_joints_.begin(), actuated_joints_.end(), [&](std::size_t joint) {
      const double value = values[static_cast<Eigen::Index>(joint)];
      return inside_limits(joint, value) != value;
    });
  }

  // Of joints in the loops that stand on a limit, as those that are drawn there.
  Eigen::VectorXd inside_limits(Eigen::VectorXd values) const {
    for (std::size_t joint = 0; joint < system_.in_loop().size(); ++joint) {
      double& value = values[static_cast<Eigen::Index>(joint)];
      if (system_.in_loop()[joint]) value = inside_limits(joint, value);
    }
    return values;
  }

  double inside_limits(std::size_t joint, double value) const {
    const TreeJoint& of = system_.tree().joint_of(joint);
    const double unit = of.motion == JointMotion::prismatic ? system_.size() : 1.0;
    const double step = share_inside * std::min(of.limits.upper - of.limits.lower, unit);
    if (!(step > 0.0)) return value;
    return std::clamp(value, of.limits.lower + (value - of.limits.lower < closing_tolerance ? step : 0.0),
                      of.limits.upper - (of.limits.upper - value < closing_tolerance ? step : 0.0));
  }

  Candidate judged(const Eigen::VectorXd& values) const {
    const LoopMotions loops = loop_motions(system_, values);
    Candidate candidate;
    candidate.assembly = {values, loops.motions, largest(system_.residual(values)) / system_.size()};
    candidate.conditioning = std::min(
        loops.conditioning,
        smallest_singular_value(actuated_rates(system_, candidate.assembly.motions, actuated_joints_)));
    candidate.platform =
        platform_freedom(system_, candidate.assembly, platform_link_, actuated_joints_.size());
    candidate.at_limits = passive_joints_at_limits(system_, candidate.assembly, actuated_joints_);
    candidate.turned_over = pins_.turned_over(values);
    return candidate;
  }

  // A step of a random motion away, which keeps the loops nearly closed.
  Eigen::VectorXd beside_best() {
    const Eigen::MatrixXd& motions = best_->assembly.motions;
    std::uniform_real_distribution<double> entry(-1.0, 1.0);
    std::uniform_real_distribution<double> distance(least_distance_beside, max_distance_beside);
    Eigen::VectorXd direction(motions.cols());
    for (double& value : coefficients_of(direction)) value = entry(random_);
    return best_->assembly.values + motions * (direction.stableNormalized() * distance(random_));
  }

  const ClosureSystem& system_;
  const std::vector<std::size_t>& actuated_joints_;
  std::size_t platform_link_;
  std::vector<bool> none_held_;
  PinDirections pins_;
  std::mt19937 random_{seed};
  std::optional<Candidate> best_;
  int moving_ = 0, good_ = 0;
  double least_ = std::numeric_limits<double>::infinity();
  AssemblyResult result_;
};

}  // namespace

LoopMotions loop_motions(const ClosureSystem& system, const Eigen::VectorXd& values) {
  const Eigen::MatrixXd scaling = loop_scaling(system);
  const auto svd = singular_value_decomposition(product(system.jacobian(values), scaling));
  const Eigen::Index rank = svd.rank_above(rank_tolerance * svd.values[0]);
  return {product(scaling, svd.null_space(rank)), rank > 0 ? svd.values[rank - 1] / svd.values[0] : 0.0};
}

Eigen::MatrixXd link_twists(const ClosureSystem& system, const Poses& poses, std::size_t link,
                            const Eigen::MatrixXd& motions) {
  Eigen::MatrixXd twists =
      product(velocity_matrix(system.tree(), system.base(), poses, link, poses[link].translation()), motions);
  twists.bottomRows(3) /= system.size();
  return twists;
}

Eigen::VectorXd close_loops(const ClosureSystem& system, Eigen::VectorXd start,
                            const std::vector<bool>& held) {
  const FreeJoints free(system, held);
  return free.none() ? start : polished(system, closer(system, std::move(start), free, iterations), held);
}

std::vector<Eigen::VectorXd> closed_configurations(const ClosureSystem& system, int starts,
                                                   std::size_t wanted) {
  const std::vector<bool> none_held(system.in_loop().size(), false);
  const FreeJoints free(system, none_held);
  std::mt19937 random(seed);
  std::vector<Eigen::VectorXd> closed;
  for (int trial = 0; trial < starts && closed.size() < wanted && !free.none(); ++trial) {
    const Eigen::VectorXd start =
        trial == 0 ? Eigen::VectorXd::Zero(system.tree().variables()) : random_start(system, random);
    const Eigen::VectorXd values = closer(system, start, free, few_iterations);
    if (largest(system.residual(values)) < closing_tolerance * system.size())
      closed.push_back(polished(system, values, none_held));
  }
  return closed;
}

Eigen::VectorXd random_start(const ClosureSystem& system, std::mt19937& random) {
  const Tree& tree = system.tree();
  Eigen::VectorXd values = Eigen::VectorXd::Zero(tree.variables());
  for (std::size_t k = 0; k < tree.movable.size(); ++k) {
    if (!system.in_loop()[k]) continue;
    const TreeJoint& joint = tree.joint_of(k);
    const double range = joint.motion == JointMotion::revolute ? EIGEN_PI : system.size();
    std::uniform_real_distribution<double> value(std::max(joint.limits.lower, -range),
                                                 std::min(joint.limits.upper, range));
    if (value.a() < value.b()) values[static_cast<Eigen::Index>(k)] = value(random);
  }
  clamp_to_limits(tree, values);
  return values;
}

Eigen::MatrixXd actuated_rates(const ClosureSystem& system, const Eigen::MatrixXd& motions,
                               const std::vector<std::size_t>& actuated_joints) {
  Eigen::MatrixXd rates(static_cast<Eigen::Index>(actuated_joints.size()), motions.cols());
  for (std::size_t k = 0; k < actuated_joints.size(); ++k) {
    const bool prismatic = system.tree().joint_of(actuated_joints[k]).motion == JointMotion::prismatic;
    rates.row(static_cast<Eigen::Index>(k)) =
        motions.row(static_cast<Eigen::Index>(actuated_joints[k])) / (prismatic ? system.size() : 1.0);
  }
  return rates;
}

AssemblyResult assemble(const ClosureSystem& system, const std::vector<std::size_t>& actuated_joints,
                        std::size_t platform_link) {
  return Assembler(system, actuated_joints, platform_link).run();
}

}  // namespace parallel_aspects
