// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/constraints/constraint_tests.h"
#include "aspects/constraints/finite_lengths.h"
#include "aspects/constraints/robot_points.h"
#include "aspects/roadmap/pose_segment.h"
#include "interval/nonsingular.h"
#include "legs/limit_verdict.h"
#include "legs/spatial_leg.h"
#include "legs/toleranced.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/aspects/pose_roadmap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double shortest_step = 0x1p-30;

// How a march steps: the next step aims at this ratio, of which 1 just fails, and is at most so much shorter
// or longer than the last, after one that was proved free and after one that was not.
struct Stride {
  double first, aimed_ratio;
  std::array<double, 2> after_free, after_failure;
};

// Whether all of a segment is free shows soonest in one step over all of it, or in the middle of that. Of
// 2,400 random segments of six robots, half of them free, a free one took 21 parts, and another 3.4, in place
// of 25 and 8.8 with the stride below; from 0.8 to 0.9, 1/4 to 1/2 and 1.25 to 1.5 it is less than a part
// more.
constexpr Stride all_at_once{1.0, 0.85, {0.35, 1.5}, {0.35, 1.5}};

// Where a march goes as far as it can, long first steps would end it too early, and steps towards a violation
// have to become short soon.
constexpr Stride as_far_as_proved{0.25, 0.75, {0.5, 4.0}, {0.125, 0.5}};

double next_step(double step, double ratio, bool free, const Stride& stride) noexcept {
  const auto& [least, most] = free ? stride.after_free : stride.after_failure;
  return step * std::clamp(stride.aimed_ratio / ratio, least, most);
}

constexpr int parts_between_looks = 16;
constexpr int points_of_a_look = 12;

constexpr double longest_length = 1e12;  // [m]; see finite_lengths.h

// What is proved to be at or before a configuration, on the path from one whose det A has this sign.
Violation violation_at(const ConfigurationProof& proof, int sign) {
  if (proof.proved_violation != Violation::none) return proof.proved_violation;
  return proof.sign == -sign ? Violation::singularity : Violation::none;
}

}  // namespace

/// What proofs need of the robot.
struct SegmentCertifier::Parts {
  explicit Parts(const Manipulator& manipulator)
      : usable(is_usable(manipulator, longest_length)),
        is_planar(parallel_aspects::is_planar(manipulator.task_space())),
        planar_constraints(made_under_upward_rounding<ConstraintTests<2>>(manipulator)),
        spatial_constraints(made_under_upward_rounding<ConstraintTests<3>>(manipulator)) {
    const RoundingUpward rounding;
    for (const Leg& leg : manipulator.legs()) {
      legs.emplace_back(leg);
      anchors.push_back(toleranced_anchor(leg));
    }
  }

  bool usable;  // no length beyond what the arithmetic can take
  std::vector<SpatialLeg> legs;
  std::vector<Spatial<Interval>> anchors;
  bool is_planar;
  ConstraintTests<2> planar_constraints;
  ConstraintTests<3> spatial_constraints;  // of one of them the robot has no use
};

/// What is asked of the legs.
enum class SegmentCertifier::Reach {
  proved,  ///< that B_jj is not zero, and that limits hold
  assumed  ///< nothing: poses out of reach do not count
};

/// A segment in one working mode, and what is found of the part of it that was examined last.
class SegmentCertifier::Evaluation {
 public:
  Evaluation(const SegmentCertifier& certifier, const PoseSegment& segment, const WorkingMode& mode,
             Reach reach = Reach::proved)
      : parts_(*certifier.parts_),
        space_(certifier.manipulator_->task_space()),
        segment_(segment),
        mode_(mode),
        reach_(reach) {}

  /// What is proved of a single point.
  ConfigurationProof at(double t) {
    if (legs_are_free(t, t)) return {proved_sign_at_middle(), Violation::none, {}, {}};
    return found_;
  }

  /// What is proved of all poses that a placement without slope encloses.
  NeighbourhoodProof over(const PoseSegment::Placement& placement) {
    found_ = {};
    const bool free = legs_are_free(placement);
    return {free, found_.proved_violation, found_.failing, found_.leg};
  }

