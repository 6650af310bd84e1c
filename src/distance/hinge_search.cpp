// SPDX-License-Identifier: BSD-3-Clause
#include "distance/hinge_search.h"

#include "aspects/zeros/krawczyk.h"
#include "distance/search_result.h"
#include "model/angles.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Boxes of two angles take a fraction of what those of other task spaces do.
constexpr int boxes_for_one = 4;

// Steps of Newton's method towards a pose of the boundary, and how many times a search starts it.
constexpr int newton_steps = 12, most_attempts = 100;

// Of differences that stand for derivatives, in half turns.
constexpr double small_step = 1e-7;

Box point_box(std::size_t dimension, const std::array<double, 2>& at) {
  return {dimension, {at[0], at[1], 0.0}, {at[0], at[1], 0.0}};
}

std::vector<LegBoundary<3>> limits_of(const Manipulator& robot) {
  const RoundingUpward rounding;
  return leg_boundaries<3>(robot).limits;
}

std::variant<R1Chart, R2Chart> chart_of(const Manipulator& robot) {
  const RoundingUpward rounding;
  if (robot.leg_count() == 1) return R1Chart(robot);
  return R2Chart(robot);
}

}  // namespace

HingeSearch::HingeSearch(const Manipulator& manipulator, const DistanceOptions& options)
    : robot_(manipulator.with_tolerance(0.0)),  // distances are those of the robot that is described
      options_(options),
      modes_(working_modes(*robot_)),
      classifier_(make_box_classifier(*robot_, modes_)),
      space_(make_pose_space(robot_->motions(), Box{}, robot_->characteristic_length())),
      chart_(chart_of(*robot_)),
      limits_(limits_of(*robot_)),
      dimension_(robot_->leg_count()) {
  queue_.reserve(static_cast<std::size_t>(most_boxes()) + 2);
}

int HingeSearch::most_boxes() const noexcept { return boxes_for_one * options_.max_boxes; }

HingeSearch::Angles HingeSearch::angles_of(const Pose& pose) const noexcept {
  const MapPoint point = space_->position(pose).point;
  return {std::clamp(point[0], -1.0, 1.0), std::clamp(point[1], -1.0, 1.0)};
}

Pose HingeSearch::pose_at(const Angles& angles) const noexcept {
  return space_->pose({0, {angles[0], angles[1], 0.0}});
}

Spatial<Interval> HingeSearch::displacement(const Box& box, std::size_t leg) const noexcept {
  return std::visit(
      [&](const auto& chart) {
        std::array<Interval, std::decay_t<decltype(chart)>::coordinate_count> at;
        for (std::size_t i = 0; i < at.size(); ++i) at[i] = Interval(box.lower[i], box.upper[i]);
        return chart.displacement(leg, chart.place(0, at)).from_base;
      },
      chart_);
}

void HingeSearch::look_from(const Pose& pose) noexcept {
  const Box here = point_box(dimension_, angles_of(pose));
  for (std::size_t j = 0; j < dimension_; ++j) anchors_[j] = displacement(here, j);
}

// D of the poses of a box.
Interval HingeSearch::distance_to(const Box& box) const noexcept {
  Interval sum(0.0);
  for (std::size_t j = 0; j < dimension_; ++j) {
    const Spatial<Interval> d = displacement(box, j);
    for (std::size_t i = 0; i < 3; ++i) sum += square(d[i] - anchors_[j][i]);
  }
  return square_root(not_negative_part(sum * reciprocal(Interval(static_cast<double>(dimension_)))));
}

BoundaryDistances HingeSearch::measure(const Pose& pose, const WorkingMode& mode) noexcept {
  BoundaryDistances result;
  const InverseSolution solution = begin_distances(*robot_, pose, mode, result);
  if (solution.status == InverseStatus::out_of_reach) return result;
  mode_ = mode;
  mode_index_ = static_cast<std::size_t>(std::find(modes_.begin(), modes_.end(), mode) - modes_.begin());
  {
    const RoundingUpward rounding;
    look_from(pose);
    const BoxFacts here = classifier_->facts(0, point_box(dimension_, angles_of(pose)), mode_index_);
    if (here.clear != here.legs) {
      result.status = ConfigurationStatus::at_serial_singularity;
      for (std::size_t j = dimension_; j-- > 0;)
        if ((here.clear & BoxFacts::bit(j)) == 0) result.serial = touching(j);
      if (solution.status == InverseStatus::outside_limits) result.actuated_limit = touching(solution.leg);
      return result;
    }
    result.parallel = search(Kind::parallel);
    result.serial = search(Kind::serial);
    result.actuated_limit = search(Kind::limit);
  }
  for (BoundaryDistance* each : {&result.parallel, &result.serial, &result.actuated_limit})
    describe(pose, solution.q, *each);
  if (solution.status == InverseStatus::outside_limits) result.actuated_limit = touching(solution.leg);
  return result;
}

