// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/recognition/leg_recognition.h"

#include "model/linear_algebra.h"
#include "parallel_aspects/model/manipulator.h"
#include "urdf/recognition/description_rounding.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Of the assembled configuration, over the size of the robot.
constexpr double rounding_share = 1e-14;

double distance_to_axis(const Vector3d& point, const Pivot& pivot) {
  return (point - pivot.point).cross(pivot.axis).norm();
}

class ChainRecogniser {
 public:
  ChainRecogniser(const LegSetting& setting, std::size_t actuated_variable)
      : setting_(setting), motion_(*setting.motion), actuated_variable_(actuated_variable) {}

  /// Why the last chain could not be split.
  const std::string& reason() const { return reason_; }

  std::optional<SplitChain> split(const Chain& chain) {
    const auto actuation = std::find_if(
        chain.begin(), chain.end(), [&](const Pivot& pivot) { return pivot.variable == actuated_variable_; });
    if (actuation == chain.end()) return fail("moves the platform past its actuated joint");
    const Chain before = flattened({chain.begin(), actuation});
    Chain after = flattened({actuation + 1, chain.end()});
    // A platform that is a point holds every leg as a ball joint does.
    if (motion_.point_platform)
      after.push_back(
          {PivotKind::ball, "operational point", motion_.platform.translation(), {}, std::nullopt, 1.0});
    SplitChain found;
    found.actuation = *actuation;
    found.actuated_first = before.empty();
    if (!divide(before, after, found)) return std::nullopt;
    if (motion_.point_platform) found.distal.pop_back();
    return found;
  }

 private:
  std::nullopt_t fail(const std::string& text) {
    reason_ = text;
    return std::nullopt;
  }

  // In the plane a ball joint turns about the normal.
  Chain flattened(Chain chain) const {
    if (!setting_.planar) return chain;
    for (Pivot& pivot : chain) {
      if (pivot.kind != PivotKind::ball) continue;
      pivot.kind = PivotKind::revolute;
      pivot.axis = motion_.task_frame.linear().col(2);
    }
    return chain;
  }

  void fail_to_end() {
    fail(
        "does not end in the operational point; move that to where the legs meet, since B would not be "
        "diagonal");
  }

  // Into the pivots about c and those about p.
  bool divide(const Chain& before, const Chain& after, SplitChain& found) {
    if (!before.empty()) {
      if (group(before, after, found)) return true;
      if (motion_.point_platform && group(before, {after.begin(), after.end() - 1}, found)) fail_to_end();
      return false;
    }
    fail("keeps no point of the platform at a fixed distance from a point of its actuated link");
    if (cut(after, found)) return true;
    if (motion_.point_platform && cut({after.begin(), after.end() - 1}, found))
      fail_to_end();
    else if (is_three_revolute_arm(found.actuation, after))
      fail(
          "is an arm of three revolute joints whose passive axes do not meet: such a leg is in general "
          "cuspidal, it can "
          "change its posture without a serial singularity, and working modes separate the inverse solutions "
          "only if no "
          "leg is cuspidal (Chablat and Wenger, theorem 1)");
    return false;
  }

  bool cut(const Chain& after, SplitChain& found) {
    for (std::size_t count = 1; count < after.size(); ++count) {
      const auto middle = after.begin() + static_cast<std::ptrdiff_t>(count);
      if (group({after.begin(), middle}, {middle, after.end()}, found)) return true;
    }
    return false;
  }

  // Three revolute joints that place a point of the platform.
  bool is_three_revolute_arm(const Pivot& actuation, const Chain& after) const {
    return actuation.kind == PivotKind::revolute && after.size() > 2 &&
           after[0].kind == PivotKind::revolute && after[1].kind == PivotKind::revolute &&
           tip({after.begin() + 2, after.end()}, true);
  }

  bool group(const Chain& proximal, const Chain& distal, SplitChain& found) {
    const auto c = tip(proximal, found.actuated_first), p = tip(distal, found.actuated_first);
    if (!c || !p) {
      if (!found.actuated_first)
        fail("has passive joints on one side of its actuated joint whose axes do not meet in a point");
      return false;
    }
    if (same(*p, *c)) {
      fail("has a rod of length zero");
      return false;
    }
    found.proximal = proximal;
    found.distal = distal;
    found.c = *c;
    found.p = *p;
    found.on_unit_sphere = is_drawn(proximal) && is_drawn(distal) && found.actuated_first;
    found.proximal_center = center_of(proximal, *c);
    found.distal_center = center_of(distal, *p);
    return true;
  }

