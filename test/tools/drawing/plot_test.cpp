// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/plot.h"

#include "draw/page/outlines.h"
#include "draw/page/page.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/slices.h"
#include "support/texts.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <png.h>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using Eigen::Vector2d;
using Map = std::shared_ptr<const AspectMap>;

Map map_of(const std::string& robot, const std::optional<double>& resolution = std::nullopt) {
  MapOptions options;
  options.resolution = resolution;
  return compute_aspect_map(test::shipped(robot)->mapped_manipulator(), options).map;
}

const Map& five_bar() {
  static const Map map = map_of("five_bar");
  return map;
}

/// A panel as it is drawn: its frame, and what is between it and the next one.
struct DrawnPanel {
  Vector2d corner = Vector2d::Zero(), size = Vector2d::Zero();  // of the page [px]
  std::vector<PageArea> areas;
  std::vector<PageCurves> curves;
};

constexpr double frame_width = 0.8;

// Frames come after what is in them.
std::vector<DrawnPanel> panels_of(const PagePicture& picture) {
  std::vector<DrawnPanel> panels;
  DrawnPanel next;
  for (const PageElement& element : picture.elements) {
    if (const auto* area = std::get_if<PageArea>(&element); area != nullptr && !area->title.empty())
      next.areas.push_back(*area);
    const auto* curves = std::get_if<PageCurves>(&element);
    if (curves == nullptr) continue;
    if (!curves->title.empty()) next.curves.push_back(*curves);
    if (curves->width == frame_width && curves->lines.front().size() == 5) {
      next.corner = curves->lines.front()[0];
      next.size = curves->lines.front()[2] - next.corner;
      panels.push_back(std::move(next));
      next = {};
    }
  }
  return panels;
}

Vector2d in_panel(const DrawnPanel& panel, const Vector2d& lower, const Vector2d& upper,
                  const PagePoint& at) {
  const Vector2d share = (at - panel.corner).cwiseQuotient(panel.size);
  return lower + Vector2d(share.x(), 1.0 - share.y()).cwiseProduct(upper - lower);
}

std::vector<PageCurves> named(const DrawnPanel& panel, const std::string& start) {
  std::vector<PageCurves> found;
  for (const PageCurves& curves : panel.curves)
    if (curves.title.rfind(start, 0) == 0) found.push_back(curves);
  return found;
}

int id_of(const PageArea& area) { return std::stoi(area.title.substr(std::string("aspect ").size())); }

// Every aspect once in the workspace, as large as it is.
TEST(Plot, WorkspaceAreasAreTheMeasures) {
  for (const char* robot : {"five_bar", "bipod"}) {
    const Map map = map_of(robot);
    const PosePlane plane = plane_of(*map, std::nullopt);
    const double range = plane.bounds.sizes().maxCoeff();
    std::map<int, double> areas;
    for (const DrawnPanel& panel : panels_of(draw_plot(map, {}))) {
      if (panel.areas.empty() || panel.size.isApprox(Vector2d(260.0, 260.0), 1e-9)) continue;
      const double scale = range / panel.size.maxCoeff();
      for (const PageArea& area : panel.areas)
        areas[id_of(area)] += std::abs(area_of(area.loops)) * scale * scale;
    }
    EXPECT_EQ(areas.size(), map->aspects().size()) << robot;
    for (const Aspect& aspect : map->aspects()) {
      const double grain = 0.01 * aspect.measure + 0.05 * range * map->resolution();
      EXPECT_NEAR(areas[aspect.id], aspect.measure, grain) << robot << ", aspect " << aspect.id;
    }
  }
}

// The formulas of the paper: A = (0, 0), B = (9, 0), cranks 8 and 5, rods 5 and 8.
struct PaperFiveBar {
  static constexpr double base = 9.0, crank_1 = 8.0, rod_1 = 5.0, crank_2 = 5.0, rod_2 = 8.0;

