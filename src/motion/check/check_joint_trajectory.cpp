// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/constraints/serial_margin.h"
#include "interval/path_form.h"
#include "motion/check/check_text.h"
#include "motion/check/fold.h"
#include "motion/check/joint_assembly.h"
#include "motion/check/segment_times.h"
#include "motion/check/trajectory_survey.h"
#include "parallel_aspects/motion/check_trajectory.h"
#include "tracking/continuation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace parallel_aspects {
namespace {

// Shares of the time between two waypoints.
constexpr double narrow_piece = 0x1p-20;  // that is still tried to be proved free
constexpr double shortest_piece = 0x1p-36;
constexpr double longest_probe = 0x1p-6;

// A fold is searched where pieces become as short as this, and again each time that they have become shorter
// by this factor: the worse a fold is conditioned, the more pieces lead up to it.
constexpr double first_look = 0x1p-12;
constexpr double next_look = 0x1p-4;

using JointRanges = std::array<Interval, max_legs>;

/// Follows the platform piece by piece, and proves each piece.
class JointCheck {
 public:
  JointCheck(const SegmentCertifier& certifier, const std::vector<JointWaypoint>& waypoints,
             const TrajectoryCheckOptions& options)
      : certifier_(certifier),
        manipulator_(*certifier.manipulator()),
        poses_(manipulator_),
        times_(waypoints),
        options_(options),
        survey_(manipulator_, options.keep_samples, check_),
        longest_piece_(std::min(1.0, static_cast<double>(times_.count()) / std::max(1, options.samples))),
        length_(longest_piece_) {}

  TrajectoryCheck run(const TrajectoryStart& start) {
    proved_ = check_.free_until = check_.followed_until = times_.from(0).time;
    const StartAssembly assembly = find_start(manipulator_, poses_, times_.from(0).q, start);
    if (!assembly.problem.empty()) {
      TrajectoryCheck check = refused({assembly.problem});
      check.possible_starts = assembly.possible;
      return check;
    }
    at_ = assembly.point;
    begin();
    for (std::size_t i = 0; i < times_.count() && outcome_ == Outcome::open; ++i) {
      if (is_cancelled(options_.control))
        outcome_ = Outcome::cancelled;
      else
        pass(i);
      times_.report(i, options_.control);
    }
    conclude();
    return check_;
  }

 private:
  enum class Outcome { open, folded, lost, stretched, cut_short, cancelled };
  enum class Piece { taken, not_followed, not_free };

  void begin() {
    const RoundingUpward upward;
    mode_ = WorkingMode(manipulator_.leg_count());
    const double radius = poses_.ball(at_).radius;
    for (std::size_t j = 0; j < manipulator_.leg_count(); ++j) {
      const int sign = poses_.entry_sign(at_, j, radius, 0.0);
      if (sign == 0) outcome_ = Outcome::stretched;
      mode_.set_sign(j, sign < 0 ? -1 : 1);
    }
    if (outcome_ == Outcome::open) check_.mode = mode_;
    JointRanges q;
    for (std::size_t j = 0; j < manipulator_.leg_count(); ++j)
      q[j] = Interval(times_.from(0).q[static_cast<Eigen::Index>(j)]);
    if (outcome_ == Outcome::open) look_for_violation(q, proved_);
    survey_.add(proved_, at_.pose, at_.q, 0.0);
  }

  void pass(std::size_t i) {
    const RoundingUpward upward;
    const JointPath path(times_.from(i), times_.to(i));
    double share = 0.0, free = 0.0;
    look_ = first_look;
    for (int parts = 0; share < 1.0 && outcome_ == Outcome::open; ++parts) {
      if (parts == options_.max_parts) outcome_ = Outcome::cut_short;
      const double end = 1.0 - share <= length_ ? 1.0 : share + length_;
      const Piece piece = go(path, share, end);
      if (piece == Piece::taken) {
        share = end;
        arrive(i, path, share);
        if (!check_.violation && (is_free_ || passes_serial())) free = share;
        length_ = std::min(2.0 * length_, is_free_ ? longest_piece_ : longest_probe);
      } else if (piece == Piece::not_free && length_ <= narrow_piece) {
        is_free_ = false;
      } else {
        length_ *= 0.5;
        if (length_ < shortest_piece)
          outcome_ = Outcome::lost;
        else if (piece == Piece::not_followed && length_ <= look_)
          look_for_fold(i, path, share);
      }
    }
    if (outcome_ == Outcome::lost || outcome_ == Outcome::cut_short) lose(i, path, share);
    measure_speeds(i, path, free);
  }

