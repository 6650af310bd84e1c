// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/distance/boundary_distances.h"

#include "aspects/constraints/finite_lengths.h"
#include "distance/hinge_search.h"
#include "distance/leg_search.h"
#include "distance/parallel_search.h"
#include "distance/search_result.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/problems.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

// See finite_lengths.h.
constexpr double longest_length = 1e9;  // [m]
constexpr int max_boxes_at_all = 10'000'000;

// What the task space does not move is left out.
Pose within(TaskSpace space, const Pose& pose) {
  Pose result = pose;
  for (std::size_t i = traits(space).translations; i < 3; ++i)
    result.position[static_cast<Eigen::Index>(i)] = 0.0;
  if (traits(space).rotations == 0) result.orientation.setIdentity();
  if (traits(space).rotations == 1) result.orientation.x() = result.orientation.y() = 0.0;
  return result;
}

bool has_branches(const Manipulator& manipulator, const WorkingMode& mode) {
  if (mode.leg_count() != manipulator.leg_count()) return false;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    if (!manipulator.leg(j).has_branch(mode.sign(j))) return false;
  return true;
}

}  // namespace

/// The searches of one manipulator, whatever its task space.
class BoundaryDistanceMeter::Searches {
 public:
  virtual ~Searches() = default;
  virtual void use(std::shared_ptr<const DistanceMap> map) = 0;
  virtual BoundaryDistances measure(const Pose& pose, const WorkingMode& mode) noexcept = 0;
};

template <TaskSpace space>
class BoundaryDistanceMeter::SearchesIn final : public Searches {
 public:
  using Chart = LocalChart<space>;

  SearchesIn(std::shared_ptr<const Manipulator> manipulator, const DistanceOptions& options)
      : manipulator_(std::move(manipulator)),
        chart_(*manipulator_),
        boundaries_(boundaries_of(*manipulator_)),
        determinant_(chart_, *manipulator_),
        map_(chart_),
        parallel_(chart_, map_, options),
        leg_(chart_, options),
        usable_(is_usable(*manipulator_, longest_length) && chart_.metric().usable) {}

  void use(std::shared_ptr<const DistanceMap> map) override {
    if (map && map->map()->manipulator() != manipulator_)
      throw InvalidDescription(
          {"The map is of another robot than the distances are to be of; compute or load "
           "it for the same manipulator."});
    map_.use(std::move(map));
  }

  BoundaryDistances measure(const Pose& given, const WorkingMode& mode) noexcept override {
    BoundaryDistances result;
    if (!usable_ || !is_usable(given, longest_length) || !has_branches(*manipulator_, mode)) return result;
    const Pose pose = within(space, given);
    if (!is_usable(pose, longest_length)) return result;
    const InverseSolution solution = begin_distances(*manipulator_, pose, mode, result);
    if (solution.status == InverseStatus::out_of_reach) return result;
    search(pose, mode, result);
    if (solution.status == InverseStatus::outside_limits) result.actuated_limit = touching(solution.leg);
    return result;
  }

 private:
  static LegBoundaries<Chart::dimension> boundaries_of(const Manipulator& manipulator) {
    const RoundingUpward rounding;
    return leg_boundaries<Chart::dimension>(manipulator);
  }

  void search(const Pose& pose, const WorkingMode& mode, BoundaryDistances& result) noexcept {
    std::optional<SearchResult<Chart::size>> parallel, serial, limit;
    {
      const RoundingUpward rounding;
      chart_.move_to(pose);
      determinant_.set_mode(mode);
      map_.set_mode(mode);
      if (const auto leg = determinant_.unproved_leg(std::array<Interval, Chart::size>{})) {
        result.status = ConfigurationStatus::at_serial_singularity;
        result.serial = touching(*leg);
        return;
      }
      const SearchRange range = search_range();
      parallel = parallel_.run(determinant_, range);
      serial = leg_.run(boundaries_.serial, false, mode, determinant_, range);
      limit = leg_.run(boundaries_.limits, true, mode, determinant_, range);
      for (auto* each : {&*parallel, &*serial, &*limit}) {
        each->lower = -((chart_.metric().error - 1.0) * each->lower);
        each->upper *= 1.0 + chart_.metric().error;
      }
    }
    result.parallel = translated(*parallel, mode, result.q);
    result.serial = translated(*serial, mode, result.q);
    result.actuated_limit = translated(*limit, mode, result.q);
  }

  // Poses that all legs reach are within the reach of each.
  SearchRange search_range() const noexcept {
    SearchRange range{2.0 * manipulator_->size(), false};
    const AnchorMetric& metric = chart_.metric();
    if (traits(space).translations == 0) return {metric.widest_turn * (1.0 + 1e-12), true};
    for (std::size_t j = 0; j < Chart::size; ++j) {
      const Leg& leg = manipulator_->leg(j);
      const double reach = leg.longest_reach();
      if (!std::isfinite(reach)) continue;
      Interval squared;
      for (const Interval& each : chart_.displacement_at_origin(j)) squared += square(each);
      const double height = Chart::planar ? std::abs(leg.anchor.z() - leg.base_point().z()) : 0.0;
      const double far =
          std::sqrt(squared.upper()) + height + reach + (Chart::turns > 0 ? 2.0 * metric.longest_arm : 0.0);
      const double radius = std::sqrt(far * far + metric.widest_turn * metric.widest_turn) * (1.0 + 1e-12);
      const bool holds_all = leg.kind().bounded_by_links;
      if (holds_all ? !range.holds_all || radius < range.radius : !range.holds_all && radius < range.radius)
        range = {radius, holds_all};
    }
    return range;
  }