  static Vector2d elbow(const Vector2d& pivot, double crank, double rod, const Vector2d& p, int sign) {
    const Vector2d along = p - pivot;
    const double r = along.norm(), a = (r * r + crank * crank - rod * rod) / (2.0 * r);
    const double h = std::sqrt(std::max(0.0, crank * crank - a * a));
    // B11 = L1 L2 sin(theta3 - theta1) is (c - pivot) x (p - c).
    const Vector2d left(-along.y() / r, along.x() / r);
    return pivot + a / r * along - sign * h * left;
  }

  static double sine_between_rods(const Vector2d& p, const WorkingMode& mode) {
    const Vector2d u = p - elbow({0.0, 0.0}, crank_1, rod_1, p, mode.sign(0)),
                   v = p - elbow({base, 0.0}, crank_2, rod_2, p, mode.sign(1));
    return (u.x() * v.y() - u.y() * v.x()) / (rod_1 * rod_2);
  }

  static double nearest_serial(const Vector2d& p) {
    const double a = p.norm(), b = (p - Vector2d(base, 0.0)).norm();
    return std::min({std::abs(a - 13.0), std::abs(a - 3.0), std::abs(b - 13.0), std::abs(b - 3.0)});
  }
};

PlotOptions only(const WorkingMode& mode) {
  PlotOptions options;
  options.modes = {mode};
  return options;
}

TEST(Plot, SingularCurvesOfTheFiveBarAreThoseOfThePaper) {
  const PosePlane plane = plane_of(*five_bar(), std::nullopt);
  for (const WorkingMode& mode : five_bar()->working_modes()) {
    const DrawnPanel workspace = panels_of(draw_plot(five_bar(), only(mode))).front();
    std::size_t parallel = 0, serial = 0;
    for (const PageCurves& curves : named(workspace, "parallel"))
      for (const PageLine& line : curves.lines)
        for (const PagePoint& at : line) {
          const Vector2d p = in_panel(workspace, plane.bounds.min(), plane.bounds.max(), at);
          if (PaperFiveBar::nearest_serial(p) < 0.3) continue;  // there the sine changes like a root
          EXPECT_NEAR(PaperFiveBar::sine_between_rods(p, mode), 0.0, 0.02) << p.transpose();
          ++parallel;
        }
    for (const PageCurves& curves : named(workspace, "serial"))
      for (const PageLine& line : curves.lines)
        for (const PagePoint& at : line) {
          const Vector2d p = in_panel(workspace, plane.bounds.min(), plane.bounds.max(), at);
          EXPECT_LT(PaperFiveBar::nearest_serial(p), 0.02) << p.transpose();
          ++serial;
        }
    EXPECT_GT(parallel, 20U) << to_string(mode);
    EXPECT_GT(serial, 40U) << to_string(mode);
  }
}

// In joint space the parallel singularities are where the elbows are as far apart as both rods stretched or
// folded.
TEST(Plot, JointSpaceIsBoundedWhereTheRodsAreInLine) {
  const double turn = 2.0 * std::acos(-1.0);
  for (const WorkingMode& mode : five_bar()->working_modes()) {
    const std::vector<DrawnPanel> panels = panels_of(draw_plot(five_bar(), only(mode)));
    ASSERT_EQ(panels.size(), 3U) << "workspace, and joint space by sign of det A";
    std::size_t looked_at = 0;
    for (std::size_t i = 1; i < 3; ++i)
      for (const PageCurves& curves : named(panels[i], "parallel"))
        for (const PageLine& line : curves.lines)
          for (const PagePoint& at : line) {
            const Vector2d q =
                in_panel(panels[i], Vector2d::Constant(-0.5 * turn), Vector2d::Constant(0.5 * turn), at);
            const Vector2d c = 8.0 * Vector2d(std::cos(q[0]), std::sin(q[0])),
                           d = Vector2d(9.0, 0.0) + 5.0 * Vector2d(std::cos(q[1]), std::sin(q[1]));
            const double apart = (c - d).norm();
            EXPECT_LT(std::min(std::abs(apart - 13.0), std::abs(apart - 3.0)), 0.12) << q.transpose();
            ++looked_at;
          }
    EXPECT_GT(looked_at, 40U) << to_string(mode);
  }
}