  void measure_speeds(std::size_t i, const JointPath& path, double until) {
    SpeedSearch(check_.speeds)
        .pass(times_.from(i).time, times_.to(i).time - times_.from(i).time, until,
              [&](double begin, double end) {
                SpeedBounds bounds;
                for (std::size_t j = 0; j < manipulator_.leg_count(); ++j) {
                  const Interval speed = absolute(path.slope(j, Interval(begin, end)));
                  bounds.least[j] = speed.lower();
                  bounds.most[j] = speed.upper();
                }
                return std::optional(bounds);
              });
  }

  /// Ends the search here if the fold is near enough.
  void look_for_fold(std::size_t i, const JointPath& path, double share) {
    look_ = next_look * length_;
    const std::optional<double> met = fold_after(path, share, std::min(1.0, share + options_.bracket));
    if (met) fold(times_.after(i, *met));
  }

  /// The platform may be near a fold of the solutions, however far it is; in spaces without rotation it is
  /// enough that no pose goes with the joints a little later.
  void lose(std::size_t i, const JointPath& path, double share) {
    std::optional<double> met = fold_after(path, share, 1.0);
    for (double ahead = shortest_piece; !met && share + ahead < 1.0; ahead *= 2.0)
      if (proved_unassembled(manipulator_, ranges_at(path, share + ahead))) met = share + ahead;
    if (met) fold(times_.after(i, *met));
  }

  void fold(double time) {
    outcome_ = Outcome::folded;
    violate(Violation::singularity, {}, {}, time);
  }

  std::optional<double> fold_after(const JointPath& path, double share, double until) const {
    const CertifiedBall ball = ball_of(ranges_at(path, share));
    if (!ball.certified) return std::nullopt;
    return FoldProof(manipulator_, poses_, path).latest(at_, ball.radius, 0.0, share, until);
  }

  /// Of all solutions near `at_` for joints within `q`.
  CertifiedBall ball_of(const JointRanges& q) const {
    const TaskVector still = TaskVector::Zero(at_.q.size());
    TaskVector change = still;
    for (std::size_t j = 0; j < manipulator_.leg_count(); ++j) {
      const auto k = static_cast<Eigen::Index>(j);
      change[k] = magnitude(q[j] - Interval(at_.q[k]));
    }
    return poses_.ball(at_, still, change, 0.0, 0.0);
  }

  JointRanges ranges_at(const JointPath& path, double share) const {
    JointRanges q;
    for (std::size_t j = 0; j < manipulator_.leg_count(); ++j) q[j] = path.value(j, share);
    return q;
  }

  /// Goes straight from the known point to one near the end of the piece; the allowance covers how far the
  /// joints leave the straight way.
  Piece go(const JointPath& path, double begin, double end) {
    JointVector target(at_.q.size()), bend(at_.q.size());
    JointRanges range;
    for (std::size_t j = 0; j < manipulator_.leg_count(); ++j) {
      const auto k = static_cast<Eigen::Index>(j);
      const Interval first = path.value(j, begin), last = path.value(j, end);
      target[k] = 0.5 * (last.lower() + last.upper());
      const double bent = path.bend(j, begin, end);
      bend[k] = bent + std::max(magnitude(first - Interval(at_.q[k])), magnitude(last - Interval(target[k])));
      range[j] = Interval(std::min(first.lower(), last.lower()), std::max(first.upper(), last.upper())) +
                 Interval(-bent, bent);
    }
    Continuation way(poses_, at_, target, bend);
    if (!way.step(1.0)) return Piece::not_followed;
    if (is_free_ ? !is_free(range, way.radius()) : !passes_on(range, way.radius())) return Piece::not_free;
    at_ = way.at();
    radius_ += way.radius();
    return Piece::taken;
  }

  /// For all poses and joint values of this piece. With the joints, B_jj is enclosed to the first order; by
  /// the pose alone it would be a square root.
  bool is_free(const JointRanges& range, double radius) const {
    if (!within_limits(range)) return false;
    for (std::size_t j = 0; j < manipulator_.leg_count(); ++j) {
      const double change = magnitude(range[j] - Interval(at_.q[static_cast<Eigen::Index>(j)]));
      if (poses_.entry_sign(at_, j, radius, change) != mode_.sign(j)) return false;
    }
    return !has_others() || constraints_hold(radius, mode_);
  }