  bool same(const Vector3d& one, const Vector3d& other) const {
    return (one - other).norm() < direction_tolerance * setting_.size;
  }

  // The point that all pivots of a group turn about, as far as the task space can show. Rods that change
  // their length need their true ends.
  std::optional<Vector3d> tip(const Chain& group, bool rod_is_rigid) const {
    if (group.empty()) return std::nullopt;
    for (const Pivot& pivot : group)
      if (pivot.kind == PivotKind::prismatic) return std::nullopt;
    if (setting_.planar) {
      const auto point = common(group, [this](const Pivot& pivot) { return in_plane(pivot); });
      return point ? point : meeting_point(group);
    }
    if (motion_.space != TaskSpace::SO3) return meeting_point(group);
    const auto drawn = drawn_tip(group);
    const auto true_end = meeting_point(group);
    const bool is_beside = true_end && !same(*true_end, motion_.task_frame.translation());
    return is_beside && !(rod_is_rigid && drawn) ? true_end : drawn;
  }

  std::optional<Vector3d> drawn_tip(const Chain& group) const {
    return common(group, [this](const Pivot& pivot) { return on_sphere(pivot); });
  }

  // Where the rod is rigid, such a tip is taken before a true one.
  bool is_drawn(const Chain& group) const {
    return motion_.space == TaskSpace::SO3 && drawn_tip(group).has_value();
  }

  // A point on the axes of all pivots of the group.
  Vector3d center_of(const Chain& group, const Vector3d& tip) const {
    const Vector3d center = motion_.task_frame.translation();
    const bool about_center =
        motion_.space == TaskSpace::SO3 && std::all_of(group.begin(), group.end(), [&](const Pivot& pivot) {
          return pivot.kind == PivotKind::ball || distance_to_axis(center, pivot) < tolerance();
        });
    return about_center ? center : tip;
  }

  double tolerance() const { return direction_tolerance * setting_.size; }

  template <class Point>
  std::optional<Vector3d> common(const Chain& group, Point point) const {
    const std::optional<Vector3d> first = point(group.front());
    for (const Pivot& pivot : group) {
      const std::optional<Vector3d> other = point(pivot);
      if (!first || !other || !same(*first, *other)) return std::nullopt;
    }
    return first;
  }

  std::optional<Vector3d> in_plane(const Pivot& pivot) const {
    const Vector3d normal = motion_.task_frame.linear().col(2);
    if (pivot.kind == PivotKind::revolute && pivot.axis.cross(normal).norm() > direction_tolerance)
      return std::nullopt;
    return pivot.point - normal * normal.dot(pivot.point - motion_.task_frame.translation());
  }

  // Legs of a spherical robot are drawn on the unit sphere about the centre.
  std::optional<Vector3d> on_sphere(const Pivot& pivot) const {
    const Vector3d center = motion_.task_frame.translation();
    const Vector3d out = pivot.point - center;
    if (pivot.kind == PivotKind::ball) {
      if (out.norm() < direction_tolerance * setting_.size) return std::nullopt;
      return center + out.normalized();
    }
    if (distance_to_axis(center, pivot) > direction_tolerance * setting_.size) return std::nullopt;
    return center + (out.dot(pivot.axis) < -direction_tolerance * setting_.size ? -pivot.axis : pivot.axis);
  }

  std::optional<Vector3d> meeting_point(const Chain& group) const {
    Matrix3d normal = Matrix3d::Zero();
    Vector3d moment = Vector3d::Zero();
    for (const Pivot& pivot : group) {
      Matrix3d across = Matrix3d::Identity();
      if (pivot.kind == PivotKind::revolute) across -= pivot.axis * pivot.axis.transpose();
      normal += across;
      moment += across * pivot.point;
    }
    if (symmetric_eigenvalues(normal)[0] < 1e-3) return std::nullopt;  // parallel axes
    const Vector3d point = positive_definite_solution(normal, moment);
    for (const Pivot& pivot : group) {
      const double off =
          pivot.kind == PivotKind::ball ? (point - pivot.point).norm() : distance_to_axis(point, pivot);
      if (off > direction_tolerance * setting_.size) return std::nullopt;
    }
    return point;
  }

