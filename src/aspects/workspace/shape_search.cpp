// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/workspace/shape_search.h"

#include "interval/interval.h"
#include "model/message_text.h"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

// Open leaves are divided down to this share of the gap, and of the extent of the centers that are examined.
constexpr double share_of_gap = 0.25, share_of_extent = 0.5;

// Centers closer to each other than this share of the gap are not distinguished.
constexpr double least_extent = 0.02;

// Centers closer to each other than this share of what is unknown of the room about them are not, either.
constexpr double share_of_unknown = 0.25;

// Where no shape is found, those below this share of all positions are not searched for.
constexpr double least_share = 0x1p-10;

// Leaves are not divided below this share of all positions.
constexpr double finest_share = 0x1p-22;

/// The center in few digits, so that what is printed is what is proved; the same for its mirror image.
MapPoint in_few_digits(MapPoint point) {
  const int rounding = std::fegetround();
  std::fesetround(FE_TONEAREST);
  for (double& value : point) value = std::stod(number_text(value, 6));
  std::fesetround(rounding);
  return point;
}

}  // namespace

ShapeSearch::ShapeSearch(UsableLeaves& leaves, const ShapeGauge& gauge, int aspect, std::vector<int> like,
                         double of_interest, const WorkspaceOptions& options)
    : leaves_(leaves), gauge_(gauge), like_(std::move(like)), of_interest_(of_interest), options_(options) {
  best_.aspect = aspect;
}

RegularWorkspace ShapeSearch::run(const Box& centers, const MapPoint& first) {
  assert_rounding_upward();
  whole_ = gauge_.half_extent(leaves_.positions());
  if (centers.contains(first)) take(first, leaves_.room(first, HUGE_VAL, 0.0).lower);
  push(centers, HUGE_VAL, std::nullopt);
  const std::size_t last_look = leaves_.looks() + options_.leaves;
  while (!queue_.empty() && queue_.top().bound > enough() && !is_cancelled(options_.control) &&
         leaves_.looks() < last_look) {
    const Cell cell = queue_.top();
    queue_.pop();
    halve(cell);
  }
  if (!queue_.empty()) give_up(queue_.top().bound);
  settle(centers);
  return best_;
}

double ShapeSearch::enough() const {
  if (best_.lower <= 0.0) return std::max(of_interest_, least_share * whole_);
  return std::max(of_interest_, best_.lower / (1.0 - options_.gap));
}

double ShapeSearch::finest_extent(double size) const {
  return std::max(share_of_gap * options_.gap * std::max(size, of_interest_), finest_share * whole_);
}

ShapeRoom ShapeSearch::room_about(const MapPoint& center, double half) {
  const double coarse = std::max(share_of_extent * half, finest_extent(best_.lower));
  const ShapeRoom room = leaves_.room(center, half > 0.0 ? coarse : HUGE_VAL, enough() - half);
  // A center that is held has no extent of its own.
  return half > 0.0 ? room : leaves_.room(center, finest_extent(room.lower), 0.0);
}

void ShapeSearch::give_up(double bound) { best_.upper = std::max(best_.upper, bound); }

// Left out are boxes of centers about which no shape is larger than `known`, which bounds what is reported,
// and those that hold no pose of these aspects. The bound of the box holds for its parts, and so does the
// obstacle: no shape holds that, wherever its center is.
void ShapeSearch::push(const Box& centers, double bound, const std::optional<MapPoint>& obstacle) {
  const double half = gauge_.half_extent(centers);
  double known = bound;
  if (obstacle) {
    const Box point{gauge_.dimension(), *obstacle, *obstacle};
    known = std::min(known, gauge_.distance(centers.middle(), point) + half);
  }
  if (known <= enough()) return give_up(known);
  if (!leaves_.may_hold(like_, centers)) return;
  add({centers, known, obstacle}, half);
}

void ShapeSearch::add(const Cell& cell, double half) {
  const double gap = options_.gap * std::max(best_.lower, of_interest_);
  const MapPoint center = cell.centers.middle();
  const ShapeRoom room = room_about(center, half);
  const double bound = std::min(cell.bound, room.upper + half);
  if (room.lower > 0.0 && (room.lower > best_.lower || room.lower >= half)) {
    const int aspect = leaves_.aspect_of(center, room.lower);
    const bool is_like = aspect == 0 || std::find(like_.begin(), like_.end(), aspect) != like_.end();
    if (aspect == best_.aspect && room.lower > best_.lower) take(center, room.lower);
    if (!is_like && room.lower >= half) return;  // all of these centers are in another aspect
  }
  // Where the room stays unknown, to know the center better does not help.
  const bool is_unknown = half <= share_of_unknown * (room.upper - room.lower);
  if (bound <= enough() || half <= least_extent * gap || is_unknown) return give_up(bound);
  queue_.push({cell.centers, bound, room.obstacle});
}

void ShapeSearch::take(const MapPoint& center, double size) {
  if (size <= best_.lower || leaves_.aspect_of(center, size) != best_.aspect) return;
  best_.lower = size;
  best_.center = center;
}

void ShapeSearch::halve(const Cell& cell) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < gauge_.dimension(); ++i)
    if (cell.centers.width(i) * gauge_.reach(longest) > cell.centers.width(longest) * gauge_.reach(i))
      longest = i;
  Box lower = cell.centers, upper = cell.centers;
  lower.upper[longest] = upper.lower[longest] = cell.centers.center(longest);
  push(lower, cell.bound, cell.obstacle);
  push(upper, cell.bound, cell.obstacle);
}

// The shape that is reported, proved once more as it is. What is held of its center is kept to the last
// digit.
void ShapeSearch::settle(const Box& centers) {
  MapPoint center = in_few_digits(best_.center);
  for (std::size_t i = 0; i < gauge_.dimension(); ++i)
    if (centers.lower[i] == centers.upper[i]) center[i] = centers.lower[i];
  const double size = leaves_.room(center, finest_extent(best_.lower), 0.0).lower * (1.0 - few_units);
  const bool holds =
      size > 0.0 && leaves_.holds(center, size) && leaves_.aspect_of(center, size) == best_.aspect;
  best_.lower = holds ? size : 0.0;
  best_.center = center;
  best_.upper = std::max(best_.upper, best_.lower) * (1.0 + few_units);
  best_.proved = best_.upper - best_.lower <= options_.gap * best_.upper;
}

}  // namespace parallel_aspects
