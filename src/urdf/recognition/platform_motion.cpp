// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/recognition/platform_motion.h"

#include "model/linear_algebra.h"
#include "model/message_text.h"
#include "urdf/closing/assembly.h"
#include "urdf/recognition/description_rounding.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

Eigen::Index rank(const MatrixXd& matrix) {
  return matrix.size() > 0 ? (singular_values(matrix).array() > velocity_tolerance).count() : 0;
}

MatrixXd null_space(const MatrixXd& matrix) {
  const auto svd = singular_value_decomposition(matrix);
  return svd.null_space(svd.rank_above(velocity_tolerance));
}

// Unit vector whose largest entry is positive, so that the frame does not be attached to the sign of a
// singular vector.
Vector3d oriented(Vector3d direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  direction.normalize();
  return direction[largest] < 0.0 ? Vector3d(-direction) : direction;
}

// Axes with z along `normal`, x along what `reference` shows of it in the plane.
Matrix3d axes_about(const Vector3d& normal, const Matrix3d& reference) {
  const Vector3d first = reference.col(0) - normal * normal.dot(reference.col(0));
  const Vector3d second = reference.col(1) - normal * normal.dot(reference.col(1));
  Matrix3d axes;
  axes.col(2) = normal;
  axes.col(0) = (first.norm() > 0.1 ? first : second).normalized();
  axes.col(1) = normal.cross(axes.col(0));
  return axes;
}

class MotionFinder {
 public:
  MotionFinder(const ClosureSystem& system, const Assembly& assembly, const ActuatedJoints& actuated_joints,
               const SourceNames& files, Problems& problems)
      : system_(system),
        actuated_joints_(actuated_joints),
        files_(files),
        problems_(problems),
        values_(assembly.values),
        motions_(assembly.motions) {
    poses_ = link_poses(system.tree(), system.base(), assembly.values);
    link_ = poses_[actuated_joints.platform_link];
    twists_ = velocity_matrix(system.tree(), system.base(), poses_, actuated_joints.platform_link,
                              link_.translation()) *
              assembly.motions;
    twists_.bottomRows(3) /= system.size();
    joint_rates_.resize(static_cast<Eigen::Index>(actuated_joints.variables.size()), motions_.cols());
    for (std::size_t j = 0; j < actuated_joints.variables.size(); ++j) {
      const bool prismatic =
          system.tree().joint_of(actuated_joints.variables[j]).motion == JointMotion::prismatic;
      joint_rates_.row(static_cast<Eigen::Index>(j)) =
          motions_.row(static_cast<Eigen::Index>(actuated_joints.variables[j])) /
          (prismatic ? system.size() : 1.0);
    }
  }

  std::optional<PlatformMotion> find() {
    result_.mobility = motions_.cols();
    if (!check_mobility()) return std::nullopt;
    if (!find_space()) return std::nullopt;
    return result_;
  }

 private:
  bool refuse(const std::string& text) {
    problems_.push_back(files_.config + " " + text);
    return false;
  }

  bool check_mobility() {
    const Eigen::Index count = joint_rates_.rows();
    const Eigen::Index independent = rank(joint_rates_);
    const std::string numbers = "actuates " + actuated_names() + ", but the closed mechanism of " +
                                files_.urdf + " has mobility " + std::to_string(result_.mobility);
    if (independent < count)
      return refuse(
          numbers + ", and only " + std::to_string(independent) + " of the " + std::to_string(count) +
          " actuated joints can move independently" + held_text() +
          "; compare axes, origins and types of the joints in the loops with the robot, and types of "
          "closures, of which a revolute one turns about z of its frames.");
    const MatrixXd locked = null_space(joint_rates_);
    result_.idle = locked.cols();
    const MatrixXd free_twists = parallel_aspects::product(twists_, locked);
    const Eigen::Index angular = rank(free_twists.topRows(3)), linear = rank(free_twists.bottomRows(3));
    point_may_spin_ = angular > 0 && linear == 0 && (count == 2 || count == 3);
    if (linear > 0 || (angular > 0 && !point_may_spin_))
      return refuse(numbers + ", and the platform still moves with the actuated joints locked; list more " +
                    files_.key("actuated_joints") + ", or correct closures that hold too little.");
    return true;
  }

