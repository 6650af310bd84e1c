// SPDX-License-Identifier: BSD-3-Clause
#include "ros/labels/label_room.h"

#include <algorithm>
#include <limits>

namespace parallel_aspects {
namespace {

// From line to line, over the height: labels in space are seen from above, too, which brings them nearer.
constexpr double flat_pitch = 1.1, body_pitch = 1.6;
constexpr double half_letter = 0.25;  // width over height

}  // namespace

void keep_apart(std::vector<PlacedLabel>& labels, double height, bool planar) {
  const Eigen::Index up = planar ? 1 : 2;
  const double line = (planar ? flat_pitch : body_pitch) * height;
  const auto overlap = [&](const PlacedLabel& one, const PlacedLabel& other) {
    const double width =
        std::max(1.0, half_letter * static_cast<double>(one.letters + other.letters)) * height;
    const double far = std::numeric_limits<double>::infinity();  // one over the other, as they are seen
    const Eigen::Vector3d room(width, planar ? line : width, planar ? far : line);
    return ((one.at - other.at).cwiseAbs().array() < room.array()).all();
  };
  for (auto label = labels.begin(); label != labels.end(); ++label)
    for (auto other = labels.begin(); other != label;) {
      if (overlap(*label, *other)) {
        label->at[up] = other->at[up] - 1.01 * line;
        other = labels.begin();  // it may lie on one of those before now
      } else {
        ++other;
      }
    }
}

}  // namespace parallel_aspects
