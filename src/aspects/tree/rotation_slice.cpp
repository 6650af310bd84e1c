// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/rotation_slice.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {
namespace {

std::ptrdiff_t count_of(const std::vector<HeldCoordinate>& held, const std::string& name) {
  return std::count_if(held.begin(), held.end(), [&name](const auto& each) { return each.name == name; });
}

/// Empty where the slice can be made, as far as the axis and the angles go.
std::string find_problem(TaskSpace space, const std::vector<HeldCoordinate>& held, const std::string& axis) {
  const std::array<std::string, 6> axes{"x", "y", "z", "own-x", "own-y", "own-z"};
  if (std::find(axes.begin(), axes.end(), axis) == axes.end())
    return "The slice turns about '" + axis +
           "'; give x, y or z of the base, or own-x, own-y or own-z of the platform.";
  if (space != TaskSpace::SE3 && space != TaskSpace::SO3)
    return "A slice of " + std::string(name(space)) + " turns about no other axis; leave 'turn' out.";
  for (const char* angle : {"roll", "pitch", "yaw"})
    if (count_of(held, angle) != 1)
      return std::string("The slice turns from an orientation that it does not state; hold '") + angle +
             "' once.";
  return "";
}

}  // namespace

// With yaw left free it is a slice about the z axis, whose orientation and axis are then set.
MapSlice make_rotation_slice(TaskSpace space, const std::vector<HeldCoordinate>& held,
                             const std::string& axis, Problems& problems) {
  const std::string problem = find_problem(space, held, axis);
  if (!problem.empty()) {
    problems.push_back(problem);
    return {};
  }
  std::vector<HeldCoordinate> others = held;
  const auto yaw =
      std::find_if(others.begin(), others.end(), [](const auto& each) { return each.name == "yaw"; });
  const double angle = yaw->value;
  others.erase(yaw);
  if (!std::isfinite(angle)) problems.emplace_back("The slice holds 'yaw' at no finite number; give one.");
  const std::size_t known = problems.size();
  MapSlice slice = make_slice(space, others, problems);
  if (problems.size() > known || !std::isfinite(angle)) return slice;
  slice.held.orientation = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * slice.held.orientation;
  slice.axis = Eigen::Vector3d::Unit(axis.back() - 'x');
  if (axis.size() > 1) slice.axis = slice.held.orientation * slice.axis;
  slice.angle_name = "phi";
  slice.held_coordinates = held;
  return slice;
}

}  // namespace parallel_aspects