  /// Where B_jj may be zero: whether the constraints are proved to hold, or this piece is as short as any.
  bool passes_on(const JointRanges& range, double radius) {
    if (!keeps_constraints_) return true;
    const bool within = within_limits(range);
    if (within && (!has_others() || others_hold(range, radius))) return true;
    if (within && length_ > narrow_piece) return false;
    keeps_constraints_ = false;
    return true;
  }

  /// Whether the constraints beside limits hold in this piece, in each working mode that the legs can have in
  /// it: both postures of one whose B_jj may be zero.
  bool others_hold(const JointRanges& range, double radius) const {
    std::array<int, max_legs> signs{};
    for (std::size_t j = 0; j < manipulator_.leg_count(); ++j) {
      const double change = magnitude(range[j] - Interval(at_.q[static_cast<Eigen::Index>(j)]));
      signs[j] = poses_.entry_sign(at_, j, radius, change);
    }
    for (const WorkingMode& mode : working_modes(manipulator_)) {
      bool is_possible = true;
      for (std::size_t j = 0; j < manipulator_.leg_count(); ++j)
        is_possible = is_possible && signs[j] != -mode.sign(j);
      if (is_possible && !constraints_hold(radius, mode)) return false;
    }
    return true;
  }

  bool constraints_hold(double radius, const WorkingMode& mode) const {
    return certifier_.constraints_hold_around(at_.pose, displacement(radius), angle(radius), mode);
  }

  bool within_limits(const JointRanges& range) const {
    if (!has_limits()) return true;
    for (std::size_t j = 0; j < manipulator_.leg_count(); ++j) {
      const JointLimits& limits = manipulator_.leg(j).limits;
      if (!(range[j].lower() >= limits.lower && range[j].upper() <= limits.upper)) return false;
    }
    return true;
  }

  /// Whether B_jj = 0 is no violation.
  bool passes_serial() const {
    return options_.pass_serial && (check_.violation || !has_serial_margin(manipulator_));
  }

  /// Constraints are not examined any more once the trajectory is proved not to be safe.
  bool has_others() const {
    ConstraintKinds kinds = manipulator_.constraint_kinds();
    kinds[static_cast<std::size_t>(ConstraintKind::actuated_limits)] = false;
    return !check_.violation && kinds.any();
  }

  bool has_limits() const {
    return !check_.violation &&
           manipulator_.constraint_kinds()[static_cast<std::size_t>(ConstraintKind::actuated_limits)];
  }

  NeighbourhoodProof around(double radius) const {
    return certifier_.prove_around(at_.pose, displacement(radius), angle(radius), mode_);
  }

  /// How far the operational point is from where it is known, and how far the platform is turned.
  double displacement(double radius) const {
    return has_translation(manipulator_.task_space()) ? radius : 0.0;
  }
  double angle(double radius) const {
    return has_rotation(manipulator_.task_space()) ? radius / manipulator_.characteristic_length() : 0.0;
  }

  void arrive(std::size_t i, const JointPath& path, double share) {
    if (!is_free_) return look_for_violation(ranges_at(path, share), times_.after(i, share));
    proved_ = times_.before(i, share);
    if (check_.violation || !keeps_constraints_) return;
    check_.free_until = proved_;
    survey_.add(times_.at(i, share), at_.pose, at_.q, radius_);
    radius_ = 0.0;
  }

  /// Here, where the joints are within `q`.
  void look_for_violation(const JointRanges& q, double time) {
    const std::size_t legs = manipulator_.leg_count();
    for (std::size_t j = 0; j < legs; ++j) {
      const JointLimits& limits = manipulator_.leg(j).limits;
      if (has_limits() && (q[j].upper() < limits.lower || q[j].lower() > limits.upper))
        return violate(Violation::joint_limit, j, ConstraintKind::actuated_limits, time);
    }
    const CertifiedBall ball = ball_of(q);
    if (!ball.certified) return;
    for (std::size_t j = 0; j < legs; ++j) {
      const double change = magnitude(q[j] - Interval(at_.q[static_cast<Eigen::Index>(j)]));
      const int sign = poses_.entry_sign(at_, j, ball.radius, change);
      if (sign == -mode_.sign(j)) return violate(Violation::out_of_reach, j, {}, time);
      if (sign == 0) return;
    }
    if (has_others()) {
      const NeighbourhoodProof proof = around(ball.radius);
      if (proof.proved_violation == Violation::constraint)
        return violate(Violation::constraint, proof.leg, proof.failing, time);
    }
    if (check_.violation || passes_serial()) leave_crossing(time);
  }

