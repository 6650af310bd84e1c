// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/known_domains.h"

#include "aspects/uniqueness/uniqueness_problem.h"
#include "parallel_aspects/ask/uniqueness_question.h"
#include "ros/messages/conversions.h"

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
            "The node examines all poses of the robot, and of these they are not known. " + problem, nullptr};
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

KnownDomains known_by(const ask::Outcome<ask::UniquenessAnswer>& outcome) {
  if (outcome.status == MapStatus::refused)
    return {UniquenessState::NONE, text_of(outcome.problems.front(), ask::plain_name), nullptr};
  if (!outcome) return {UniquenessState::NONE, "Their computation was cancelled.", nullptr};
  const auto& found = std::get<std::shared_ptr<const Uniqueness>>(outcome.answer.found);
  return {UniquenessState::REGIONS, summary(*found), found};
}

void say(const KnownDomains& known) { ROS_INFO_STREAM("Uniqueness domains: " << known.message); }

}  // namespace

// The log is silent about domains that were not asked for and cannot be computed.
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
  ask::Control control;
  control.cancelled = &cancelled;
  control.progress = [&](const char* /*step*/, double share) {
    if (share < said + 0.1) return;
    said = share;
    set({UniquenessState::WAITING,
         "They are being computed, " + std::to_string(std::lround(100.0 * share)) + " %.", nullptr});
  };
  ask::Session session(map->manipulator());
  session.know(map);
  ask::UniquenessQuestion question;
  if (parameters_.most_cells) question.most_cells = static_cast<std::size_t>(*parameters_.most_cells);
  KnownDomains found;
  try {
    found = known_by(ask::answer(session, question, control));
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

namespace {

std::uint32_t number_of(const std::optional<std::size_t>& region) {
  return region ? static_cast<std::uint32_t>(*region + 1) : 0;
}

std::uint8_t sharing_message(DomainSharing sharing) {
  switch (sharing) {
    case DomainSharing::shared:
      return UniquenessState::SHARED;
    case DomainSharing::apart:
      return UniquenessState::APART;
    case DomainSharing::unknown:
      break;
  }
  return UniquenessState::UNKNOWN;
}

std::string no_domain_holds(std::uint8_t sharing) {
  return sharing == UniquenessState::APART ? "no uniqueness domain holds "
                                           : "no uniqueness domain is known to hold ";
}

std::string text_of(const AspectTransition& transition, std::uint8_t sharing) {
  const std::string reference =
      "it and basic region " + std::to_string(transition.reference_region) + ", where tracking began";
  return "basic region " + std::to_string(transition.basic_region_before) + " -> " +
         std::to_string(transition.basic_region_after) + ": " +
         (transition.domain_shared ? "a uniqueness domain holds " + reference + ", again"
                                   : no_domain_holds(sharing) + reference +
                                         "; the actuated joints alone do not determine the pose");
}

}  // namespace

DomainReport::DomainReport(std::shared_ptr<const Manipulator> manipulator, double hold)
    : manipulator_(std::move(manipulator)), hold_(hold) {}

bool DomainReport::use(const KnownDomains& known) {
  const bool same = known.known == known_.known && known.uniqueness == known_.uniqueness;
  if (same) return false;
  known_ = known;
  watch_.reset();
  if (known_.uniqueness) watch_.emplace(known_.uniqueness, hold_);
  start_ = 0;
  return true;
}

bool DomainReport::look(const TrackedState& tracked, const TrackingStart& start) {
  if (!watch_ || tracked.status != TrackStatus::tracking) return false;
  const bool anew = std::exchange(start_, start.number) != start.number;
  if (!anew && tracked.time == time_) return false;
  if (anew) {
    watch_->restart();
    watch_->update(start.pose, start.mode, start.time);
  }
  time_ = tracked.time;
  const DomainState& found = watch_->update(tracked.pose, tracked.mode, tracked.time);
  state_ = message_of(found, start.epoch + ros::Duration(tracked.time));
  transition_.reset();
  if (found.changed) transition_ = transition_of(found, tracked, start.epoch);
  return true;
}

UniquenessState DomainReport::message_of(const DomainState& found, const ros::Time& stamp) const {
  UniquenessState message = unknown_domains(known_.known);
  message.stamp = stamp;
  message.basic_region = number_of(found.region);
  message.reference_region = number_of(found.reference);
  if (found.region)
    for (const std::size_t domain : known_.uniqueness->domains_of(*found.region))
      message.domains.push_back(static_cast<std::uint32_t>(domain + 1));
  message.sharing = sharing_message(found.sharing);
  message.warns = found.warns;
  return message;
}

AspectTransition DomainReport::transition_of(const DomainState& found, const TrackedState& tracked,
                                             const ros::Time& epoch) const {
  AspectTransition message;
  message.header.stamp = epoch + ros::Duration(found.since);
  message.header.frame_id = manipulator_->base_frame();
  message.kind = AspectTransition::UNIQUENESS;
  message.working_mode_before = message.working_mode_after = signs_message(tracked.mode);
  message.determinant_sign_before = message.determinant_sign_after =
      static_cast<std::int8_t>(tracked.determinant_sign);
  message.aspect_before = message.aspect_after = static_cast<std::uint32_t>(tracked.aspect);
  message.basic_region_before = number_of(found.before);
  message.basic_region_after = number_of(found.region);
  message.reference_region = number_of(found.reference);
  message.domain_shared = !found.warns;
  message.message = text_of(message, sharing_message(found.sharing));
  return message;
}

UniquenessState unknown_domains(std::uint8_t known) {
  UniquenessState state;
  state.known = known;
  return state;
}

std::string warning_of(const UniquenessState& state) {
  return no_domain_holds(state.sharing) + "the pose and basic region " +
         std::to_string(state.reference_region) +
         ", where tracking began: the actuated joints alone do not determine the pose";
}

}  // namespace parallel_aspects