  // Of the actuated joints, those that nothing moves.
  std::string held_text() const {
    std::string text;
    for (Eigen::Index j = 0; j < joint_rates_.rows(); ++j)
      if (joint_rates_.row(j).norm() < velocity_tolerance)
        text += (text.empty() ? ", as the loops hold '" : ", '") +
                system_.tree().joint_of(actuated_joints_.variables[static_cast<std::size_t>(j)]).name + "'";
    return text;
  }

  std::string actuated_names() const {
    std::string text;
    for (const std::size_t variable : actuated_joints_.variables)
      text += (text.empty() ? "'" : ", '") + system_.tree().joint_of(variable).name + "'";
    return text;
  }

  bool find_space() {
    const Eigen::Index count = joint_rates_.rows();
    if (!point_may_spin_ && rank(twists_) == count && hangs_on_hinges()) return hinges();
    if (count == 1 && rank(linear()) == 1 && rank(angular()) == 0) return line();
    if (count == 2 && rank(linear()) == 2) return plane_of_points();
    if (count == 3 && !point_may_spin_ && rank(twists_) == 3) {
      if (rank(angular()) == 0) return translations(false);
      if (plane_of_motion() || rotations()) return true;
    }
    if (count == 3 && rank(linear()) == 3) return translations(true);
    if (count == 6 && rank(twists_) == 6) return all_motions();
    return refuse(
        "names " + operational_point_text(system_.tree(), actuated_joints_.platform_link, files_) +
        ", which moves in none of the task spaces T1, R1 (1 actuated joint), T2, R2 (2 actuated joints), "
        "SE2, "
        "T3, SO3 (3 actuated joints) or SE3 (6 actuated joints), but with " +
        std::to_string(rank(angular())) + " rotations and " + std::to_string(rank(linear())) +
        " translations for " + std::to_string(count) +
        " actuated joints; name a link of the body that all legs share, or where they meet, else the robot "
        "is not "
        "supported.");
  }

  // Whether a passive chain of as many revolute joints as are actuated joins the platform to the base, and no
  // two of them are parallel.
  bool hangs_on_hinges() {
    const AssembledMechanism mechanism{system_, values_, std::vector<bool>(system_.in_loop().size(), false)};
    for (const JoiningPart& part : joining_parts(mechanism, actuated_joints_, files_)) {
      if (part.is_actuated || part.chains.size() != 1) continue;
      const Chain& chain = part.chains.front();
      const bool turns = std::all_of(chain.begin(), chain.end(),
                                     [](const Pivot& pivot) { return pivot.kind == PivotKind::revolute; });
      if (!turns || static_cast<Eigen::Index>(chain.size()) != joint_rates_.rows() || chain.size() > 2)
        continue;
      if (chain.size() == 2 && chain[0].axis.cross(chain[1].axis).norm() < HingePair::least_sine) continue;
      result_.hinge_chain = chain;
      return true;
    }
    return false;
  }

  double value_of(const Pivot& pivot) const {
    return pivot.variable ? values_[static_cast<Eigen::Index>(*pivot.variable)] : 0.0;
  }

  // What rounding leaves of one.
  static double right_angle(double angle) {
    constexpr double half_pi = 0.5 * EIGEN_PI, rounding = 1e-12;
    return std::abs(angle - half_pi) < rounding ? half_pi : angle;
  }

  bool hinges() {
    if (result_.hinge_chain.size() == 1) return one_hinge();
    return two_hinges();
  }

  bool one_hinge() {
    const Pivot& pivot = result_.hinge_chain.front();
    const Vector3d axis = (pivot.sense * pivot.axis).normalized();
    result_.space = TaskSpace::R1;
    result_.task_frame.linear() = axes_about(axis, Matrix3d::Identity());
    result_.task_frame.translation() = pivot.point + axis * axis.dot(link_.translation() - pivot.point);
    place_platform(Eigen::VectorXd::Constant(1, value_of(pivot)));
    return true;
  }