template <class Action>
void HingeSearch::for_each_target(Kind kind, const Action& action) const noexcept {
  if (kind == Kind::parallel) action(Target{kind, 0, nullptr});
  if (kind == Kind::serial)
    for (std::size_t j = 0; j < dimension_; ++j) action(Target{kind, j, nullptr});
  if (kind != Kind::limit) return;
  for (const Boundary& each : limits_)
    if (each.branch == 0 || each.branch == mode_.sign(each.leg)) action(Target{kind, each.leg, &each});
}

Interval HingeSearch::side(const Boundary& boundary, const Box& box) const noexcept {
  return Interval(static_cast<double>(mode_.sign(boundary.leg))) *
         boundary.side(displacement(box, boundary.leg));
}

bool HingeSearch::may_hold(const Boundary& boundary, const Box& box) const noexcept {
  const Interval off = boundary.signed_distance(displacement(box, boundary.leg));
  if (off.positive() || off.negative()) return false;
  return !boundary.sided || !side(boundary, box).negative();
}

// Where it may not, no pose of the box that all legs reach is of the boundary.
bool HingeSearch::may_hold(Kind kind, const Box& box) const noexcept {
  if (kind == Kind::limit) {
    bool may = false;
    for_each_target(kind, [&](const Target& target) { may = may || may_hold(*target.limit, box); });
    if (!may) return false;
  }
  const BoxFacts facts = classifier_->facts(0, box, mode_index_);
  if (facts.unreachable != 0) return false;
  if (kind == Kind::parallel) return facts.determinant_sign == 0;
  return kind == Kind::limit || facts.clear != facts.legs;
}

// Nearer poses of the boundary than this are searched for.
double HingeSearch::least_way(const BoundaryDistance& found) const noexcept {
  return (1.0 - options_.tolerance) * found.upper;
}

// D is 0 of the box that holds the pose itself, so that boxes about it are examined first, and it is found
// whether the pose touches the boundary.
BoundaryDistance HingeSearch::search(Kind kind) noexcept {
  BoundaryDistance found;
  attempts_ = 0;
  queue_.clear();
  bool any = false;
  for_each_target(kind, [&](const Target&) { any = true; });
  Box all{dimension_, {-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}};
  if (any) queue_.push_back({0.0, all});
  while (!queue_.empty() && queue_.front().bound < least_way(found) && found.boxes < most_boxes()) {
    std::pop_heap(queue_.begin(), queue_.end());
    const Box box = queue_.back().box;
    queue_.pop_back();
    const std::size_t widest = dimension_ == 2 && box.width(1) > box.width(0) ? 1 : 0;
    for (const bool upper : {false, true}) {
      Box half = box;
      (upper ? half.lower : half.upper)[widest] = box.center(widest);
      ++found.boxes;
      const double bound = std::max(0.0, distance_to(half).lower());
      if (!(bound < least_way(found)) || !may_hold(kind, half)) continue;
      for_each_target(kind, [&](const Target& target) {
        if (target.limit == nullptr || may_hold(*target.limit, half))
          look_for_witness(target, {half.center(0), half.center(1)}, found);
      });
      queue_.push_back({bound, half});
      std::push_heap(queue_.begin(), queue_.end());
    }
  }
  finish(found);
  return found;
}

void HingeSearch::finish(BoundaryDistance& found) const noexcept {
  const bool has_witness = found.upper < infinity;
  found.lower = queue_.empty() ? least_way(found) : std::min(queue_.front().bound, least_way(found));
  if (queue_.empty() && !has_witness)
    found.status = DistanceStatus::absent;
  else if (!has_witness)
    found.status = DistanceStatus::no_witness;
  else
    found.status = found.lower >= least_way(found) ? DistanceStatus::tight : DistanceStatus::loose;
}

std::optional<double> HingeSearch::value(const Target& target, const Angles& angles) const noexcept {
  const Pose pose = pose_at(angles);
  if (target.kind == Kind::serial) {
    for (std::size_t j = 0; j < dimension_; ++j)
      if (j != target.leg &&
          !(squared_inverse_entry(robot_->leg(j), pose.transform(robot_->leg(j).anchor)) >= 0.0))
        return std::nullopt;
    const Leg& leg = robot_->leg(target.leg);
    return squared_inverse_entry(leg, pose.transform(leg.anchor));
  }
  const InverseSolution solution = inverse(*robot_, pose, mode_);
  if (solution.status == InverseStatus::out_of_reach) return std::nullopt;
  if (target.kind == Kind::parallel) return direct_determinant(*robot_, pose, solution.q);
  const Leg& leg = robot_->leg(target.leg);
  const double limit = target.limit->end == LimitEnd::lower ? leg.limits.lower : leg.limits.upper;
  const double off = solution.q[static_cast<Eigen::Index>(target.leg)] - limit;
  return leg.actuated_by_angle() ? std::remainder(off, full_turn) : off;
}

