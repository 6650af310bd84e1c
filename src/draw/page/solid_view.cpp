// SPDX-License-Identifier: BSD-3-Clause
#include "draw/page/solid_view.h"

#include "draw/scene/workspace_bodies.h"
#include "model/angles.h"
#include "model/message_text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr std::size_t width = 416;                   // of the image, in points
constexpr double azimuth = -1.15, elevation = 0.42;  // of the eye, seen from the middle [rad]
constexpr double ambient = 0.55;
constexpr double room_for_axes = 1.12;  // of the farthest point

PagePoint middle_of(std::size_t i) {
  return {(static_cast<double>(i % width) + 0.5) / width, (static_cast<double>(i / width) + 0.5) / width};
}

Rgb shaded(Rgb color, double light) {
  Rgb result = 0;
  for (const unsigned shift : {16U, 8U, 0U})
    result |= static_cast<Rgb>(light * (color >> shift & 0xFFU)) << shift;
  return result;
}

/// A parallel projection of a box of three coordinates, from the front, a little right and above.
class Eye {
 public:
  /// The ends of the box, and how long its edges are drawn.
  Eye(const Vector3d& lower, const Vector3d& upper, const Vector3d& lengths)
      : middle_(0.5 * (lower + upper)), scale_(lengths.cwiseQuotient(upper - lower)) {
    towards_ = Vector3d(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                        std::sin(elevation));
    right_ = Vector3d::UnitZ().cross(towards_).normalized();
    up_ = towards_.cross(right_);
    double farthest = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d at = 0.5 * Vector3d((corner & 1) - 0.5, (corner >> 1 & 1) - 0.5, (corner >> 2 & 1) - 0.5)
                                    .cwiseProduct(2.0 * lengths);
      farthest = std::max({farthest, std::abs(at.dot(right_)), std::abs(at.dot(up_))});
    }
    extent_ = room_for_axes * farthest;
  }

  /// Where a point is seen, 0 to 1 to the right and down, and how near to the eye.
  Vector3d seen(const Vector3d& point) const {
    const Vector3d at = (point - middle_).cwiseProduct(scale_) / extent_;
    return {0.5 + 0.5 * at.dot(right_), 0.5 - 0.5 * at.dot(up_), at.dot(towards_)};
  }

  /// Brightness of a surface with this normal, on either side; 0 to 1.
  double light(const Vector3d& normal) const {
    const Vector3d drawn = normal.cwiseQuotient(scale_);
    const Vector3d outward = drawn.dot(towards_) < 0.0 ? Vector3d(-drawn) : drawn;
    const Vector3d lamp = (towards_ + 0.6 * up_ - 0.45 * right_).normalized();
    return ambient + (1.0 - ambient) * std::max(0.0, outward.normalized().dot(lamp));
  }

 private:
  Vector3d middle_, scale_, towards_, right_, up_;
  double extent_ = 1.0;
};

/// Shaded surfaces; what is in front hides what is behind.
class SurfaceImage {
 public:
  explicit SurfaceImage(const Eye& eye)
      : eye_(eye),
        points_(width * width, 0xFFFFFF),
        depths_(width * width, -std::numeric_limits<double>::infinity()),
        ids_(width * width, 0) {}

  void add(const ColoredMesh& mesh) {
    colors_.resize(std::max(colors_.size(), static_cast<std::size_t>(mesh.aspect) + 1));
    colors_[static_cast<std::size_t>(mesh.aspect)] = mesh.color;
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      corners.push_back({eye_.seen(mesh.points[i].cast<double>()), mesh.normals[i].cast<double>()});
    for (const auto& [a, b, c] : mesh.triangles)
      fill(corners[a], corners[b], corners[c], mesh.aspect, mesh.color);
  }

  PageImage image() const {
    PageImage image;
    image.width = width;
    image.points = points_;
    return image;
  }