  // As both joints are at zero.
  bool two_hinges() {
    const Pivot &first = result_.hinge_chain[0], &second = result_.hinge_chain[1];
    const Vector3d axis = (first.sense * first.axis).normalized();
    const Matrix3d back = Eigen::AngleAxisd(-value_of(first), axis).toRotationMatrix();
    const Vector3d other = back * (second.sense * second.axis).normalized();
    const Vector3d between = back * (second.point - first.point);
    const Vector3d normal = axis.cross(other);
    Matrix3d ways;  // along the first axis, the common normal, and back along the second axis
    ways << axis, normal.normalized(), -other;
    const Vector3d lengths = ways.inverse() * between;
    result_.space = TaskSpace::R2;
    result_.hinges.offset = without_rounding_noise(lengths[1], system_.size());
    result_.hinges.twist = right_angle(std::atan2(normal.norm(), axis.dot(other)));
    result_.task_frame.linear().col(0) = normal.normalized();
    result_.task_frame.linear().col(1) = axis.cross(normal.normalized());
    result_.task_frame.linear().col(2) = axis;
    result_.task_frame.translation() = first.point + lengths[0] * axis;
    place_platform(Eigen::Vector2d(value_of(first), value_of(second)));
    return true;
  }

  void place_platform(const PoseCoordinates& angles) {
    const auto pose = pose_from_coordinates({result_.space, result_.hinges}, angles);
    if (pose)
      result_.platform =
          result_.task_frame * Eigen::Isometry3d(Eigen::Translation3d(pose->position) * pose->orientation);
  }

  MatrixXd angular() const { return twists_.topRows(3); }
  MatrixXd linear() const { return twists_.bottomRows(3); }

  // The leg is in a plane through the line, whose normal its joints determine.
  bool line() {
    const Vector3d along = oriented(singular_value_decomposition(linear()).u.col(0));
    const Vector3d normal = normal_of_joints(along);
    result_.space = TaskSpace::T1;
    result_.task_frame.linear() << along, normal.cross(along), normal;
    result_.task_frame.translation() = link_.translation() - along * along.dot(link_.translation());
    result_.platform.linear() = result_.task_frame.linear();
    result_.platform.translation() = link_.translation();
    return true;
  }

  Vector3d normal_of_joints(const Vector3d& along) const {
    for (std::size_t k = 0; k < system_.in_loop().size(); ++k) {
      const TreeJoint& joint = system_.tree().joint_of(k);
      const Vector3d axis = poses_[joint.child].linear() * joint.axis;
      const bool across = std::abs(axis.dot(along)) < velocity_tolerance;
      if (system_.in_loop()[k] && joint.motion == JointMotion::revolute && across)
        return oriented(axis - along * along.dot(axis));
    }
    return along.unitOrthogonal();
  }

  bool plane_of_points() {
    const Vector3d normal = oriented(singular_value_decomposition(linear()).u.col(2));
    result_.space = TaskSpace::T2;
    result_.point_platform = rank(angular()) > 0;
    set_plane(normal, axes_about(normal, Matrix3d::Identity()));
    return true;
  }

  bool plane_of_motion() {
    const auto svd = singular_value_decomposition(angular());
    if (svd.rank_above(velocity_tolerance) != 1) return false;
    const Vector3d normal = oriented(svd.u.col(0));
    if ((normal.transpose() * linear()).norm() > velocity_tolerance) return false;
    result_.space = TaskSpace::SE2;
    set_plane(normal, axes_about(normal, link_.linear()));
    return true;
  }

  void set_plane(const Vector3d& normal, const Matrix3d& platform_axes) {
    result_.task_frame.linear() = axes_about(normal, Matrix3d::Identity());
    result_.task_frame.translation() = normal * normal.dot(link_.translation());
    result_.platform.linear() = platform_axes;
    result_.platform.translation() = link_.translation();
  }

