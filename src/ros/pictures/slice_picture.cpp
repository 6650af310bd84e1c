// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/map_picture.h"
#include "ros/pictures/plane_markers.h"

#include <algorithm>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;
using Points = MarkerBatch::Points;

constexpr int slice_tile_cells = 48;                         // of the grid across a tile
constexpr int slice_robot_cells = 110;                       // across the slice at the robot
constexpr double gallery_step = 0.02, present_step = 0.005;  // of the range of levels, between two drawings
constexpr std::size_t max_lines = 3;                         // of legend under a tile

std::pair<double, double> level_bounds(const AspectMap& map) {
  if (map.manipulator()->task_space() == TaskSpace::R2) return {0.0, 1.0};  // its level is always 0
  if (map.manipulator()->task_space() == TaskSpace::SO3) return {-EIGEN_PI, EIGEN_PI};
  double lower = 0.0, upper = 0.0;
  for (const Aspect& aspect : map.aspects()) {
    lower = std::min(lower, aspect.bounds.lower[2]);
    upper = std::max(upper, aspect.bounds.upper[2]);
  }
  return {lower, upper};
}

double largest_aspect_level(const AspectMap& map) {
  const auto& aspects = map.aspects();
  const auto largest = std::max_element(aspects.begin(), aspects.end(), [](const auto& a, const auto& b) {
    return a.deepest_clearance < b.deepest_clearance;
  });
  if (largest == aspects.end()) return 0.0;
  return PoseSlice::through(map.manipulator()->motions(), largest->deepest).level();
}

Points square(const Vector2d& center, double side) {
  const Vector2d across(0.5 * side, 0.5 * side), down(0.5 * side, -0.5 * side);
  return {center - across, center + down, center + across, center - across, center + across, center - down};
}

// Whether the platform of a planar robot is as large as where its middle goes, so that it hides a slice below
// it.
bool is_hidden(const AspectMap& map) {
  if (map.manipulator()->task_space() != TaskSpace::SE2) return false;
  double radius = 0.0;
  for (const Leg& leg : map.manipulator()->legs()) radius = std::max(radius, leg.anchor.norm());
  Eigen::AlignedBox2d workspace;
  for (const Aspect& aspect : map.aspects())
    for (const auto& end : {aspect.bounds.lower, aspect.bounds.upper})
      workspace.extend(Vector2d(end[0], end[1]));
  return !workspace.isEmpty() && workspace.sizes().maxCoeff() < 2.0 * radius;
}

/// Slices of every working mode, and that of the present mode at the robot. In R2 a slice is all there is:
/// the torus of both angles as a square, of which opposite sides are one.
class SlicePicture : public Picture {
 public:
  SlicePicture(std::shared_ptr<const AspectMap> map, MarkerFrames frames, const Scene& scene,
               const DisplayOptions& options)
      : map_(std::move(map)),
        colors_(aspect_colors(map_->aspects())),
        motions_(map_->manipulator()->motions()),
        space_(motions_.space),
        frames_(std::move(frames)),
        scene_(scene),
        options_(options),
        bounds_(slice_bounds(*map_)),
        first_level_(largest_aspect_level(*map_)),
        gallery_plane_{frames_.aspects, Eigen::Isometry3d::Identity()} {
    const auto [lower, upper] = level_bounds(*map_);
    level_range_ = upper - lower;
  }

  visualization_msgs::MarkerArray gallery(const Drawn& now) const override {
    MarkerBatch batch;
    if (!options_.gallery) return batch.take();
    const PosePlane plane = plane_of(*map_, slice(now));
    std::set<BoundaryKind> kinds;
    for (std::size_t tile = 0; tile < map_->working_modes().size(); ++tile) {
      const PlaneScene scene = pose_scene(*map_, plane, map_->working_modes()[tile], slice_tile_cells);
      draw_tile(tile, scene, batch);
      draw_titles(tile, scene, now, batch);
      kinds.merge(kinds_of(scene.boundaries));
    }
    const double text = scene_.tiles.text_height();
    const PlanePainter whole = painter(0, "gallery", text, batch);
    whole.words("/title", {0.5 * scene_.tiles.width(), 1.0 * text}, 1.2 * text,
                space_ == TaskSpace::R2 ? "aspects over theta1, to the right, and theta2, each from -pi to pi"
                                        : "aspects at " + plane.slice.text());
    Vector2d at(0.5 * scene_.tiles.width(), -scene_.tiles.height() - 0.5 * text);
    for (const LegendEntry& entry : boundary_legend(kinds)) {
      whole.words("/legend", at, 0.9 * text, entry.text, entry.color);
      at.y() -= 1.2 * text;
    }
    return batch.take();
  }