  /// u.dp = B dq, where u and p are known by their enclosures and dp/dt by their slopes.
  std::optional<SpeedBounds> speeds(double begin, double end) {
    if (!legs_are_free(begin, end)) return std::nullopt;
    const double middle = std::clamp(0.5 * (begin + end), begin, end);
    const Interval length(PathForm::parameter(begin, middle, end).slope);
    SpeedBounds bounds;
    for (std::size_t j = 0; j < parts_.legs.size(); ++j) {
      Interval rise(0.0);
      for (std::size_t i = 0; i < 3; ++i) rise += rods_[j][i].range * displacements_[j][i].slope;
      const Interval entry = parts_.legs[j].scale(displacements_[j]).range * entries_[j].range * length;
      if (!entry.positive()) return std::nullopt;
      const Interval speed = absolute(rise) * reciprocal(entry);
      bounds.least[j] = speed.lower();
      bounds.most[j] = speed.upper();
    }
    return bounds;
  }

  /// Part by part from a start with this sign of det A, the first of this length, as long as the parts may
  /// be.
  SegmentProof march(int sign, int max_parts, const Stride& stride, double begin = 0.0) {
    SegmentProof proof;
    proof.free_until = begin;
    double step = stride.first;
    while (proof.verdict == SegmentVerdict::undecided && proof.parts < max_parts && step >= shortest_step) {
      // Towards a singularity parts become ever shorter; whether one lies ahead shows at single points.
      if (++proof.parts % parts_between_looks == 0 && look_ahead(sign, proof)) break;
      const double end = 1.0 - proof.free_until <= step ? 1.0 : proof.free_until + step;
      if (is_free(proof.free_until, end)) {
        proof.free_until = end;
        if (end >= 1.0) proof.verdict = SegmentVerdict::free;
        step = next_step(step, ratio_, true, stride);
      } else {
        const double ratio = ratio_;
        block_if_violated(0.5 * (proof.free_until + end), sign, proof);
        step = next_step(step, ratio, false, stride);
      }
    }
    return proof;
  }

  /// Takes a march that was not free as near to the first violation as it can.
  void approach_violation(int sign, double width, int max_parts, SegmentProof& proof) {
    if (proof.verdict == SegmentVerdict::undecided && !look_ahead(sign, proof))
      block_if_violated(1.0, sign, proof);
    if (proof.verdict != SegmentVerdict::blocked) return;
    approach_from_start(sign, width, max_parts, proof);
    // Where something else is in between that cannot be decided, such as det A that touches zero.
    double open = proof.free_until;
    while (proof.witness - open > width && proof.parts++ < max_parts) {
      const double middle = open + 0.5 * (proof.witness - open);
      if (!block_if_violated(middle, sign, proof)) open = middle;
    }
  }

 private:
  void approach_from_start(int sign, double width, int max_parts, SegmentProof& proof) {
    double step = 1.0;
    while (proof.witness - proof.free_until > width && proof.parts < max_parts && step >= shortest_step) {
      ++proof.parts;
      const double middle = proof.free_until + 0.5 * (proof.witness - proof.free_until);
      block_if_violated(middle, sign, proof);
      step = std::min(step, 0.5 * (proof.witness - proof.free_until));
      const double end = proof.free_until + step;
      const bool free = is_free(proof.free_until, end);
      const double ratio = ratio_;
      if (free) proof.free_until = end;
      if (!free) block_if_violated(end, sign, proof);
      step = next_step(step, ratio, free, as_far_as_proved);
    }
  }

  bool look_ahead(int sign, SegmentProof& proof) {
    double ahead = 1.0 - proof.free_until;
    for (int i = 0; i < points_of_a_look; ++i) {
      ahead *= 0.5;
      if (block_if_violated(proof.free_until + ahead, sign, proof)) return true;
    }
    return false;
  }

  bool block_if_violated(double t, int sign, SegmentProof& proof) {
    const ConfigurationProof here = at(t);
    const Violation found = violation_at(here, sign);
    if (found == Violation::none) return false;
    proof.verdict = SegmentVerdict::blocked;
    proof.violation = found;
    proof.witness = t;
    proof.at_witness = here;
    return true;
  }