// By working mode and sign of det A, the joint space has the area that is found by trying joint values: the
// end point is where two circles about the elbows meet, on either side of the line between them.
TEST(Plot, JointSpaceAreasAreThoseOfTheJointValues) {
  std::map<std::pair<std::size_t, int>, double> drawn, found;
  const double turn = 2.0 * std::acos(-1.0);
  for (const DrawnPanel& panel : panels_of(draw_plot(five_bar(), {}))) {
    if (!panel.size.isApprox(Vector2d(260.0, 260.0), 1e-9)) continue;
    const double scale = turn / 260.0;
    for (const PageArea& area : panel.areas) {
      const Aspect& aspect = five_bar()->aspects()[static_cast<std::size_t>(id_of(area) - 1)];
      drawn[{aspect.mode.index(), aspect.determinant_sign}] += std::abs(area_of(area.loops)) * scale * scale;
    }
  }
  const auto cross = [](const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
  constexpr int steps = 600;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const double q_1 = turn * (i + 0.5) / steps, q_2 = turn * (k + 0.5) / steps;
      const Vector2d a(0.0, 0.0), b(9.0, 0.0), c = 8.0 * Vector2d(std::cos(q_1), std::sin(q_1)),
                                               d = b + 5.0 * Vector2d(std::cos(q_2), std::sin(q_2));
      const double r = (d - c).norm(), along = (r * r + 25.0 - 64.0) / (2.0 * r), h = 25.0 - along * along;
      if (!(h > 0.0)) continue;
      const Vector2d unit = (d - c) / r, left(-unit.y(), unit.x());
      for (const double side : {1.0, -1.0}) {
        const Vector2d p = c + along * unit + side * std::sqrt(h) * left;
        const std::size_t mode =
            (cross(c - a, p - c) < 0.0 ? 1U : 0U) + (cross(d - b, p - d) < 0.0 ? 2U : 0U);
        found[{mode, cross(p - c, p - d) > 0.0 ? 1 : -1}] += turn * turn / (steps * steps);
      }
    }
  ASSERT_EQ(drawn.size(), 8U);
  for (const auto& [which, area] : found)
    EXPECT_NEAR(drawn[which], area, 0.02 * area + 0.03) << which.first << ' ' << which.second;
}

TEST(Plot, LinesOfEqualIndexHaveTheirIndex) {
  PlotOptions options = only(WorkingMode::from_index(2, 0));
  options.levels = {DrawnIndex::parallel, {0.5}};
  const PosePlane plane = plane_of(*five_bar(), std::nullopt);
  const BoundaryPicture traced = trace_slice(*five_bar(), options.modes.front(), plane.slice, plane.bounds,
                                             180, Cells::single, options.levels);
  EXPECT_GT(traced.levels.size(), 300U);
  for (const LevelSegment& segment : traced.levels) {
    if (PaperFiveBar::nearest_serial(segment.from) < 0.3) continue;
    EXPECT_NEAR(std::abs(PaperFiveBar::sine_between_rods(segment.from, options.modes.front())), 0.5, 0.01);
  }
  const std::string svg = as_svg(draw_plot(five_bar(), options));
  EXPECT_TRUE(test::has(svg, "lines of equal parallel index"));
  EXPECT_TRUE(test::has(svg, ">0.5</text>"));
  options.levels.index = DrawnIndex::conditioning;
  EXPECT_TRUE(test::has(as_svg(draw_plot(five_bar(), options)), "isoconditioning"));
}