  // A centre at r from the operational point rests: v + w x r = 0 for all twists.
  bool rotations() {
    if (rank(angular()) != 3) return false;
    MatrixXd equations(3 * twists_.cols(), 3);
    Eigen::VectorXd known(3 * twists_.cols());
    for (Eigen::Index k = 0; k < twists_.cols(); ++k) {
      const Vector3d w = twists_.col(k).head<3>();
      equations.middleRows<3>(3 * k) << 0.0, -w.z(), w.y(), w.z(), 0.0, -w.x(), -w.y(), w.x(), 0.0;
      known.segment<3>(3 * k) = -twists_.col(k).tail<3>();
    }
    const Vector3d to_center = least_squares_solution(equations, known, velocity_tolerance);
    if ((equations * to_center - known).norm() > velocity_tolerance) return false;
    result_.space = TaskSpace::SO3;
    result_.task_frame.translation() = link_.translation() + system_.size() * to_center;
    result_.platform.linear() = link_.linear();
    result_.platform.translation() = result_.task_frame.translation();
    return true;
  }

  bool translations(bool of_a_point) {
    result_.space = TaskSpace::T3;
    result_.point_platform = of_a_point;
    result_.platform.translation() = link_.translation();
    return true;
  }

  bool all_motions() {
    result_.space = TaskSpace::SE3;
    result_.platform = link_;
    return true;
  }

  const ClosureSystem& system_;
  const ActuatedJoints& actuated_joints_;
  const SourceNames& files_;
  Problems& problems_;
  Eigen::VectorXd values_;
  MatrixXd motions_;
  MatrixXd twists_;       // of the platform link at the operational point: w [rad], v over the size
  MatrixXd joint_rates_;  // by motion
  Poses poses_;
  Eigen::Isometry3d link_;
  bool point_may_spin_ = false;
  PlatformMotion result_;
};

}  // namespace

std::optional<PlatformMotion> find_platform_motion(const ClosureSystem& system, const Assembly& assembly,
                                                   const ActuatedJoints& actuated_joints,
                                                   const SourceNames& files, Problems& problems) {
  return MotionFinder(system, assembly, actuated_joints, files, problems).find();
}

namespace {

// The joints that only one of the chains has, from the first to the last.
Chain own_part(const Chain& chain, const Chain& other) {
  Chain own;
  for (const Pivot& pivot : chain)
    if (std::none_of(other.begin(), other.end(), [&](const Pivot& one) { return one.name == pivot.name; }))
      own.push_back(pivot);
  return own;
}

// Of two rods: how far apart they are at both ends, and how long [m].
struct RodPair {
  Chain one, other;

  double apart_at_start() const { return (one.front().point - other.front().point).norm(); }
  double apart_at_end() const { return (one.back().point - other.back().point).norm(); }
  static double length(const Chain& rod) { return (rod.back().point - rod.front().point).norm(); }

  double misfit() const {
    return std::max(std::abs(apart_at_start() - apart_at_end()), std::abs(length(one) - length(other)));
  }
};

std::string text_of(const RodPair& pair) {
  return "the rods from '" + pair.one.front().name + "' to '" + pair.one.back().name + "' and from '" +
         pair.other.front().name + "' to '" + pair.other.back().name + "' are " +
         number_text(RodPair::length(pair.one), 4) + " and " + number_text(RodPair::length(pair.other), 4) +
         " m long, and their ends " + number_text(pair.apart_at_start(), 4) + " and " +
         number_text(pair.apart_at_end(), 4) + " m apart";
}

}  // namespace

std::optional<std::string> reason_to_turn(const std::vector<LegChains>& legs, double size) {
  std::optional<RodPair> worst;
  for (const LegChains& leg : legs) {
    if (leg.chains.size() != 2) continue;
    RodPair pair{own_part(leg.chains[0], leg.chains[1]), own_part(leg.chains[1], leg.chains[0])};
    if (pair.one.size() < 2 || pair.other.size() < 2) continue;
    if (!worst || pair.misfit() > worst->misfit()) worst = std::move(pair);
  }
  if (!worst) return std::nullopt;
  return worst->misfit() > closing_tolerance * size
             ? text_of(*worst) + "; make them equal, by the origins of their frames"
             : std::string(
                   "the pairs are parallelograms, but turned against each other on base and platform; "
                   "compare "
                   "the rpy of the frames of each leg there, and which ends its closures hold");
}

}  // namespace parallel_aspects