  const LegSetting& setting_;
  const PlatformMotion& motion_;
  std::size_t actuated_variable_;
  std::string reason_;
};

// Writes the distance equation of a split chain in the task frame.
class LegBuilder {
 public:
  explicit LegBuilder(const LegSetting& setting)
      : setting_(setting), motion_(*setting.motion), to_task_(setting.motion->task_frame.inverse()) {}

  const std::string& reason() const { return reason_; }

  std::optional<Leg> build(const SplitChain& chain) {
    Leg leg;
    leg.name = setting_.name;
    leg.actuated_joint = chain.actuation.name;
    leg.limits = setting_.limits;
    leg.anchor = flat(motion_.platform.inverse() * chain.p);
    Vector3d c = point(chain.c), p = point(chain.p);
    if (chain.on_unit_sphere)
      for (Vector3d* each : {&leg.anchor, &c, &p}) each->normalize();
    const auto actuation = chain.actuated_first ? moving_joint(chain, c) : rod_joint(chain.actuation, c, p);
    if (!actuation) return std::nullopt;
    leg.actuation = *actuation;
    if (chain.actuated_first) leg.rod_length = (p - c).norm();
    // Spherical robots are drawn on the unit sphere.
    return without_rounding_noise(leg, motion_.space == TaskSpace::SO3 ? 1.0 : setting_.size);
  }

 private:
  std::nullopt_t fail(const std::string& text) {
    reason_ = text;
    return std::nullopt;
  }

  // Into the plane of a planar robot; what rounding left of a zero becomes zero.
  Vector3d flat(Vector3d vector) const {
    if (setting_.planar) vector.z() = 0.0;
    const double zero = rounding_share * setting_.size;
    return vector.unaryExpr([zero](double entry) { return std::abs(entry) < zero ? 0.0 : entry; });
  }
  Vector3d point(const Vector3d& in_base) const { return flat(to_task_ * in_base); }

  double tolerance() const { return direction_tolerance * setting_.size; }

  std::optional<Vector3d> axis(const Pivot& actuation) {
    Vector3d direction = actuation.sense * (to_task_.linear() * actuation.axis);
    if (!setting_.planar) return direction.normalized();
    const bool revolute = actuation.kind == PivotKind::revolute;
    const double off = revolute ? direction.head<2>().norm() : std::abs(direction.z());
    if (off > direction_tolerance)
      return fail(revolute ? "is actuated about an axis that is not normal to the plane of motion"
                           : "is actuated along a direction that is not in the plane of motion");
    direction = revolute ? Vector3d(0.0, 0.0, std::copysign(1.0, direction.z())) : flat(direction);
    return direction.normalized();
  }

  std::optional<Actuation> moving_joint(const SplitChain& chain, const Vector3d& c) {
    const Pivot& actuation = chain.actuation;
    const auto direction = axis(actuation);
    if (!direction) return std::nullopt;
    if (actuation.kind == PivotKind::prismatic)
      return PrismaticActuation{c - setting_.joint_value * *direction, *direction};
    const Vector3d on_axis = point(actuation.point);
    if (motion_.space == TaskSpace::SO3 && on_axis.cross(*direction).norm() > tolerance())
      return fail("is actuated about an axis that misses the centre of the spherical motion");
    // What it misses the center by was taken for rounding above; on the unit sphere the model has none of it.
    const Vector3d through = chain.on_unit_sphere ? Vector3d(Vector3d::Zero()) : on_axis;
    const Vector3d center = through + *direction * direction->dot(c - through);
    const Vector3d arm = c - center;
    if (arm.norm() < tolerance()) return fail("has a crank of length zero");
    const Vector3d zero = Eigen::AngleAxisd(-setting_.joint_value, *direction) * arm.normalized();
    return RevoluteActuation{center, *direction, (zero - *direction * direction->dot(zero)).normalized(),
                             arm.norm()};
  }

  std::optional<Actuation> rod_joint(const Pivot& actuation, const Vector3d& c, const Vector3d& p) {
    const auto direction = axis(actuation);
    if (!direction) return std::nullopt;
    return actuation.kind == PivotKind::prismatic ? strut(*direction, c, p)
                                                  : elbow(*direction, point(actuation.point), c, p);
  }

