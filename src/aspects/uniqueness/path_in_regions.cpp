// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/path_in_regions.h"

#include "interval/interval.h"
#include "parallel_aspects/model/manipulator.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr int most_halvings = 24;

/// Where a segment is divided, in the order that they are tried: not in a strip.
constexpr std::array<double, 7> shares{0.5, 0.375, 0.625, 0.25, 0.75, 0.125, 0.875};

/// a + t (b - a), by t.
struct Linear {
  Interval at, rate;

  Linear(double a, double b, const Interval& t) noexcept : rate(Interval(b) - Interval(a)) {
    at = Interval(a) + t * rate;
  }
};

Interval quotient(const Interval& a, const Interval& b) noexcept { return a * reciprocal(b, b.lower()); }

/// Between lengths that touch each other at least.
bool may_meet(const LengthRanges& a, const LengthRanges& b) noexcept {
  for (std::size_t i = 0; i < 3; ++i)
    if (a[i].upper() < b[i].lower() || b[i].upper() < a[i].lower()) return false;
  return true;
}

}  // namespace

StrutSegment::StrutSegment(const Manipulator& manipulator, const StrutSlice& family, const Pose& from,
                           const Pose& to) noexcept
    : manipulator_(manipulator), legs_{family.leg(0), family.leg(1), family.leg(2)}, from_(from), to_(to) {
  if (from.orientation.dot(to.orientation) < 0.0) to_.orientation.coeffs() = -to.orientation.coeffs();
}

// The quaternion runs straight, so that sine and cosine are rational functions of t.
std::optional<StrutSegment::Enclosure> StrutSegment::over(const Interval& t) const noexcept {
  assert_rounding_upward();
  const Linear x(from_.position.x(), to_.position.x(), t), y(from_.position.y(), to_.position.y(), t);
  const Linear w(from_.orientation.w(), to_.orientation.w(), t);
  const Linear z(from_.orientation.z(), to_.orientation.z(), t);
  const Interval norm = square(w.at) + square(z.at);
  if (!(norm.lower() > 0.0)) return std::nullopt;
  const Interval cosine = quotient(square(w.at) - square(z.at), norm);
  const Interval sine = quotient(Interval(2.0) * w.at * z.at, norm);
  const Interval turning = quotient(Interval(2.0) * (w.at * z.rate - z.at * w.rate), norm);
  Enclosure result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Leg& leg = manipulator_.leg(legs_[i]);
    const Eigen::Vector3d base = leg.base_point();
    const Interval ax(leg.anchor.x()), ay(leg.anchor.y());
    const Interval px = cosine * ax - sine * ay, py = sine * ax + cosine * ay;
    const Interval ux = x.at + px - Interval(base.x()), uy = y.at + py - Interval(base.y());
    const Interval uz = Interval(leg.anchor.z()) - Interval(base.z());
    const Interval squared = square(ux) + square(uy) + square(uz);
    if (!(squared.lower() > 0.0)) return std::nullopt;
    result.lengths[i] = square_root(squared);
    const Interval rate = ux * (x.rate - turning * py) + uy * (y.rate + turning * px);
    result.rates[i] = quotient(rate, result.lengths[i]);
  }
  return result;
}

bool PathInRegions::crosses_apart() const noexcept {
  for (std::size_t i = 0; i < crossings_.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (may_meet(crossings_[i], crossings_[k])) return false;
  return true;
}

bool PathInRegions::add(const StrutSegment& segment) {
  return prove(segment, stop(segment, 0.0), stop(segment, 1.0), 0);
}

// In a piece as a range, so that the lengths of the pose itself are there.
PathInRegions::Stop PathInRegions::stop(const StrutSegment& segment, double t) const {
  Stop result{t, std::nullopt, std::nullopt};
  const auto over = segment.over(Interval(t));
  if (!over) return result;
  const LengthCover cover = space_.cover(over->lengths);
  if (!cover.is_complete || cover.pieces.size() != 1) return result;
  result.piece = cover.pieces.front();
  result.region = locate_(segment.at(t));
  return result;
}

bool PathInRegions::prove(const StrutSegment& segment, const Stop& from, const Stop& to, int depth) {
  if (!from.region || !to.region) return false;
  const auto over = segment.over(Interval(from.t, to.t));
  if (over && is_proved(*over, from, to)) {
    regions_.insert({*from.region, *to.region});
    return true;
  }
  if (depth == most_halvings) return false;
  const auto middle = between(segment, from, to);
  return middle && prove(segment, from, *middle, depth + 1) && prove(segment, *middle, to, depth + 1);
}

std::optional<PathInRegions::Stop> PathInRegions::between(const StrutSegment& segment, const Stop& from,
                                                          const Stop& to) const {
  for (const double share : shares) {
    const Stop found = stop(segment, from.t + share * (to.t - from.t));
    if (found.region && from.t < found.t && found.t < to.t) return found;
  }
  return std::nullopt;
}

bool PathInRegions::is_proved(const StrutSegment::Enclosure& over, const Stop& from, const Stop& to) {
  const LengthCover cover = space_.cover(over.lengths);
  const bool has_ends = cover.pieces.size() == 1 || (cover.pieces.size() == 2 && from.piece != to.piece);
  if (cover.is_complete) return has_ends && from.region == to.region;
  if (!cover.cell || from.piece == to.piece) return false;
  const SpaceCell& cell = space_.cells()[*cover.cell];
  if (cell.pieces[1] || !holds_all(cell.box, over.lengths)) return false;
  Interval rate;
  for (std::size_t i = 0; i < 3; ++i) rate += Interval(cell.slope[i]) * over.rates[i];
  if (rate.lower() <= 0.0 && rate.upper() >= 0.0) return false;
  crossings_.push_back(over.lengths);
  return true;
}

}  // namespace parallel_aspects
