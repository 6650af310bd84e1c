// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/solid_grid.h"

#include "model/angles.h"
#include "tools/drawing/plot_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parallel_aspects::tools {
namespace {

constexpr double most_means = 5.0;
constexpr double rim = 2.5;  // points of the grid around all bodies

bool is_of_orientations(const AspectMap& map) { return map.coordinates().empty(); }

// The range of grid points whose middles lie between two places.
std::pair<int, int> points_between(double lower, double upper) {
  return {std::max(0, static_cast<int>(std::ceil(lower - 0.5))),
          std::min(SolidGrid::count - 1, static_cast<int>(std::floor(upper - 0.5)))};
}

}  // namespace

std::array<SolidAxis, 3> solid_axes(const AspectMap& map) {
  if (is_of_orientations(map))
    return {SolidAxis{"rotation about x", "rad", -pi, pi},
            {"about y", "rad", -pi, pi},
            {"about z", "rad", -pi, pi}};
  std::array<SolidAxis, 3> axes;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name = map.coordinates()[i];
    const bool is_length = name == "x" || name == "y" || name == "z";
    axes[i] = {name, is_length ? "m" : "rad", std::numeric_limits<double>::infinity(),
               -std::numeric_limits<double>::infinity()};
    for (const Aspect& aspect : map.aspects()) {
      axes[i].lower = std::min(axes[i].lower, aspect.bounds.lower[i]);
      axes[i].upper = std::max(axes[i].upper, aspect.bounds.upper[i]);
    }
    const double around = rim * (axes[i].upper - axes[i].lower) / SolidGrid::count;
    axes[i].lower -= around;
    axes[i].upper += around;
  }
  return axes;
}

SolidGrid::SolidGrid(const AspectMap& map, const std::array<SolidAxis, 3>& axes, const WorkingMode& mode,
                     const std::function<void()>& checkpoint)
    : ids_(static_cast<std::size_t>(count) * count * count, 0) {
  if (is_of_orientations(map))
    fill_orientations(map, mode, checkpoint);
  else
    fill_from_leaves(map, axes, mode);
  double points = 1.0;  // of the grid in a leaf
  for (const SolidAxis& axis : axes)
    points = std::max(points, count * map.resolution() / (axis.upper - axis.lower));
  smooth(static_cast<int>(std::min(points, most_means)));
}

void SolidGrid::fill_from_leaves(const AspectMap& map, const std::array<SolidAxis, 3>& axes,
                                 const WorkingMode& mode) {
  const auto range = [&axes](const Box& box, std::size_t i) {
    const double scale = count / (axes[i].upper - axes[i].lower);
    return points_between(scale * (box.lower[i] - axes[i].lower), scale * (box.upper[i] - axes[i].lower));
  };
  for (const Aspect& aspect : map.aspects()) {
    if (aspect.mode != mode) continue;
    map.visit_inside_leaves(aspect.id, [&](const Box& box) {
      const auto x = range(box, 0), y = range(box, 1), z = range(box, 2);
      for (int k = z.first; k <= z.second; ++k)
        for (int j = y.first; j <= y.second; ++j)
          for (int i = x.first; i <= x.second; ++i) ids_[index(i, j, k)] = aspect.id;
    });
  }
}

void SolidGrid::fill_orientations(const AspectMap& map, const WorkingMode& mode,
                                  const std::function<void()>& checkpoint) {
  const auto at = [](int i) { return pi * (2.0 * (i + 0.5) / count - 1.0); };
  Pose pose;
  if (map.slice()) pose = map.slice()->held;
  for (int k = 0; k < count; ++k) {
    checkpoint();
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i) {
        const Eigen::Vector3d turn(at(i), at(j), at(k));
        const double angle = turn.norm();
        if (!(angle < pi) || !(angle > 0.0)) continue;
        pose.orientation = Eigen::AngleAxisd(angle, turn / angle);
        if (const Location found = map.locate(pose, mode)) ids_[index(i, j, k)] = found.aspect;
      }
  }
}

// Means over three points along each coordinate: what is rounded is no more than a leaf.
void SolidGrid::smooth(int times) {
  densities_.resize(ids_.size());
  std::transform(ids_.begin(), ids_.end(), densities_.begin(), [](int id) { return id != 0 ? 1.0F : 0.0F; });
  for (int k = 0; k < 3 * times; ++k) {
    const std::size_t step = k % 3 == 0 ? index(1, 0, 0) : k % 3 == 1 ? index(0, 1, 0) : index(0, 0, 1);
    std::vector<float> means(densities_.size(), 0.0F);
    for (std::size_t i = step; i + step < means.size(); ++i)
      means[i] = 0.25F * densities_[i - step] + 0.5F * densities_[i] + 0.25F * densities_[i + step];
    densities_ = std::move(means);
  }
}

int SolidGrid::aspect(const Eigen::Vector3d& at) const {
  const Eigen::Vector3i middle = at.array().floor().cast<int>();
  double nearest = std::numeric_limits<double>::infinity();
  int found = 0;
  for (int k = std::max(0, middle.z() - 1); k <= std::min(count - 1, middle.z() + 1); ++k)
    for (int j = std::max(0, middle.y() - 1); j <= std::min(count - 1, middle.y() + 1); ++j)
      for (int i = std::max(0, middle.x() - 1); i <= std::min(count - 1, middle.x() + 1); ++i) {
        const double distance = (Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5) - at).squaredNorm();
        if (ids_[index(i, j, k)] == 0 || !(distance < nearest)) continue;
        nearest = distance;
        found = ids_[index(i, j, k)];
      }
  return found;
}

double SolidGrid::density(const Eigen::Vector3d& at) const {
  const Eigen::Vector3d from = (at.array() - 0.5).floor();
  const Eigen::Vector3i corner = from.cast<int>();
  if (corner.minCoeff() < 0 || corner.maxCoeff() + 1 >= count) return 0.0;
  const Eigen::Vector3d share = at - from - Eigen::Vector3d::Constant(0.5);
  double sum = 0.0;
  for (int k = 0; k < 8; ++k) {
    const bool x = (k & 1) != 0, y = (k & 2) != 0, z = (k & 4) != 0;
    sum += (x ? share.x() : 1.0 - share.x()) * (y ? share.y() : 1.0 - share.y()) *
           (z ? share.z() : 1.0 - share.z()) *
           densities_[index(corner.x() + (x ? 1 : 0), corner.y() + (y ? 1 : 0), corner.z() + (z ? 1 : 0))];
  }
  return sum;
}

}  // namespace parallel_aspects::tools