TEST(Plot, EachAspectHasItsFigure) {
  PlotOptions options;
  options.each_aspect = true;
  const std::vector<DrawnPanel> panels = panels_of(draw_plot(five_bar(), options));
  ASSERT_EQ(panels.size(), 20U);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    ASSERT_EQ(panels[i].areas.size(), 1U);
    EXPECT_EQ(id_of(panels[i].areas.front()), static_cast<int>(i / 2) + 1);
  }
}

Eigen::AlignedBox2d box_of(const PageText& text) {
  const double width = text_width(text.text, text.size);
  const double left = text.anchor == TextAnchor::start    ? 0.0
                      : text.anchor == TextAnchor::middle ? 0.5 * width
                                                          : width;
  const PagePoint lower = text.at + PagePoint(-left, -0.72 * text.size);
  return {lower, PagePoint(lower + PagePoint(width, 0.72 * text.size))};
}

TEST(Plot, NoTextOverlapsAnotherOrLeavesThePage) {
  for (const Map& map : {five_bar(), map_of("bipod")})
    for (const bool each : {false, true}) {
      PlotOptions options;
      options.each_aspect = each;
      options.levels = {DrawnIndex::conditioning, {0.2, 0.4, 0.6, 0.8}};
      const PagePicture picture = draw_plot(map, options);
      std::vector<PageText> texts;
      for (const PageElement& element : picture.elements)
        if (const auto* text = std::get_if<PageText>(&element)) texts.push_back(*text);
      const Eigen::AlignedBox2d page(PagePoint(0.0, 0.0), PagePoint(picture.width, picture.height));
      for (std::size_t i = 0; i < texts.size(); ++i) {
        EXPECT_TRUE(page.contains(box_of(texts[i]))) << texts[i].text;
        for (std::size_t k = 0; k < i; ++k)
          EXPECT_TRUE(box_of(texts[i]).intersection(box_of(texts[k])).isEmpty())
              << "'" << texts[i].text << "' and '" << texts[k].text << "' at " << texts[k].at.transpose();
      }
    }
}

struct Decoded {
  std::size_t width = 0, height = 0;
  std::vector<Rgb> points;
};

Decoded decoded(const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  Decoded result;
  if (png_image_begin_read_from_memory(&image, file.data(), file.size()) == 0) return result;
  image.format = PNG_FORMAT_RGB;
  std::vector<png_byte> bytes(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) == 0) return result;
  result.width = image.width;
  result.height = image.height;
  for (std::size_t i = 0; i + 2 < bytes.size(); i += 3)
    result.points.push_back(Rgb{bytes[i]} << 16U | Rgb{bytes[i + 1]} << 8U | bytes[i + 2]);
  return result;
}

// Read by another library, the picture shows each colour over its area.
TEST(Plot, PngShowsTheAreas) {
  const PagePicture picture = draw_plot(five_bar(), only(WorkingMode::from_index(2, 0)));
  const Decoded image = decoded(as_png(picture, 2.0));
  ASSERT_EQ(image.width, static_cast<std::size_t>(2.0 * picture.width));
  ASSERT_EQ(image.height, static_cast<std::size_t>(2.0 * picture.height));
  const std::vector<Rgb> colors = aspect_colors(five_bar()->aspects());
  std::map<Rgb, double> expected;
  for (const PageElement& element : picture.elements)
    if (const auto* area = std::get_if<PageArea>(&element); area != nullptr && !area->title.empty())
      expected[area->color] += std::abs(area_of(area->loops));
  EXPECT_EQ(expected.size(), 2U);
  for (const auto& [color, area] : expected) {
    const double seen =
        static_cast<double>(std::count(image.points.begin(), image.points.end(), color)) / 4.0;
    EXPECT_LT(seen, area * 1.02 + 300.0) << "and the swatches";
    EXPECT_GT(seen, 0.8 * area) << "but for curves and ids";
  }
}

