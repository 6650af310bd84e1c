// SPDX-License-Identifier: BSD-3-Clause
#include "draw/surface/cell_set.h"

#include "aspects/map/map_contents.h"
#include "aspects/tree/pose_tree.h"
#include "model/angles.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr std::uint32_t finest_level = 13;  // so that corners have keys
constexpr std::size_t most_room = 4000000;  // of cells that a small aspect is searched for in
constexpr std::uint8_t is_cell = 1;

// In the cubes of SO3 the last root has the quaternion's w as its largest component; in the others w is the
// last coordinate, and the picture is cut where it is zero: there the rotation is by half a turn.
constexpr RootIndex root_of_w = 3;
constexpr std::size_t axis_of_w = 2;

std::size_t component_of(RootIndex largest, std::size_t axis) { return axis < largest ? axis : axis + 1; }

Eigen::Vector3d rotation_vector(Eigen::Vector4d quaternion) {
  const Eigen::Vector3d axis = quaternion.head<3>();
  const double sine = axis.norm();
  return sine > 0.0 ? Eigen::Vector3d(2.0 * std::atan2(sine, quaternion[3]) / sine * axis)
                    : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

}  // namespace

CellSet::CellSet(const AspectMap& map, int aspect, std::uint32_t level, std::size_t fewest)
    : map_(map.contents()),
      aspect_(aspect),
      mode_(*mode_index(map_, map_.aspects[static_cast<std::size_t>(aspect - 1)].mode)),
      is_ball_(map_.tree.root_count() > 1),
      turns_(!is_ball_ && map_.tree.space().is_periodic(2)),
      level_(std::min(level, finest_level)) {
  fill();
  while (count_ < fewest && level_ < std::min(map_.deepest_level, finest_level) && 8 * room() < most_room) {
    ++level_;
    fill();
  }
}

// How many cells the grids have room for; eight times as many at the next level.
std::size_t CellSet::room() const {
  std::size_t sum = 0;
  for (const Grid& grid : grids_) sum += grid.states.size();
  return sum;
}

void CellSet::fill() {
  const Box& region = map_.tree.region();
  const double cells = std::ldexp(1.0, static_cast<int>(level_));
  grids_.assign(map_.tree.root_count(), {});
  for (RootIndex root = 0; root < grids_.size(); ++root) {
    const Box& bounds = map_.aspect_bounds[static_cast<std::size_t>(aspect_ - 1)][root];
    if (bounds.dimension == 0) continue;
    Grid& grid = grids_[root];
    for (std::size_t i = 0; i < 3; ++i) {
      const double edge = region.width(i) / cells;
      grid.first[i] = static_cast<int>(std::floor((bounds.lower[i] - region.lower[i]) / edge));
      const int end = static_cast<int>(std::ceil((bounds.upper[i] - region.lower[i]) / edge));
      grid.size[i] = std::max(1, std::min(end, static_cast<int>(cells)) - grid.first[i]);
    }
    grid.states.assign(static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]) *
                           static_cast<std::size_t>(grid.size[2]),
                       0);
  }
  count_ = 0;
  for (RootIndex root = 0; root < grids_.size(); ++root)
    if (!grids_[root].states.empty()) fill(root);
}

void CellSet::fill(NodeIndex node) {
  const PoseTree& tree = map_.tree;
  const LeafState state = tree.state(node, mode_);
  const NodePlace place = tree.place(node);
  if (state.is_divided()) {
    if (place.level == level_) {
      if (share(node) >= 0.5) set(place);
      return;
    }
    for (NodeIndex child = 0; child < tree.children_per_node(); ++child) fill(tree.first_child(node) + child);
  } else if (map_.leaf_aspect(node, mode_) == aspect_) {
    set(place);
  }
}

// The share of a node that the aspect's inside leaves fill.
double CellSet::share(NodeIndex node) const {
  const PoseTree& tree = map_.tree;
  if (!tree.state(node, mode_).is_divided()) return map_.leaf_aspect(node, mode_) == aspect_ ? 1.0 : 0.0;
  double sum = 0.0;
  for (NodeIndex child = 0; child < tree.children_per_node(); ++child)
    sum += share(tree.first_child(node) + child);
  return sum / static_cast<double>(tree.children_per_node());
}

void CellSet::set(const NodePlace& place) {
  Grid& grid = grids_[place.root];
  const int width = 1 << (level_ - std::min(level_, place.level));
  std::array<int, 3> first{}, at{};
  for (std::size_t i = 0; i < 3; ++i) first[i] = static_cast<int>(place.cell[i]) * width;
  for (at[2] = first[2]; at[2] < first[2] + width; ++at[2])
    for (at[1] = first[1]; at[1] < first[1] + width; ++at[1])
      for (at[0] = first[0]; at[0] < first[0] + width; ++at[0]) {
        const std::size_t index = state_index(grid, at);
        if (index >= grid.states.size()) continue;
        grid.states[index] = is_cell;
        ++count_;
      }
}

// An index beyond the end where there is none.
std::size_t CellSet::state_index(const Grid& grid, const std::array<int, 3>& at) const noexcept {
  std::size_t index = 0;
  for (std::size_t i = 3; i-- > 0;) {
    const int offset = at[i] - grid.first[i];
    if (offset < 0 || offset >= grid.size[i]) return grid.states.size();
    index = index * static_cast<std::size_t>(grid.size[i]) + static_cast<std::size_t>(offset);
  }
  return index;
}