  std::optional<Actuation> strut(const Vector3d& direction, const Vector3d& c, const Vector3d& p) {
    const Vector3d rod = p - c;
    if (rod.cross(direction).norm() > tolerance())
      return fail("is a strut whose slide does not point from one end joint to the other");
    const double sense = rod.dot(direction) > 0.0 ? 1.0 : -1.0;
    return StrutActuation{c, rod.norm() - sense * setting_.joint_value, sense};
  }

  std::optional<Actuation> elbow(const Vector3d& direction, const Vector3d& on_axis, const Vector3d& c,
                                 const Vector3d& p) {
    if (std::abs(direction.dot(p - c)) > tolerance())
      return fail("is actuated at an elbow whose axis is not orthogonal to the plane of its two links");
    const Vector3d hinge = on_axis + direction * direction.dot(c - on_axis);
    const Vector3d inner = hinge - c, outer = p - hinge;
    if (inner.norm() < tolerance() || outer.norm() < tolerance())
      return fail("has a link of length zero at its elbow");
    const double angle = std::atan2(direction.dot(inner.cross(outer)), inner.dot(outer));
    return ElbowActuation{c, inner.norm(), outer.norm(), angle - setting_.joint_value, 1.0};
  }

  const LegSetting& setting_;
  const PlatformMotion& motion_;
  Eigen::Isometry3d to_task_;
  std::string reason_;
};

// Rods in parallel say the same thing about a translating platform when they are equal and parallel.
bool equivalent(const SplitChain& one, const SplitChain& other, const LegSetting& setting) {
  const double tolerance = direction_tolerance * setting.size;
  const bool translating = !has_rotation(setting.motion->space) && !setting.motion->point_platform;
  if (translating && one.actuated_first && other.actuated_first)
    return ((one.p - one.c) - (other.p - other.c)).norm() < tolerance;
  return (one.p - other.p).norm() < tolerance && (one.c - other.c).norm() < tolerance;
}

SplitChain mean(const std::vector<SplitChain>& chains) {
  SplitChain result = chains.front();
  for (std::size_t k = 1; k < chains.size(); ++k) {
    result.c += chains[k].c;
    result.p += chains[k].p;
  }
  result.c /= static_cast<double>(chains.size());
  result.p /= static_cast<double>(chains.size());
  return result;
}

// Where the platform turns about one axis, a rod with an end that turns about that direction, too, keeps the
// heights of both ends. So it moves as in the plane, if all else of its leg does.
bool is_planar_leg(const LegChains& leg, std::size_t actuated_variable, const PlatformMotion& motion) {
  if (motion.space != TaskSpace::R1) return is_planar(motion.space);
  const Vector3d normal = motion.task_frame.linear().col(2);
  bool turns_in_plane = false;
  for (const Chain& chain : leg.chains)
    for (const Pivot& pivot : chain) {
      if (pivot.kind == PivotKind::ball) continue;
      const bool slides = pivot.kind == PivotKind::prismatic;
      const double off = slides ? std::abs(pivot.axis.dot(normal)) : pivot.axis.cross(normal).norm();
      if (off > direction_tolerance) return false;
      turns_in_plane = turns_in_plane || (!slides && pivot.variable != actuated_variable);
    }
  return turns_in_plane;
}

}  // namespace

std::optional<RecognisedLeg> recognise_leg(const LegChains& leg, std::size_t actuated_variable,
                                           const LegSetting& given, std::string& reason) {
  LegSetting setting = given;
  setting.planar = is_planar_leg(leg, actuated_variable, *setting.motion);
  const auto refuse = [&](const std::string& found) {
    reason = found;
    return std::nullopt;
  };
  RecognisedLeg result;
  ChainRecogniser recogniser(setting, actuated_variable);
  for (const Chain& chain : leg.chains) {
    const auto split = recogniser.split(chain);
    if (!split) return refuse(recogniser.reason());
    if (!result.chains.empty() && !equivalent(result.chains.front(), *split, setting))
      return refuse("has parallel rods of different lengths or directions");
    result.chains.push_back(*split);
  }
  LegBuilder builder(setting);
  const auto built = builder.build(mean(result.chains));
  if (!built) return refuse(builder.reason());
  result.leg = *built;
  return result;
}

}  // namespace parallel_aspects