  BoundaryDistance translated(const SearchResult<Chart::size>& found, const WorkingMode& mode,
                              const JointVector& q) const noexcept {
    BoundaryDistance result;
    result.status = found.status;
    result.lower = found.lower;
    result.upper = found.upper;
    result.upper_proved = found.upper_proved;
    result.leg = found.leg;
    result.end = found.end;
    result.boxes = found.boxes;
    if (!found.has_witness()) return result;
    result.witness = chart_.pose_at(found.witness);
    result.direction = chart_.direction_to(found.witness);
    add_joints_of_witness(*manipulator_, mode, q, result);
    return result;
  }

  std::shared_ptr<const Manipulator> manipulator_;
  Chart chart_;
  LegBoundaries<Chart::dimension> boundaries_;
  ModeDeterminant<space> determinant_;
  MapSearch<space> map_;
  ParallelSearch<space> parallel_;
  LegSearch<space> leg_;
  bool usable_;
};

/// Of angles of hinges, whose poses have no coordinates in which distances are lengths.
class BoundaryDistanceMeter::HingeSearches final : public Searches {
 public:
  HingeSearches(std::shared_ptr<const Manipulator> manipulator, const DistanceOptions& options)
      : manipulator_(std::move(manipulator)), search_(*manipulator_, options) {}

  void use(std::shared_ptr<const DistanceMap>) override {}  // two angles are searched as fast without

  BoundaryDistances measure(const Pose& pose, const WorkingMode& mode) noexcept override {
    if (!is_usable(*manipulator_, longest_length) || !is_usable(pose, longest_length) ||
        !has_branches(*manipulator_, mode))
      return {};
    return search_.measure(pose, mode);
  }

 private:
  std::shared_ptr<const Manipulator> manipulator_;
  HingeSearch search_;
};

BoundaryDistanceMeter::BoundaryDistanceMeter(std::shared_ptr<const Manipulator> manipulator,
                                             const DistanceOptions& options) {
  Problems problems;
  if (!(options.tolerance > 0.0 && options.tolerance < 1.0))
    problems.push_back("The tolerance of distances must be between 0 and 1; choose one such as 0.01.");
  if (options.max_boxes < 1 || options.max_boxes > max_boxes_at_all)
    problems.push_back(
        "The number of boxes of a search must be from 1 to 10000000; choose one such as 2000.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const TaskSpace task_space = manipulator->task_space();
  searches_ = with_task_space(task_space, [&](auto constant) -> std::unique_ptr<Searches> {
    constexpr TaskSpace space = decltype(constant)::value;
    if constexpr (is_of_hinges(space))
      return std::make_unique<HingeSearches>(std::move(manipulator), options);
    else
      return std::make_unique<SearchesIn<space>>(std::move(manipulator), options);
  });
}

BoundaryDistanceMeter::~BoundaryDistanceMeter() = default;
BoundaryDistanceMeter::BoundaryDistanceMeter(BoundaryDistanceMeter&&) noexcept = default;
BoundaryDistanceMeter& BoundaryDistanceMeter::operator=(BoundaryDistanceMeter&&) noexcept = default;

void BoundaryDistanceMeter::use(std::shared_ptr<const DistanceMap> map) { searches_->use(std::move(map)); }

BoundaryDistances BoundaryDistanceMeter::measure(const Pose& pose, const WorkingMode& mode) noexcept {
  return searches_->measure(pose, mode);
}

const char* name(DistanceStatus status) noexcept {
  switch (status) {
    case DistanceStatus::tight:
      return "tight";
    case DistanceStatus::loose:
      return "loose";
    case DistanceStatus::no_witness:
      return "no witness";
    case DistanceStatus::absent:
      return "absent";
    case DistanceStatus::touching:
      return "touching";
    case DistanceStatus::unavailable:
      return "unavailable";
  }
  return "unknown";
}

const char* name(ConfigurationStatus status) noexcept {
  switch (status) {
    case ConfigurationStatus::measured:
      return "measured";
    case ConfigurationStatus::outside_limits:
      return "outside limits";
    case ConfigurationStatus::at_serial_singularity:
      return "at a serial singularity";
    case ConfigurationStatus::out_of_reach:
      return "out of reach";
    case ConfigurationStatus::invalid:
      return "invalid";
  }
  return "unknown";
}

const char* name(LimitEnd end) noexcept { return end == LimitEnd::lower ? "lower" : "upper"; }

}  // namespace parallel_aspects