  /// Whether the legs are proved free and det A proved not to be zero on a whole part.
  bool is_free(double begin, double end) {
    ratio_ = std::numeric_limits<double>::infinity();
    return legs_are_free(begin, end) && proved_nonsingular(parts_.legs.size(), rows_, ratio_);
  }

  bool legs_are_free(double begin, double end) {
    found_ = {};
    const double middle = std::clamp(0.5 * (begin + end), begin, end);
    PoseSegment::Placement placement;
    return segment_.place(PathForm::parameter(begin, middle, end), placement) && legs_are_free(placement);
  }

  bool legs_are_free(const PoseSegment::Placement& placement) {
    for (std::size_t j = 0; j < parts_.legs.size(); ++j)
      if (!leg_is_free(j, placement)) return false;
    if (!keeps_margins(placement)) return false;
    return parts_.is_planar ? is_allowed(parts_.planar_constraints, placement)
                            : is_allowed(parts_.spatial_constraints, placement);
  }

  bool keeps_margins(const PoseSegment::Placement& placement) {
    return parts_.is_planar ? keeps_margins(parts_.planar_constraints.margins(), placement)
                            : keeps_margins(parts_.spatial_constraints.margins(), placement);
  }

  /// The legs must be free.
  template <std::size_t D>
  bool keeps_margins(const MarginTests<D>& margins, const PoseSegment::Placement& placement) {
    if (!margins.any()) return true;
    const MarginLegs<D> legs{parts_.legs, rows_, displacements_, rods_, placement.rotation};
    Verdict everywhere = Verdict::holds, at_center = Verdict::holds;
    const auto take = [&](const PathForm& value) {
      everywhere = both(everywhere, is_positive(value.range));
      at_center = both(at_center, is_positive(value.center));
    };
    for (std::size_t j = 0; j < parts_.legs.size(); ++j)
      margins.for_each_serial_function(j, squared_entries_[j], take);
    if (margins.has_parallel())
      margins.for_each_parallel_function(square(legs.determinant()), legs, std::array<int, max_legs>{}, take);
    if (at_center == Verdict::fails) found_ = {0, Violation::constraint, ConstraintKind::margins, {}};
    return everywhere == Verdict::holds;
  }

  /// By the constraints besides limits of actuated joints. The legs must be free.
  template <std::size_t D>
  bool is_allowed(const ConstraintTests<D>& tests, const PoseSegment::Placement& placement) {
    if (tests.none()) return true;
    RobotPoints<PathForm, D> robot;
    robot.leg_count = parts_.legs.size();
    for (std::size_t j = 0; j < robot.leg_count; ++j) {
      const auto points = parts_.legs[j].link_points(displacements_[j], entries_[j], mode_.sign(j));
      if (!points) return false;
      robot.legs[j] = {reduced<D>(points->base), reduced<D>(points->joint), reduced<D>(points->anchor),
                       points->length};
    }
    robot.position = reduced<D>(placement.position);
    for (std::size_t i = 0; i < D; ++i) robot.rotation[i] = reduced<D>(placement.rotation[i]);
    if (verdict(tests, robot) == Verdict::holds) return true;
    found_.failing = find_failing(tests, at_center(robot));
    if (found_.failing) found_.proved_violation = Violation::constraint;
    return false;
  }

  int proved_sign_at_middle() const {
    SquareArray<Interval> middle;
    for (std::size_t i = 0; i < max_legs; ++i)
      for (std::size_t k = 0; k < max_legs; ++k) middle[i][k] = rows_[i][k].center;
    return proved_determinant_sign(parts_.legs.size(), middle);
  }