std::optional<HingeSearch::Angles> HingeSearch::slope(const Target& target, const Angles& angles,
                                                      double value_there) const noexcept {
  Angles result{};
  for (std::size_t i = 0; i < dimension_; ++i) {
    Angles beside = angles;
    beside[i] += small_step;
    const auto after = value(target, beside);
    if (!after) return std::nullopt;
    result[i] = (*after - value_there) / small_step;
  }
  return result;
}

void HingeSearch::look_for_witness(const Target& target, const Angles& start,
                                   BoundaryDistance& found) noexcept {
  if (attempts_ >= most_attempts || !value(target, start)) return;
  ++attempts_;
  Angles at = start, direction{};
  for (int i = 0; i < newton_steps; ++i) {
    const auto f = value(target, at);
    if (!f) return;
    const auto gradient = slope(target, at, *f);
    if (!gradient) return;
    const double squared = (*gradient)[0] * (*gradient)[0] + (*gradient)[1] * (*gradient)[1];
    if (!(squared > 0.0)) return;
    double length = 0.0;
    for (std::size_t k = 0; k < dimension_; ++k) {
      const double step = *f * (*gradient)[k] / squared;
      at[k] -= step;
      length += std::abs(step);
      direction[k] = (*gradient)[k] / std::sqrt(squared);
    }
    if (length < 1e-15) break;
    if (!(length < 0.5)) return;
  }
  for (std::size_t k = 0; k < dimension_; ++k) at[k] = std::remainder(at[k], 2.0);
  const Box there = point_box(dimension_, at);
  if (target.limit != nullptr && target.limit->sided && side(*target.limit, there).negative()) return;
  const double proved = proved_distance(target, at, direction);
  const double distance = proved < infinity ? proved : distance_to(there).upper();
  if (proved == infinity) {
    const auto f = value(target, at), beside = value(target, {at[0] + small_step, at[1]});
    if (!f || !beside || !(std::abs(*f) < 1e-3 * std::abs(*beside - *f))) return;
  }
  if (!(distance < found.upper)) return;
  found.upper = distance;
  found.upper_proved = proved < infinity;
  found.witness = pose_at(at);
  found.leg = target.leg;
  if (target.limit != nullptr) found.end = target.limit->end;
}

// By a change of sign across the witness; infinite where none is proved.
double HingeSearch::proved_distance(const Target& target, const Angles& at,
                                    const Angles& direction) const noexcept {
  for (double offset = 1e-14; offset < 1e-6; offset *= 10.0) {
    Angles before = at, after = at;
    for (std::size_t k = 0; k < dimension_; ++k) {
      before[k] -= offset * direction[k];
      after[k] += offset * direction[k];
    }
    const Box first = point_box(dimension_, before), last = point_box(dimension_, after);
    const Box all = hull_of(first, last);
    if (is_crossed(target, first, last, all)) return distance_to(all).upper();
  }
  return infinity;
}

bool HingeSearch::is_crossed(const Target& target, const Box& before, const Box& after,
                             const Box& all) const noexcept {
  const BoxFacts between = classifier_->facts(0, all, mode_index_);
  const LegSet but = target.kind == Kind::serial ? BoxFacts::bit(target.leg) : LegSet{0};
  if ((between.clear | but) != between.legs) return false;
  if (target.kind == Kind::limit) {
    const Interval first = target.limit->signed_distance(displacement(before, target.leg)),
                   last = target.limit->signed_distance(displacement(after, target.leg));
    const bool changes = (first.positive() && last.negative()) || (first.negative() && last.positive());
    return changes && (!target.limit->sided || side(*target.limit, all).positive());
  }
  const BoxFacts first = classifier_->facts(0, before, mode_index_),
                 last = classifier_->facts(0, after, mode_index_);
  if (target.kind == Kind::parallel) return first.determinant_sign * last.determinant_sign < 0;
  const auto sign = [but](const BoxFacts& facts) {
    return (facts.clear & but) != 0 ? 1 : (facts.unreachable & but) != 0 ? -1 : 0;
  };
  return sign(first) * sign(last) < 0;
}

// The displacements that lead to the witness, and the twist that the way there starts with.
void HingeSearch::describe(const Pose& from, const JointVector& q, BoundaryDistance& found) const noexcept {
  if (!(found.upper < infinity)) return;
  const Angles here = angles_of(from), there = angles_of(found.witness);
  found.direction = TaskVector::Zero(static_cast<Eigen::Index>(dimension_));
  for (std::size_t i = 0; i < dimension_; ++i)
    found.direction[static_cast<Eigen::Index>(i)] = pi * std::remainder(there[i] - here[i], 2.0);
  constexpr double share = 1e-6;
  const double moved =
      anchor_distance(*robot_, from, displaced(robot_->motions(), from, share * found.direction)) / share;
  if (moved > 0.0) found.direction /= moved;
  add_joints_of_witness(*robot_, mode_, q, found);
}

}  // namespace parallel_aspects
