// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_SOLID_GRID_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_SOLID_GRID_H

#include "parallel_aspects/aspects/aspect_map.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// One of the three coordinates of a body.
struct SolidAxis {
  std::string name, unit;
  double lower = 0.0, upper = 1.0;
};

/// The coordinates of the bodies of a map, from the smallest to the largest of all aspects.
std::array<SolidAxis, 3> solid_axes(const AspectMap& map);

/// Which aspect holds each point of a grid over these coordinates.
class SolidGrid {
 public:
  /// Of one working mode. `checkpoint` is called now and then; it may throw.
  SolidGrid(const AspectMap& map, const std::array<SolidAxis, 3>& axes, const WorkingMode& mode,
            const std::function<void()>& checkpoint);

  /// Points along each coordinate.
  static constexpr int count = 72;

  /// The id at the grid point nearest to a place in [0, count]^3, or near by; 0 for none.
  int aspect(const Eigen::Vector3d& at) const;

  /// How much of a body is around a place: 0 to 1, with 0.5 on its surface.
  double density(const Eigen::Vector3d& at) const;

 private:
  static constexpr std::size_t index(int i, int j, int k) {
    return static_cast<std::size_t>((k * count + j) * count + i);
  }
  void fill_from_leaves(const AspectMap& map, const std::array<SolidAxis, 3>& axes, const WorkingMode& mode);
  void fill_orientations(const AspectMap& map, const WorkingMode& mode,
                         const std::function<void()>& checkpoint);
  void smooth(int times);

  std::vector<int> ids_;
  std::vector<float> densities_;
};

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_SOLID_GRID_H
