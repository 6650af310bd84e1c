// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/cusp_family.h"

#include "interval/half_turns.h"

#include <algorithm>

namespace parallel_aspects {
namespace {

// From the middle of a box along a coordinate, times pi.
Interval offset_of(const Box& box, std::size_t axis) noexcept {
  const double middle = box.center(axis);
  const double half = std::max(box.upper[axis] - middle, middle - box.lower[axis]);
  return pi_enclosure() * Interval(-half, half);
}

}  // namespace

Interval held_values(const Box& box) noexcept {
  return pi_enclosure() * Interval(box.lower[2], box.upper[2]);
}

bool CuspFamily::may_hold_cusp(const Box& box) noexcept {
  ++evaluations_;
  slice_.hold(held_values(box));
  const SlicePlace place = slice_.place(box);
  if (slice_.within_limits(posture_, place) == Verdict::fails) return false;
  const auto legs = legs_over(slice_, posture_, place);
  if (!legs) return true;
  if (is_out_of_reach(*legs)) return false;
  const CuspFunctions<1> over(*legs, place.over());
  if (!over.may_have_cusp()) return false;
  if (!are_regular(*legs)) return true;
  const TotalGradients<3> slopes(*legs, over, place.over());
  const auto center = at(box.middle());
  if (!center) return true;
  const std::array<const CuspGradient<3>*, 3> gradients{&slopes.d, &slopes.along_kernel[0],
                                                        &slopes.along_kernel[1]};
  for (std::size_t n = 0; n < 3; ++n) {
    Interval value = center->values[n];
    for (std::size_t k = 0; k < 3; ++k) value += (*gradients[n])[k] * offset_of(box, k);
    if (!may_vanish(value)) return false;
  }
  return true;
}

Verdict CuspFamily::within_limits(const Box& box) noexcept {
  slice_.hold(held_values(box));
  return slice_.within_limits(posture_, slice_.place(box));
}

int CuspFamily::held_sign(const Box& box) noexcept {
  slice_.hold(held_values(box));
  return slice_.held_sign(slice_.place(box));
}

std::optional<FamilyFunctions> CuspFamily::over(const Box& box) noexcept {
  slice_.hold(held_values(box));
  return functions(slice_.place(box));
}

std::optional<FamilyFunctions> CuspFamily::at(const MapPoint& point) noexcept {
  slice_.hold(pi_enclosure() * Interval(point[2]));
  return functions(SlicePlace(std::array<double, 2>{point[0], point[1]}));
}

std::optional<FamilyFunctions> CuspFamily::functions(const SlicePlace& at) noexcept {
  ++evaluations_;
  const auto legs = legs_over(slice_, posture_, at);
  if (!legs || !are_regular(*legs)) return std::nullopt;
  const CuspFunctions<1> over(*legs, at.over());
  const TotalGradients<3> slopes(*legs, over, at.over());
  FamilyFunctions result;
  result.values = {over.d.value(), over.along_kernel[0].value(), over.along_kernel[1].value()};
  result.gradients = {slopes.d, slopes.along_kernel[0], slopes.along_kernel[1]};
  for (std::size_t i = 0; i < 2; ++i)
    result.has_gradient[i] = may_vanish(over.g[i].at(1, 0)) ? !may_vanish(over.g[i].at(0, 1)) : true;
  result.better_equation = over.better_equation();
  return result;
}

}  // namespace parallel_aspects