  /// Each id where most of its aspect is seen around it.
  // By steps from point to point, first from the upper left, then from the lower right.
  std::vector<ImageLabel> labels() const {
    std::vector<int> room(ids_.size(), 0);
    const auto beside = [&](std::size_t i, std::size_t other) {
      return ids_[other] == ids_[i] ? room[other] : 0;
    };
    for (std::size_t i = width; i < ids_.size(); ++i)
      room[i] = std::min(beside(i, i - 1), beside(i, i - width)) + 1;
    std::map<int, std::size_t> widest;
    for (std::size_t i = ids_.size() - width; i-- > 0;) {
      room[i] = std::min(room[i], std::min(beside(i, i + 1), beside(i, i + width)) + 1);
      if (ids_[i] != 0 && room[i] > room[widest.emplace(ids_[i], i).first->second]) widest[ids_[i]] = i;
    }
    std::vector<ImageLabel> result;
    for (const auto& [id, i] : widest)
      result.push_back({std::to_string(id),
                        {middle_of(i), 0.7 * room[i] / static_cast<double>(width)},
                        colors_[static_cast<std::size_t>(id)]});
    return result;
  }

 private:
  struct Corner {
    Vector3d seen, normal;
  };

  // By barycentric coordinates of the points of the image in the box around the triangle.
  void fill(const Corner& a, const Corner& b, const Corner& c, int aspect, Rgb color) {
    const auto cross = [](const Vector3d& p, const Vector3d& q, const Vector3d& r) {
      return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
    };
    const double area = cross(a.seen, b.seen, c.seen);
    if (area == 0.0) return;
    const Vector3d lower = a.seen.cwiseMin(b.seen).cwiseMin(c.seen) * width,
                   upper = a.seen.cwiseMax(b.seen).cwiseMax(c.seen) * width;
    const auto index = [](double value) {
      return static_cast<std::size_t>(std::clamp(value, 0.0, static_cast<double>(width)));
    };
    for (std::size_t row = index(lower.y()); row < index(upper.y() + 1.0); ++row)
      for (std::size_t column = index(lower.x()); column < index(upper.x() + 1.0); ++column) {
        const std::size_t i = row * width + column;
        const Vector3d at(middle_of(i).x(), middle_of(i).y(), 0.0);
        const double u = cross(at, b.seen, c.seen) / area, v = cross(a.seen, at, c.seen) / area,
                     w = 1.0 - u - v;
        const double depth = u * a.seen.z() + v * b.seen.z() + w * c.seen.z();
        if (!(u >= 0.0 && v >= 0.0 && w >= 0.0 && depth > depths_[i])) continue;
        depths_[i] = depth;
        ids_[i] = aspect;
        points_[i] = shaded(color, eye_.light(u * a.normal + v * b.normal + w * c.normal));
      }
  }

  const Eye& eye_;
  std::vector<Rgb> points_;
  std::vector<double> depths_;  // how near
  std::vector<int> ids_;
  std::vector<Rgb> colors_;  // by id
};

constexpr double shortest_edge = 0.5;          // of the box, of its longest
constexpr std::size_t most_triangles = 40000;  // of a surface

/// The box that is drawn.
struct SolidBox {
  Vector3d lower, upper;
  std::array<std::string, 3> names, units;
};