std::uint8_t CellSet::state(const CellIndex& cell) const noexcept {
  const Grid& grid = grids_[cell.root];
  const std::size_t index = state_index(grid, cell.at);
  return index < grid.states.size() ? grid.states[index] : std::uint8_t{0};
}

bool CellSet::holds(const CellIndex& cell) const noexcept { return (state(cell) & is_cell) != 0; }

void CellSet::visit(const std::function<void(const CellIndex&)>& visit_cell) const {
  for (RootIndex root = 0; root < grids_.size(); ++root) {
    const Grid& grid = grids_[root];
    std::size_t index = 0;
    for (int k = 0; k < grid.size[2]; ++k)
      for (int j = 0; j < grid.size[1]; ++j)
        for (int i = 0; i < grid.size[0]; ++i, ++index)
          if ((grid.states[index] & is_cell) != 0)
            visit_cell({root, {grid.first[0] + i, grid.first[1] + j, grid.first[2] + k}});
  }
}

double CellSet::measure() const {
  double sum = 0.0;
  visit([&](const CellIndex& cell) { sum += map_.tree.space().measure(box(cell)); });
  return sum;
}

Box CellSet::box(const CellIndex& cell) const noexcept {
  const Box& region = map_.tree.region();
  Box result = region;
  for (std::size_t i = 0; i < 3; ++i) {
    const double edge = std::ldexp(region.width(i), -static_cast<int>(level_));
    result.lower[i] = region.lower[i] + cell.at[i] * edge;
    result.upper[i] = region.lower[i] + (cell.at[i] + 1) * edge;
  }
  return result;
}

std::optional<CellIndex> CellSet::beyond(const CellIndex& cell, std::size_t axis, bool upper) const {
  CellIndex next = cell;
  next.at[axis] += upper ? 1 : -1;
  const int cells = 1 << level_;
  if (next.at[axis] >= 0 && next.at[axis] < cells) {
    if (is_ball_ && side(next) != side(cell)) return std::nullopt;
    return next;
  }
  if (!is_ball_) return std::nullopt;
  MapPosition middle{cell.root, box(cell).middle()};
  middle.point[axis] = upper ? 1.0 : -1.0;
  const auto there = map_.tree.space().beyond(middle, axis, 1.0 / cells);
  if (!there) return std::nullopt;
  next.root = there->root;
  for (std::size_t i = 0; i < 3; ++i)
    next.at[i] = static_cast<int>(std::floor((there->point[i] + 1.0) * 0.5 * cells));
  return next;
}

// The sign that the quaternion of a cell is taken with, so that its w is not negative.
int CellSet::side(const CellIndex& cell) const noexcept {
  return cell.root == root_of_w || cell.at[axis_of_w] >= (1 << level_) / 2 ? 1 : -1;
}

std::uint64_t CellSet::corner_key(const CellIndex& cell, unsigned corner) const noexcept {
  std::array<int, 4> numbers{};
  const int cells = 1 << level_;
  for (std::size_t i = 0; i < 3; ++i) {
    const int at = cell.at[i] + static_cast<int>(corner >> i & 1U);
    if (is_ball_)
      numbers[component_of(cell.root, i)] = side(cell) * (2 * at - cells);
    else
      numbers[i] = at - grids_[0].first[i];
  }
  if (is_ball_) numbers[cell.root] = side(cell) * cells;
  std::uint64_t key = 0;
  for (const int number : numbers)
    key = key << 16U | (static_cast<std::uint64_t>(number + (1 << 15)) & 0xffffU);
  return key;
}

Eigen::Vector3d CellSet::corner_point(const CellIndex& cell, unsigned corner) const noexcept {
  Eigen::Vector3d in_cells;
  for (std::size_t i = 0; i < 3; ++i)
    in_cells[static_cast<Eigen::Index>(i)] = cell.at[i] + static_cast<int>(corner >> i & 1U);
  return point(cell.root, in_cells, is_ball_ ? side(cell) : 1);
}

Eigen::Vector3d CellSet::center(const CellIndex& cell) const noexcept {
  return point(cell.root, {cell.at[0] + 0.5, cell.at[1] + 0.5, cell.at[2] + 0.5}, is_ball_ ? side(cell) : 1);
}

Eigen::Vector3d CellSet::point(RootIndex root, const Eigen::Vector3d& in_cells, int side) const noexcept {
  const Box& region = map_.tree.region();
  Eigen::Vector3d result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    result[row] = region.lower[i] + std::ldexp(region.width(i), -static_cast<int>(level_)) * in_cells[row];
  }
  if (turns_) result.z() *= pi;
  if (!is_ball_) return result;
  Eigen::Vector4d quaternion;
  for (std::size_t i = 0; i < 3; ++i)
    quaternion[static_cast<Eigen::Index>(component_of(root, i))] =
        side * result[static_cast<Eigen::Index>(i)];
  quaternion[root] = side;
  return rotation_vector(quaternion);
}

Eigen::Vector3d CellSet::edges() const noexcept {
  const Box& region = map_.tree.region();
  Eigen::Vector3d result(region.width(0), region.width(1), region.width(2));
  if (turns_) result.z() *= pi;
  if (is_ball_) result *= 2.0;  // a coordinate changes the rotation by at most 2 rad a unit
  return result * std::ldexp(1.0, -static_cast<int>(level_));
}

}  // namespace parallel_aspects
