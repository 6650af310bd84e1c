// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/gauge_picture.h"

#include "parallel_aspects/singularity/indices.h"
#include "ros/pictures/plane_markers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;

constexpr double max_rows = 12.0, title_rows = 1.6, gauge_rows = 1.25;

MarkerBatch::Points filled_rectangle(const Vector2d& lower, const Vector2d& upper) {
  const Vector2d right(upper.x(), lower.y()), left(lower.x(), upper.y());
  return {lower, right, upper, lower, upper, left};
}

class GaugePicture : public Picture {
 public:
  GaugePicture(std::shared_ptr<const Manipulator> manipulator, MarkerFrames frames, const Scene& scene)
      : manipulator_(std::move(manipulator)),
        frames_(std::move(frames)),
        scene_(scene),
        plane_{frames_.aspects, Eigen::Isometry3d::Identity()} {
    double gauges = 2.0;
    for (const Leg& leg : manipulator_->legs()) gauges += leg.largest_entry() > 0.0 ? 1.0 : 0.0;
    top_ = -std::max(0.0, 0.5 * (max_rows - title_rows - gauge_rows * gauges)) * row_height();
  }

  visualization_msgs::MarkerArray gallery(const Drawn&) const override {
    MarkerBatch batch;
    const double unit = row_height();
    batch.text(plane_, "gauges/title", {3.0 * unit, top_ - 0.2 * unit}, 0.0, 0.5 * unit,
               "indices that are 0 at a singularity", color(ink_color));
    batch.text(plane_, "gauges/legend", {1.8 * unit, top_ - 0.9 * unit}, 0.0, 0.4 * unit, "parallel",
               color(boundary_color(BoundaryKind::parallel)));
    batch.text(plane_, "gauges/legend", {4.2 * unit, top_ - 0.9 * unit}, 0.0, 0.4 * unit, "serial",
               color(boundary_color(BoundaryKind::serial)));
    return batch.take();
  }

  visualization_msgs::MarkerArray present(const Drawn&) const override { return MarkerBatch().take(); }

  visualization_msgs::MarkerArray position(const Drawn& now) const override {
    MarkerBatch batch;
    if (!now) return batch.take();
    std::size_t row = 0;
    for (const Gauge& gauge : gauges(*now)) draw(gauge, row++, batch);
    return batch.take();
  }

  std::vector<geometry_msgs::TransformStamped> frames() const override {
    return {still_frame(frames_.base, frames_.aspects, drawing_frame(*manipulator_) * scene_.gallery)};
  }

 private:
  struct Gauge {
    std::string label;
    double share = 0.0;  // of its largest value, 0 to 1; 0 is singular
    bool parallel = false;
  };

  double row_height() const noexcept { return scene_.tiles.height() / max_rows; }

  std::vector<Gauge> gauges(const DrawnConfiguration& now) const {
    const SingularityIndices indices = singularity_indices(*manipulator_, now.solved.pose, now.solved.q);
    std::vector<Gauge> gauges{{"smallest singular value of A", indices.smallest_singular_value, true},
                              {"inverse condition number of A", indices.inverse_condition_number, true}};
    for (std::size_t j = 0; j < manipulator_->leg_count(); ++j) {
      const double largest = manipulator_->leg(j).largest_entry();
      if (largest <= 0.0) continue;
      const double share = std::abs(indices.inverse_diagonal[static_cast<Eigen::Index>(j)]) / largest;
      gauges.push_back({"|B" + std::to_string(j + 1) + std::to_string(j + 1) + "| / largest", share, false});
    }
    return gauges;
  }

  void draw(const Gauge& gauge, std::size_t row, MarkerBatch& batch) const {
    const double unit = row_height(), text = 0.4 * unit;
    const double length = 6.0 * unit,
                 top = top_ - (title_rows + gauge_rows * static_cast<double>(row)) * unit;
    const Vector2d lower(0.0, top - 0.85 * unit), upper(length, top - 0.5 * unit);
    char value[16];
    std::snprintf(value, sizeof value, "  %.2f", gauge.share);
    batch.text(plane_, "gauges/labels", {0.5 * length, top - 0.15 * unit}, height_of(Layer::text, text), text,
               gauge.label + value, color(ink_color));
    batch.lines(plane_, "gauges/frames", rectangle(0.5 * (lower + upper), upper - lower),
                height_of(Layer::frame, text), 0.04 * unit, color(0x808080));
    const double end = std::clamp(gauge.share, 0.0, 1.0) * length;
    batch.triangles(plane_, "gauges/bars", filled_rectangle(lower, {end, upper.y()}),
                    height_of(Layer::fill, text),
                    color(boundary_color(gauge.parallel ? BoundaryKind::parallel : BoundaryKind::serial)));
  }

  std::shared_ptr<const Manipulator> manipulator_;
  MarkerFrames frames_;
  Scene scene_;
  MarkerBatch::Plane plane_;
  double top_ = 0.0;  // of the title, so that the gauges stand in the middle [m]
};

}  // namespace

std::shared_ptr<const Picture> make_gauge_picture(std::shared_ptr<const Manipulator> manipulator,
                                                  MarkerFrames frames, const Scene& scene) {
  return std::make_shared<const GaugePicture>(std::move(manipulator), std::move(frames), scene);
}

}  // namespace parallel_aspects
