// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/domain_finder.h"

#include "aspects/uniqueness/uniqueness_problem.h"

#include <ros/console.h>

#include <cmath>
#include <exception>
#include <utility>

namespace parallel_aspects {
namespace {

KnownDomains before_the_map(const Manipulator& manipulator, bool enabled) {
  if (has_one_solution_a_sign(manipulator.task_space()))
    return {UniquenessState::ASPECTS,
            "Each aspect is one: actuated values have at most two poses, with opposite signs of det A.",
            nullptr};
  const std::string problem = find_uniqueness_problem(manipulator, {});
  if (!problem.empty())
    return {UniquenessState::NONE,
            "The node looks at all poses of the robot, and of these they are not known. " + problem, nullptr};
  if (!enabled)
    return {
        UniquenessState::OFF,
        "They are not computed; set uniqueness/enabled, which takes up to some minutes of processor time and "
        "some GB of memory once the map is complete.",
        nullptr};
  return {UniquenessState::WAITING, "They are computed after the map.", nullptr};
}

std::string summary(const Uniqueness& uniqueness) {
  return "Basic regions: " + std::to_string(uniqueness.basic_regions.size()) +
         ", uniqueness domains: " + std::to_string(uniqueness.domains.size()) +
         (uniqueness.domains_complete ? "." : ", and there are more.");
}

KnownDomains known_by(const UniquenessResult& result) {
  if (!result) return {UniquenessState::NONE, result.message, nullptr};
  return {UniquenessState::REGIONS, summary(*result.uniqueness), result.uniqueness};
}

void say(const KnownDomains& known) { ROS_INFO_STREAM("Uniqueness domains: " << known.message); }

}  // namespace

// Of what nobody asked for, and cannot be had, the log says nothing.
DomainFinder::DomainFinder(const Manipulator& manipulator, const UniquenessParameters& parameters)
    : parameters_(parameters),
      known_(before_the_map(manipulator, parameters.enabled)),
      computes_(known_.known == UniquenessState::WAITING) {
  if (known_.known != UniquenessState::NONE)
    say(known_);
  else if (parameters.enabled)
    ROS_WARN_STREAM("Uniqueness domains: " << known_.message);
}

void DomainFinder::find(const std::shared_ptr<const AspectMap>& map, const std::atomic<bool>& cancelled) {
  if (!computes_ || !map) return;
  set({UniquenessState::WAITING, "They are being computed.", nullptr});
  double said = 0.0;
  MapControl control;
  control.cancelled = &cancelled;
  control.progress = [&](double share) {
    if (share < said + 0.1) return;
    said = share;
    set({UniquenessState::WAITING,
         "They are being computed, " + std::to_string(std::lround(100.0 * share)) + " %.", nullptr});
  };
  UniquenessOptions options;
  if (parameters_.most_cells) options.most_cells = static_cast<std::size_t>(*parameters_.most_cells);
  KnownDomains found;
  try {
    found = known_by(compute_uniqueness(map, options, control));
  } catch (const std::exception& failure) {  // as when there is not enough memory
    found = {UniquenessState::NONE, std::string("Their computation ended early: ") + failure.what() + ".",
             nullptr};
  }
  set(std::move(found));
}

KnownDomains DomainFinder::known() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return known_;
}

void DomainFinder::set(KnownDomains known) {
  say(known);
  const std::lock_guard<std::mutex> lock(mutex_);
  known_ = std::move(known);
}

}  // namespace parallel_aspects