SolidBox box_of(const AspectMap& map) {
  if (map.manipulator()->task_space() == TaskSpace::SO3)
    return {Vector3d::Constant(-pi),
            Vector3d::Constant(pi),
            {"about x", "about y", "about z"},
            {"rad", "rad", "rad"}};
  SolidBox box{Vector3d::Constant(std::numeric_limits<double>::infinity()),
               Vector3d::Constant(-std::numeric_limits<double>::infinity()),
               {},
               {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    box.names[i] = map.coordinates()[i];
    box.units[i] = box.names[i] == "phi" ? "rad" : "m";
    for (const Aspect& aspect : map.aspects()) {
      box.lower[k] = std::min(box.lower[k], aspect.bounds.lower[i]);
      box.upper[k] = std::max(box.upper[k], aspect.bounds.upper[i]);
    }
  }
  return box;
}

// Lengths keep their proportion unless one is far shorter; an angle is drawn as long as the longest of them.
Vector3d lengths_of(const SolidBox& box) {
  const Vector3d ranges = box.upper - box.lower;
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    if (box.units[i] == "m") longest = std::max(longest, ranges[static_cast<Eigen::Index>(i)]);
  Vector3d lengths = Vector3d::Ones();
  for (std::size_t i = 0; i < 3; ++i)
    if (const auto k = static_cast<Eigen::Index>(i); box.units[i] == "m")
      lengths[k] = std::max(shortest_edge, ranges[k] / longest);
  return lengths;
}

// The edges of the box in front below, and at the left.
std::vector<ImageAxis> axes_of(const SolidBox& box, const Eye& eye) {
  const Vector3d& l = box.lower;
  const Vector3d& u = box.upper;
  const std::array<std::pair<Vector3d, Vector3d>, 3> edges{
      std::pair{l, Vector3d(u.x(), l.y(), l.z())},
      {Vector3d(u.x(), l.y(), l.z()), Vector3d(u.x(), u.y(), l.z())},
      {l, Vector3d(l.x(), l.y(), u.z())}};
  std::vector<ImageAxis> axes;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    axes.push_back(
        {eye.seen(edges[i].first).head<2>(),
         eye.seen(edges[i].second).head<2>(),
         {box.names[i] + " [" + box.units[i] + "]", number_text(l[k], 3) + " to " + number_text(u[k], 3)}});
  }
  return axes;
}

std::set<int> aspects_of(const AspectMap& map, const WorkingMode& mode) {
  std::set<int> ids;
  for (const Aspect& aspect : map.aspects())
    if (aspect.mode == mode) ids.insert(aspect.id);
  return ids;
}

std::set<int> seen_in(const PagePanel& panel) {
  std::set<int> ids;
  for (const ImageLabel& label : panel.image_labels) ids.insert(std::stoi(label.text));
  return ids;
}

}  // namespace

void add_solids(const std::shared_ptr<const AspectMap>& shared, const std::vector<WorkingMode>& modes,
                const std::function<void()>& checkpoint, Page& page) {
  const AspectMap& map = *shared;
  const SolidBox box = box_of(map);
  const Eye eye(box.lower, box.upper, lengths_of(box));
  SurfaceStore store(shared);
  AspectPaint paint(map, Tint::none);
  WorkspaceStyle style;
  style.section = HalfSpace{-Vector3d::UnitY(), -0.5 * (box.lower.y() + box.upper.y())};
  const std::atomic<bool> never_cancelled{false};
  page.notes = {
      (map.slice() ? "Map of the slice " + to_string(*map.slice()) + "." : std::string("Map of all poses.")) +
      " The boxes that are proved to lie in each aspect, smoothed for the eye by no more than one of them; "
      "what is in front of the middle of " +
      box.names[1] + " is cut away."};
  if (map.manipulator()->task_space() == TaskSpace::SO3)
    page.notes.emplace_back(
        "Orientations as rotation vectors, in a ball of radius pi; opposite points of its surface are the "
        "same.");
  std::vector<int> hidden;
  for (const WorkingMode& mode : modes) {
    const std::set<int> ids = aspects_of(map, mode);
    SurfaceImage image(eye);
    for (const int id : ids) {
      checkpoint();
      for (const ColoredMesh& mesh :
           workspace_bodies(store, paint, style, {id}, most_triangles, 0, never_cancelled).meshes)
        image.add(mesh);
    }
    PagePanel panel;
    panel.image = image.image();
    panel.image_labels = image.labels();
    panel.image_axes = axes_of(box, eye);
    page.figures.push_back({"working mode " + to_string(mode), aspect_legend(map, ids), {std::move(panel)}});
    const std::set<int> seen = seen_in(page.figures.back().panels.front());
    std::set_difference(ids.begin(), ids.end(), seen.begin(), seen.end(), std::back_inserter(hidden));
  }
  if (!hidden.empty())
    page.notes.push_back(missing_aspects(
        hidden, "Cut away, behind others or smaller than a point of the picture, and not seen"));
  page.legend = sign_legend();
}

}  // namespace parallel_aspects
