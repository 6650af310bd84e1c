// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/gate_line.h"
#include "tools/drawing/result_charts.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

/// The numbers of an attribute of each element of that name.
std::vector<std::string> attributes(const std::string& svg, const std::string& element,
                                    const std::string& name) {
  std::vector<std::string> values;
  for (std::size_t at = svg.find("<" + element + " "); at != std::string::npos;
       at = svg.find("<" + element + " ", at + 1)) {
    const std::size_t start = svg.find(" " + name + "=\"", at) + name.size() + 3;
    values.push_back(svg.substr(start, svg.find('"', start) - start));
  }
  return values;
}

std::vector<NodeCircle> circles_of(const std::string& svg) {
  const auto x = attributes(svg, "circle", "cx"), y = attributes(svg, "circle", "cy"),
             r = attributes(svg, "circle", "r");
  std::vector<NodeCircle> circles;
  for (std::size_t i = 0; i < x.size(); ++i)
    circles.push_back({{std::stod(x[i]), std::stod(y[i])}, std::stod(r[i])});
  return circles;
}

/// "M1 2 L3 4" or "M1 2 C3 4 5 6 7 8".
GateLine read_line(std::string path) {
  for (char& letter : path)
    if (letter == 'M' || letter == 'C' || letter == 'L') letter = ' ';
  std::vector<PagePoint> points;
  std::istringstream numbers(path);
  for (double x = 0.0, y = 0.0; numbers >> x >> y;) points.emplace_back(x, y);
  if (points.size() == 2) return {{points[0], points[0], points[1], points[1]}};
  return {{points.at(0), points.at(1), points.at(2), points.at(3)}};
}

// A line that crosses a circle, or touches it, reads as if that aspect were joined.
void expect_clear(const std::string& robot, const std::vector<NodeCircle>& circles, const GateLine& line) {
  int ends = 0;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const PagePoint& middle = circles[i].middle;
    if ((line.at(0.0) - middle).norm() < 0.1 || (line.at(1.0) - middle).norm() < 0.1) {
      ++ends;
      continue;
    }
    double least = 1e9;
    for (int k = 0; k <= 400; ++k) least = std::min(least, (line.at(k / 400.0) - middle).norm());
    EXPECT_GT(least, circles[i].radius + 2.0) << robot << ", aspect " << i + 1;
  }
  EXPECT_EQ(ends, 2) << robot;
}

TEST(GraphDrawing, NoGatePassesThroughAnotherAspect) {
  for (const char* robot : {"five_bar", "bipod", "three_rpr", "three_prr", "three_rrr", "linear_delta",
                            "delta", "agile_eye", "spherical_3rrr"}) {
    const auto map = compute_aspect_map(test::shipped(robot)->mapped_manipulator()).map;
    ASSERT_TRUE(map) << robot;
    const auto graph = compute_aspect_graph(*map);
    ASSERT_TRUE(graph) << robot;
    const std::string svg = draw_graph(*map, *graph);
    const auto circles = circles_of(svg);
    EXPECT_EQ(circles.size(), map->aspects().size()) << robot;
    const auto paths = attributes(svg, "path", "d");
    EXPECT_EQ(paths.size(), graph->gates.size()) << robot;
    for (const std::string& path : paths) expect_clear(robot, circles, read_line(path));
  }
}

}  // namespace
}  // namespace parallel_aspects::tools