  /// All signs are proved again, and are those of the mode: what was not proved since the last crossing is
  /// part of its bracket.
  void leave_crossing(double time) {
    if (check_.crossings.empty() || check_.crossings.back().before < proved_) return;
    check_.crossings.back().before = proved_ = time;
    is_free_ = true;
  }

  /// Notes what is violated up to this time, and goes on behind it.
  void violate(Violation kind, std::optional<std::size_t> leg, std::optional<ConstraintKind> constraint,
               double time) {
    const bool may_pass = kind == Violation::out_of_reach && passes_serial();
    if (!check_.violation && !may_pass)
      check_.violation = TrajectoryViolation{kind, leg, constraint, proved_, time};
    if (is_crossing(kind)) cross(kind, leg, time);
    is_free_ = outcome_ == Outcome::open;
  }

  void cross(Violation kind, std::optional<std::size_t> leg, double time) {
    TrajectoryCrossing crossing{kind, leg, proved_, time, {}, 0};
    for (const TrajectoryCrossing& each : check_.crossings)  // B_jj has its sign of that time there
      if (leg && each.leg == leg) crossing.after = std::max(crossing.after, each.before);
    if (leg) {
      mode_.set_sign(*leg, -mode_.sign(*leg));
      crossing.mode = mode_;
      crossing.determinant_sign = poses_.determinant_sign(at_);
    }
    check_.crossings.push_back(crossing);
  }

  void conclude() {
    check_.followed_until = proved_;
    const bool to_the_end = outcome_ == Outcome::open && is_free_ && keeps_constraints_;
    check_.answer = check_.violation ? TrajectoryAnswer::unsafe
                    : to_the_end     ? TrajectoryAnswer::safe
                                     : TrajectoryAnswer::unknown;
    if (!to_the_end) check_.not_followed = not_followed_text(proved_, why_not_further());
    check_.reason = check_.violation ? unsafe_text(manipulator_, *check_.violation)
                    : to_the_end     ? (check_.crossings.empty() ? safe_text() : passed_text())
                    : outcome_ == Outcome::stretched
                        ? "A leg is stretched or folded at the start (B_jj = 0), or too near to it."
                        : undecided_text(check_.free_until, why_not_further());
  }

  std::string why_not_further() const {
    if (outcome_ == Outcome::cancelled) return "the check was cancelled";
    if (outcome_ == Outcome::stretched)
      return "a leg is stretched or folded (B_jj = 0), or too near to it, already at the start";
    if (outcome_ == Outcome::folded)
      return "det A vanishes, and behind it the actuated joints do not determine where the platform goes";
    if (outcome_ == Outcome::lost && is_free_) return "it comes too near to det A = 0 to be followed";
    return near_something_text();
  }

  const SegmentCertifier& certifier_;
  const Manipulator& manipulator_;
  PoseCertifier poses_;
  SegmentTimes<JointWaypoint> times_;
  const TrajectoryCheckOptions& options_;
  TrajectoryCheck check_;
  TrajectorySurvey survey_;
  CertifiedPoint at_;
  WorkingMode mode_;
  double longest_piece_;           // so that there are enough samples
  double length_;                  // of the next piece
  double look_ = 0.0;              // for a fold, where pieces are as short as this
  double radius_ = 0.0;            // of balls that hold all poses since the last sample, together
  double proved_ = 0.0;            // no crossing that is not noted up to here [s]
  bool is_free_ = true;            // proved up to here
  bool keeps_constraints_ = true;  // proved where it is not free but no violation either
  Outcome outcome_ = Outcome::open;
};

}  // namespace

TrajectoryCheck check_trajectory(const SegmentCertifier& certifier,
                                 const std::vector<JointWaypoint>& waypoints, const TrajectoryStart& start,
                                 const TrajectoryCheckOptions& options) {
  const Problems problems = problems_of(*certifier.manipulator(), waypoints, start);
  if (!problems.empty()) return refused(problems);
  return JointCheck(certifier, waypoints, options).run(start);
}

}  // namespace parallel_aspects