  bool leg_is_free(std::size_t j, const PoseSegment::Placement& placement) {
    const SpatialLeg& leg = parts_.legs[j];
    Spatial<PathForm> b, d;
    for (std::size_t i = 0; i < 3; ++i) {
      b[i] = dot(parts_.anchors[j], placement.rotation[i]);
      d[i] = placement.position[i] + b[i] - PathForm(leg.base()[i]);
    }
    const SpatialLegForm<PathForm> form = leg.form(d);
    if (form.squared_b_entry.center.upper() <= 0.0) found_ = {0, Violation::out_of_reach, {}, j};
    if (reach_ == Reach::proved && !form.squared_b_entry.range.positive()) return false;
    const PathForm entry = reach_ == Reach::assumed
                               ? PathForm(square_root(not_negative_part(form.squared_b_entry.range)))
                               : square_root(form.squared_b_entry);
    displacements_[j] = d;
    squared_entries_[j] = form.squared_b_entry;
    entries_[j] = entry;
    if (reach_ == Reach::proved && !is_within_limits(j, d, entry)) return false;
    Spatial<PathForm>& u = rods_[j];
    for (std::size_t i = 0; i < 3; ++i) {
      const PathForm turned = entry * form.turned[i];
      u[i] = mode_.sign(j) > 0 ? form.fixed[i] + turned : form.fixed[i] - turned;
    }
    Lever<Spatial<PathForm>> lever{b, {}, placement.axis()};
    if (space_ == TaskSpace::R2)
      for (std::size_t i = 0; i < 3; ++i) lever.point[i] = placement.position[i] + b[i];
    write_row(space_, lever, u, rows_[j]);
    return true;
  }

  bool is_within_limits(std::size_t j, const Spatial<PathForm>& d, const PathForm& entry) {
    const SpatialLeg& leg = parts_.legs[j];
    const Spatial<Interval> range{d[0].range, d[1].range, d[2].range};
    if (verdict(leg.limits(range, entry.range, mode_.sign(j))) == Verdict::holds) return true;
    const Spatial<Interval> center{d[0].center, d[1].center, d[2].center};
    if (verdict(leg.limits(center, entry.center, mode_.sign(j))) == Verdict::fails)
      found_ = {0, Violation::joint_limit, ConstraintKind::actuated_limits, j};
    return false;
  }

  const Parts& parts_;
  const TaskSpace space_;
  const PoseSegment& segment_;
  const WorkingMode& mode_;
  const Reach reach_;
  SquareArray<PathForm> rows_;
  std::array<Spatial<PathForm>, max_legs> displacements_;  // of the anchors from the base points
  std::array<Spatial<PathForm>, max_legs> rods_;           // u, up to a positive factor
  std::array<PathForm, max_legs> squared_entries_;         // B_jj^2
  std::array<PathForm, max_legs> entries_;                 // |B_jj|
  ConfigurationProof found_;  // of the middle of the part; its sign is not filled in
  double ratio_ = 0.0;  // upper bound of the spectral radius that must be below 1; infinite where unknown
};

SegmentCertifier::SegmentCertifier(std::shared_ptr<const Manipulator> manipulator)
    : manipulator_(std::move(manipulator)), parts_(std::make_shared<const Parts>(*manipulator_)) {}

ConfigurationProof SegmentCertifier::prove(const Pose& pose, const WorkingMode& mode) const noexcept {
  if (!parts_->usable || !is_usable(pose, longest_length) || mode.leg_count() != parts_->legs.size())
    return {};
  for (std::size_t j = 0; j < parts_->legs.size(); ++j)
    if (!manipulator_->leg(j).has_branch(mode.sign(j))) return {0, Violation::out_of_reach, {}, j};
  const RoundingUpward rounding;
  return Evaluation(*this, PoseSegment(manipulator_->motions(), pose, pose), mode).at(0.0);
}

SegmentProof SegmentCertifier::prove(const Pose& from, const Pose& to, const WorkingMode& mode,
                                     int max_parts) const noexcept {
  const ConfigurationProof start = prove(from, mode), end = prove(to, mode);
  const Violation found = start.proved_violation != Violation::none ? start.proved_violation
                          : start.sign != 0                         ? violation_at(end, start.sign)
                                                                    : Violation::none;
  if (found != Violation::none) return {SegmentVerdict::blocked, found, 0.0, 1.0, 0};
  if (start.sign == 0 || end.sign == 0) return {};
  const RoundingUpward rounding;
  return Evaluation(*this, PoseSegment(manipulator_->motions(), from, to), mode)
      .march(start.sign, max_parts, all_at_once);
}

SegmentProof SegmentCertifier::prove_start(const Pose& from, const Pose& to, const WorkingMode& mode,
                                           int max_parts) const noexcept {
  const ConfigurationProof start = prove(from, mode);
  if (start.sign == 0 || !is_usable(to, longest_length)) return {};
  const RoundingUpward rounding;
  return Evaluation(*this, PoseSegment(manipulator_->motions(), from, to), mode)
      .march(start.sign, max_parts, as_far_as_proved);
}

