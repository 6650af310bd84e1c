// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/aspect_map.h"

#include "aspects/map/map_contents.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {

AspectMap::AspectMap(std::unique_ptr<const Contents> contents) : contents_(std::move(contents)) {}
AspectMap::~AspectMap() = default;

const std::shared_ptr<const Manipulator>& AspectMap::manipulator() const noexcept {
  return contents_->manipulator;
}
const std::optional<MapSlice>& AspectMap::slice() const noexcept { return contents_->slice; }
std::vector<std::string> AspectMap::coordinates() const {
  if (contents_->slice) return coordinate_names(*contents_->slice);
  const TaskSpace space = manipulator()->task_space();
  return space == TaskSpace::SO3 ? std::vector<std::string>() : coordinate_names(space);
}
std::string AspectMap::unit() const {
  if (contents_->slice) return measure_unit(*contents_->slice);
  return std::string(measure_unit(manipulator()->task_space()));
}
Box AspectMap::region() const noexcept { return contents_->tree.space().shown(contents_->tree.region()); }
double AspectMap::resolution() const noexcept { return contents_->resolution; }
const std::vector<WorkingMode>& AspectMap::working_modes() const noexcept {
  return contents_->existing_modes;
}
const std::vector<Aspect>& AspectMap::aspects() const noexcept { return contents_->aspects; }
std::size_t AspectMap::proved_count() const noexcept { return contents_->proved_count; }
std::optional<std::size_t> AspectMap::count_at_most() const noexcept {
  return contents_->indeterminate_leaves == 0 ? std::optional<std::size_t>(contents_->bound) : std::nullopt;
}
std::size_t AspectMap::indeterminate_leaves() const noexcept { return contents_->indeterminate_leaves; }
const std::vector<std::pair<int, int>>& AspectMap::unresolved() const noexcept {
  return contents_->unresolved;
}
double AspectMap::measure_undecided() const noexcept { return contents_->measure_undecided; }
double AspectMap::seconds() const noexcept { return contents_->seconds; }
const std::optional<SymmetryUse>& AspectMap::symmetry_use() const noexcept { return contents_->symmetry_use; }

Location AspectMap::locate(const Pose& pose, const WorkingMode& mode) const noexcept {
  const auto m = mode_index(*contents_, mode);
  const MapPosition position = contents_->tree.space().position(pose);
  if (!m) return {LocationStatus::not_mapped, 0};
  return parallel_aspects::locate(*contents_, *m, position);
}

void AspectMap::visit_inside_leaves(int aspect, const std::function<void(const Box&)>& visit) const {
  const auto mode = mode_index(*contents_, contents_->aspects[static_cast<std::size_t>(aspect - 1)].mode);
  for (NodeIndex node = 0; node < contents_->tree.node_count(); ++node)
    if (contents_->leaf_aspect(node, *mode) == aspect)
      visit(contents_->tree.space().shown(contents_->tree.box(node)));
}

void AspectMap::visit_inside_poses(int aspect,
                                   const std::function<void(const Pose&, double measure)>& visit) const {
  const auto mode = mode_index(*contents_, contents_->aspects[static_cast<std::size_t>(aspect - 1)].mode);
  const PoseTree& tree = contents_->tree;
  for (NodeIndex node = 0; node < tree.node_count(); ++node) {
    if (contents_->leaf_aspect(node, *mode) != aspect) continue;
    const Box box = tree.box(node);
    visit(tree.space().pose({tree.place(node).root, box.middle()}), tree.space().measure(box));
  }
}

void AspectMap::visit_undecided_leaves(const WorkingMode& mode,
                                       const std::function<void(const Box&)>& visit) const {
  const auto m = mode_index(*contents_, mode);
  if (!m) return;
  for (NodeIndex node = 0; node < contents_->tree.node_count(); ++node)
    if (contents_->tree.state(node, *m).is_undecided())
      visit(contents_->tree.space().shown(contents_->tree.box(node)));
}

}  // namespace parallel_aspects