  visualization_msgs::MarkerArray present(const Drawn& now) const override {
    MarkerBatch batch;
    const auto tile = now ? tile_of(now->mode) : std::nullopt;
    if (!tile) return batch.take();
    const double text = scene_.tiles.text_height();
    if (options_.gallery)
      painter(*tile, "gallery", text, batch)
          .frame("/present", scene_.tiles.center(*tile), Vector2d::Constant(1.03 * scene_.tiles.side()),
                 ink_color, 0.14 * text, Layer::outline);
    if (has_translation(space_)) draw_at_robot(*now, batch);
    return batch.take();
  }

  visualization_msgs::MarkerArray position(const Drawn& now) const override {
    MarkerBatch batch;
    const auto tile = now ? tile_of(now->mode) : std::nullopt;
    if (!tile || !options_.gallery) return batch.take();
    painter(*tile, "position", 1.3 * scene_.tiles.text_height(), batch)
        .dot(PoseSlice::point(space_, now->solved.pose));
    return batch.take();
  }

  bool gallery_differs(const Drawn& before, const Drawn& now) const override {
    if (!options_.gallery || !now) return false;
    return level_change(before, now) > gallery_step * level_range_ ||
           (before ? before->aspect : 0) != now->aspect;  // which the legend always has
  }

  bool present_differs(const Drawn& before, const Drawn& now) const override {
    if (!before || !now) return before.has_value() != now.has_value();
    return before->mode != now->mode || before->aspect != now->aspect ||
           (has_translation(space_) && level_change(before, now) > present_step * level_range_);
  }

  std::vector<geometry_msgs::TransformStamped> frames() const override {
    return {still_frame(frames_.base, frames_.aspects, drawing_frame(*map_->manipulator()) * scene_.gallery)};
  }

  std::optional<PoseSlice> section(const Drawn& now) const override {
    return space_ == TaskSpace::R2 ? std::nullopt : std::optional(slice(now));  // all poses are drawn
  }

 private:
  PoseSlice slice(const Drawn& now) const {
    return now ? PoseSlice::through(motions_, now->solved.pose) : PoseSlice(motions_, first_level_);
  }

  PlanePainter painter(std::size_t tile, const std::string& group, double text, MarkerBatch& batch) const {
    const double scale = scene_.tiles.side() / bounds_.sizes().maxCoeff();
    return {batch, gallery_plane_, group, text, 0.09 * text, [this, tile, scale](const Vector2d& point) {
              return Vector2d(scene_.tiles.center(tile) + scale * (point - bounds_.center()));
            }};
  }

  std::optional<std::size_t> tile_of(const WorkingMode& mode) const {
    const auto& modes = map_->working_modes();
    const auto found = std::find(modes.begin(), modes.end(), mode);
    if (found == modes.end()) return std::nullopt;
    return static_cast<std::size_t>(found - modes.begin());
  }

  void draw_tile(std::size_t tile, const PlaneScene& scene, MarkerBatch& batch) const {
    const double text = scene_.tiles.text_height();
    const PlanePainter painted = painter(tile, "gallery", text, batch);
    for (const PlaneArea& area : scene.areas) painted.area(area);
    painted.boundaries(scene);
    painted.frame("/frame", scene_.tiles.center(tile), Vector2d::Constant(scene_.tiles.side()), 0xB0B0B0,
                  0.04 * text);
  }