SegmentProof SegmentCertifier::prove_to_violation(const Pose& from, const Pose& to, const WorkingMode& mode,
                                                  double width, int max_parts, double begin) const noexcept {
  ConfigurationProof start = prove(from, mode);
  if (begin <= 0.0 && start.proved_violation != Violation::none)
    return {SegmentVerdict::blocked, start.proved_violation, 0.0, 0.0, 0, start};
  if (!parts_->usable || !is_usable(from, longest_length) || !is_usable(to, longest_length) ||
      mode.leg_count() != parts_->legs.size())
    return {};
  const RoundingUpward rounding;
  const PoseSegment segment(manipulator_->motions(), from, to);
  Evaluation evaluation(*this, segment, mode);
  if (begin > 0.0) start = evaluation.at(begin);
  if (start.proved_violation != Violation::none)
    return {SegmentVerdict::blocked, start.proved_violation, begin, begin, 0, start};
  if (start.sign == 0) return {SegmentVerdict::undecided, Violation::none, begin};
  SegmentProof proof = evaluation.march(start.sign, max_parts / 2, as_far_as_proved, begin);
  if (proof.verdict != SegmentVerdict::free)
    evaluation.approach_violation(start.sign, width, max_parts, proof);
  return proof;
}

std::optional<SpeedBounds> SegmentCertifier::joint_speeds(const Pose& from, const Pose& to,
                                                          const WorkingMode& mode, double begin,
                                                          double end) const noexcept {
  if (!parts_->usable || !is_usable(from, longest_length) || !is_usable(to, longest_length) ||
      mode.leg_count() != parts_->legs.size() || !(begin < end))
    return std::nullopt;
  const RoundingUpward rounding;
  return Evaluation(*this, PoseSegment(manipulator_->motions(), from, to), mode).speeds(begin, end);
}

NeighbourhoodProof SegmentCertifier::prove_around(const Pose& pose, double displacement, double angle,
                                                  const WorkingMode& mode) const noexcept {
  return prove_around(pose, displacement, angle, mode, Reach::proved);
}

bool SegmentCertifier::constraints_hold_around(const Pose& pose, double displacement, double angle,
                                               const WorkingMode& mode) const noexcept {
  return prove_around(pose, displacement, angle, mode, Reach::assumed).free;
}

// A rotation by an angle changes no entry of a rotation matrix by more than that angle.
NeighbourhoodProof SegmentCertifier::prove_around(const Pose& pose, double displacement, double angle,
                                                  const WorkingMode& mode, Reach reach) const noexcept {
  if (!parts_->usable || !is_usable(pose, longest_length) || mode.leg_count() != parts_->legs.size() ||
      !(displacement < longest_length) || !(angle < longest_length))
    return {};
  const RoundingUpward rounding;
  if (manipulator_->task_space() == TaskSpace::R2) {
    const PoseCoordinates angles = pose_coordinates(TaskSpace::R2, pose);
    const auto turn = [angle](double at) -> Turn<PathForm> {
      const Turn<Interval> range = enclosed_turn(at, 1.0, Interval(-angle, angle));
      return {PathForm(range.cosine), PathForm(range.sine)};
    };
    return Evaluation(*this, PoseSegment(manipulator_->motions(), pose, pose), mode, reach)
        .over(EnclosedHinges(manipulator_->motions().hinges).placed(turn(angles[0]), turn(angles[1])));
  }
  const RotationRows<Interval> turn = enclosed_rotation(pose.orientation);
  const Interval away(-displacement, displacement), turned(-angle, angle);
  PoseSegment::Placement placement;
  const std::size_t moved = parts_->is_planar ? 2 : 3;
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval at(pose.position[static_cast<Eigen::Index>(i)]);
    placement.position[i] = i < moved ? at + away : at;
    for (std::size_t k = 0; k < 3; ++k)
      placement.rotation[i][k] = std::max(i, k) < moved ? turn[i][k] + turned : turn[i][k];
  }
  return Evaluation(*this, PoseSegment(manipulator_->motions(), pose, pose), mode, reach).over(placement);
}

}  // namespace parallel_aspects
