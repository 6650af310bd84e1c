// SPDX-License-Identifier: BSD-3-Clause
#include "ros/plan/path_domains.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace parallel_aspects {
namespace {

constexpr int poses_of_a_segment = 32;

std::set<std::size_t> regions_along(const PlannedPath& path, const PoseBetween& between,
                                    const Uniqueness& uniqueness) {
  std::set<std::size_t> regions;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    for (int k = 0; k <= poses_of_a_segment; ++k) {
      const double t = static_cast<double>(k) / poses_of_a_segment;
      const Pose pose = between(path.points[i].pose, path.points[i + 1].pose, t);
      if (const auto region = uniqueness.locate(pose, path.points[i].mode)) regions.insert(*region);
    }
  return regions;
}

bool has_two_apart(const std::set<std::size_t>& regions, const Uniqueness& uniqueness) {
  for (const std::size_t a : regions)
    for (const std::size_t b : regions)
      if (a < b && uniqueness.sharing(a, b) == DomainSharing::apart) return true;
  return false;
}

std::vector<std::size_t> domains_of_all(const std::set<std::size_t>& regions, const Uniqueness& uniqueness) {
  std::vector<std::size_t> common;
  for (const std::size_t region : regions) {
    const std::vector<std::size_t> domains = uniqueness.domains_of(region);  // rising
    std::vector<std::size_t> both;
    std::set_intersection(common.begin(), common.end(), domains.begin(), domains.end(),
                          std::back_inserter(both));
    common = region == *regions.begin() ? domains : both;
  }
  return common;
}

bool is_proved(const PlannedPath& path, const Uniqueness& uniqueness) {
  if (!uniqueness.regions_along || !path.crossings.empty()) return false;
  std::vector<Pose> poses;
  for (const PathPoint& point : path.points) poses.push_back(point.pose);
  return uniqueness.regions_along(poses).has_value();
}

PathDomains in_regions(const PlannedPath& path, const PoseBetween& between, const Uniqueness& uniqueness,
                       bool in_slice) {
  const std::set<std::size_t> regions = regions_along(path, between, uniqueness);
  if (has_two_apart(regions, uniqueness))
    return {
        SameAspect::no, {}, "two of its poses lie in basic regions that no uniqueness domain holds both."};
  PathDomains result;
  result.domains = domains_of_all(regions, uniqueness);
  if (!in_slice && is_proved(path, uniqueness)) {
    result.in_one = SameAspect::yes;
    return result;
  }
  result.message = result.domains.empty()
                       ? "no uniqueness domain is known that holds all of it."
                       : "that it stays in one uniqueness domain was seen at 32 poses a segment, and is not "
                         "proved of what lies between.";
  return result;
}

}  // namespace

PathDomains domains_along(const PlannedPath& path, const PoseBetween& between, const KnownDomains& known,
                          bool in_slice) {
  if (!path) return {};
  if (known.known == UniquenessState::ASPECTS) {
    if (path.crossings.empty()) return {SameAspect::yes, {}, ""};
    return {SameAspect::no, {}, "it leaves an aspect, and with that its uniqueness domain."};
  }
  if (known.uniqueness) return in_regions(path, between, *known.uniqueness, in_slice);
  return {SameAspect::unknown, {}, "uniqueness domains are not known. " + known.message};
}

void write_domains(const PathDomains& domains, PlanPathResult& result) {
  result.in_one_domain = domains.in_one == SameAspect::yes  ? PlanPathResult::YES
                         : domains.in_one == SameAspect::no ? PlanPathResult::NO
                                                            : PlanPathResult::UNKNOWN;
  for (const std::size_t domain : domains.domains)
    result.domains.push_back(static_cast<std::uint32_t>(domain + 1));
}

}  // namespace parallel_aspects