TEST(Plot, BodiesOfThreeCoordinatesAreSeen) {
  const Map map = map_of("linear_delta", 0.05);
  ASSERT_TRUE(map);
  PlotOptions options;
  options.modes = {map->working_modes().front()};
  const PagePicture picture = draw_plot(map, options);
  const auto image =
      std::find_if(picture.elements.begin(), picture.elements.end(),
                   [](const PageElement& each) { return std::holds_alternative<PageImage>(each); });
  ASSERT_NE(image, picture.elements.end());
  const auto& points = std::get<PageImage>(*image).points;
  const auto white = static_cast<std::size_t>(std::count(points.begin(), points.end(), 0xFFFFFFU));
  EXPECT_GT(points.size() - white, points.size() / 20);
  EXPECT_GT(white, points.size() / 10);
  EXPECT_EQ(as_svg(picture).find("<image"), as_svg(picture).rfind("<image"));
}

std::string all_text(const PagePicture& picture) {
  std::string all;
  for (const PageElement& element : picture.elements)
    if (const auto* text = std::get_if<PageText>(&element)) all += text->text + " ";
  return all;
}

// One of this slice is smaller than a cell of the grid.
TEST(Plot, AspectsThatAreNotDrawnAreNamed) {
  const auto robot = test::shipped("three_rrr")->mapped_manipulator();
  MapOptions map_options;
  map_options.slice = test::slice_of(robot, {{"phi", 0.0}});
  const Map map = compute_aspect_map(robot, map_options).map;
  ASSERT_TRUE(map);
  const PagePicture picture = draw_plot(map, {});
  std::set<int> drawn;
  for (const DrawnPanel& panel : panels_of(picture))
    for (const PageArea& area : panel.areas) drawn.insert(id_of(area));
  std::vector<int> missing;
  for (const Aspect& aspect : map->aspects())
    if (drawn.count(aspect.id) == 0) missing.push_back(aspect.id);
  ASSERT_FALSE(missing.empty());
  EXPECT_TRUE(test::has(all_text(picture),
                        missing_aspects(missing, "Smaller than a cell of that grid, and not drawn")));
  EXPECT_FALSE(test::has(all_text(draw_plot(five_bar(), {})), "not drawn"));
}

TEST(Plot, MissingAspectsAreCountedWhereTheyAreMany) {
  EXPECT_EQ(missing_aspects({4}, "Not seen"), "Not seen: aspect 4.");
  EXPECT_EQ(missing_aspects({4, 7}, "Not seen"), "Not seen: aspects 4, 7.");
  EXPECT_EQ(missing_aspects({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14}, "Not seen"),
            "Not seen: aspects 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 and 2 more.");
}

// Images have a white ground.
TEST(Plot, ImagesCoverNoText) {
  const Map map = map_of("linear_delta", 0.05);
  ASSERT_TRUE(map);
  std::vector<PageText> before;
  int images = 0;
  for (const PageElement& element : draw_plot(map, {}).elements) {
    if (const auto* text = std::get_if<PageText>(&element)) before.push_back(*text);
    const auto* image = std::get_if<PageImage>(&element);
    if (image == nullptr) continue;
    ++images;
    const Eigen::AlignedBox2d covered(image->corner, PagePoint(image->corner + image->size));
    for (const PageText& text : before) {
      Eigen::AlignedBox2d box = box_of(text);
      box.extend(PagePoint(box.max() + PagePoint(0.0, 0.25 * text.size)));  // what hangs below its base line
      EXPECT_TRUE(box.intersection(covered).isEmpty()) << text.text;
    }
  }
  EXPECT_GT(images, 1);
}

TEST(Plot, EndsWhereTheCheckpointThrows) {
  struct Ended {};
  EXPECT_THROW(draw_plot(five_bar(), {}, [] { throw Ended{}; }), Ended);
}

}  // namespace
}  // namespace parallel_aspects::tools
