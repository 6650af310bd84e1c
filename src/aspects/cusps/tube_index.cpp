// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/tube_index.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

// In a turn. Steps along a curve are not longer than about a cell; near folds they are much shorter.
constexpr int cells = 64;

int wrapped(int cell) noexcept { return ((cell % cells) + cells) % cells; }

}  // namespace

TubeIndex::TubeIndex(const TraceBounds& bounds)
    : first_(bounds.lower), per_unit_{0.5 * cells, 0.5 * cells, 0.5 * cells * bounds.weights[2]} {}

int TubeIndex::cell_of(double value, std::size_t axis) const noexcept {
  const double from = axis == 2 ? value - first_ : value;
  return static_cast<int>(std::clamp(std::floor(from * per_unit_[axis]), -1e6, 1e6));
}

void TubeIndex::add(const CuspTube& tube) {
  const Box hull = hull_of(tube, tube.cross);
  Cell lower{}, upper{};
  for (std::size_t i = 0; i < 3; ++i) {
    lower[i] = cell_of(hull.lower[i], i);
    upper[i] = cell_of(hull.upper[i], i);
    if (i < 2) upper[i] = std::min(upper[i], lower[i] + cells - 1);
  }
  for (int a = lower[0]; a <= upper[0]; ++a)
    for (int b = lower[1]; b <= upper[1]; ++b)
      for (int c = lower[2]; c <= upper[2]; ++c)
        by_cell_[{wrapped(a), wrapped(b), c}].push_back(tubes_.size());
  tubes_.push_back(tube);
}

bool TubeIndex::holds(const Box& box) const {
  const auto found = by_cell_.find(
      {wrapped(cell_of(box.center(0), 0)), wrapped(cell_of(box.center(1), 1)), cell_of(box.center(2), 2)});
  return found != by_cell_.end() &&
         std::any_of(found->second.begin(), found->second.end(),
                     [&](std::size_t tube) { return contains(tubes_[tube], box); });
}

}  // namespace parallel_aspects
