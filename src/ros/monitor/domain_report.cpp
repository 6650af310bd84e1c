// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/domain_report.h"

#include "ros/messages/conversions.h"

#include <utility>

namespace parallel_aspects {
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
         (transition.domain_shared
              ? "a uniqueness domain holds " + reference + ", again"
              : no_domain_holds(sharing) + reference + "; the actuated joints alone do not tell the pose");
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
         ", where tracking began: the actuated joints alone do not tell the pose";
}

}  // namespace parallel_aspects