  // Of those that are drawn the first, and always the present one.
  std::vector<int> legend(const PlaneScene& scene, const WorkingMode& mode, const Drawn& now) const {
    std::vector<int> ids;
    for (const PlaneArea& area : scene.areas) ids.push_back(area.aspect);
    const bool here = now && now->mode == mode && now->aspect != 0;
    if (here && std::count(ids.begin(), ids.end(), now->aspect) == 0)
      ids.push_back(now->aspect);  // thinner than the grid shows
    if (ids.size() <= max_lines) return ids;
    const bool hidden =
        here && std::find(ids.begin(), ids.begin() + max_lines, now->aspect) == ids.begin() + max_lines;
    ids.resize(max_lines);
    if (hidden) ids.back() = now->aspect;
    return ids;
  }

  void draw_titles(std::size_t tile, const PlaneScene& scene, const Drawn& now, MarkerBatch& batch) const {
    const double text = scene_.tiles.text_height(), side = scene_.tiles.side();
    const WorkingMode& mode = map_->working_modes()[tile];
    const Vector2d middle = scene_.tiles.center(tile);
    const PlanePainter painted = painter(tile, "gallery", text, batch);
    painted.words("/modes", middle + Vector2d(0.0, 0.5 * side + 0.8 * text), text, "mode " + to_string(mode));
    Vector2d line = middle - Vector2d(0.0, 0.5 * side + 0.7 * text);
    const std::vector<int> shown = legend(scene, mode, now);
    for (const int id : shown) {
      const auto index = static_cast<std::size_t>(id - 1);
      batch.triangles(gallery_plane_, "gallery/swatches",
                      square(line - Vector2d(0.5 * side + 0.4 * text, 0.0), 0.6 * text), 0.0,
                      color(colors_[index]));
      painted.words("/sizes", line, 0.75 * text, aspect_words(*map_, map_->aspects()[index]));
      line.y() -= 0.9 * text;
    }
    if (scene.areas.size() > shown.size())
      painted.words("/sizes", line, 0.75 * text,
                    "and " + std::to_string(scene.areas.size() - shown.size()) + " more here");
  }

  void draw_at_robot(const DrawnConfiguration& now, MarkerBatch& batch) const {
    const PosePlane drawn = plane_of(*map_, PoseSlice::through(motions_, now.solved.pose));
    const PlaneScene scene = pose_scene(*map_, drawn, now.mode, slice_robot_cells);
    // In front of the base, and behind or below the platform and its joints, which it would hide; above a
    // platform that would hide all of it. One of T3 is also looked through: it comes seldom, so that a
    // platform that moves fast may be below it.
    const bool is_above = is_hidden(*map_);
    const double height = (space_ == TaskSpace::T3 ? drawn.slice.level() : 0.0) +
                          (is_above ? 0.1 : -0.02) * map_->manipulator()->size();
    const MarkerBatch::Plane plane{frames_.base,
                                   map_->manipulator()->task_frame() * Eigen::Translation3d(0.0, 0.0, height),
                                   scene_.planar};  // seen at a flat angle, it would be dark
    const double unit = 0.06 * bounds_.sizes().maxCoeff();
    const PlanePainter painted(batch, plane, "robot", unit, 0.06 * unit);
    for (const PlaneArea& area : scene.areas)
      painted.area(area, now.aspect, space_ == TaskSpace::T3 || is_above ? 0.6F : 1.0F);
    painted.outline(scene, now.aspect);
    painted.boundaries(scene);
  }

  double level_change(const Drawn& before, const Drawn& now) const {
    return level_difference(space_, slice(before).level(), slice(now).level());
  }

  std::shared_ptr<const AspectMap> map_;
  std::vector<Rgb> colors_;  // by id - 1
  Motions motions_;
  TaskSpace space_;
  MarkerFrames frames_;
  Scene scene_;
  DisplayOptions options_;
  Eigen::AlignedBox2d bounds_;
  double level_range_;  // that the map takes
  double first_level_;  // drawn while the robot is not tracked
  MarkerBatch::Plane gallery_plane_;
};

}  // namespace

std::shared_ptr<const Picture> make_slice_picture(const std::shared_ptr<const AspectMap>& map,
                                                  const MarkerFrames& frames, const Scene& scene,
                                                  const DisplayOptions& options) {
  return std::make_shared<const SlicePicture>(map, frames, scene, options);
}

}  // namespace parallel_aspects
