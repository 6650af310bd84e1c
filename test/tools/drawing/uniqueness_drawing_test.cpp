// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/uniqueness_drawing.h"

#include "draw/plane/singular_curves.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/slices.h"
#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using Eigen::Vector2d;

std::shared_ptr<const Uniqueness> uniqueness_of(const std::string& robot, const std::string& joint,
                                                double value) {
  const auto manipulator = test::shipped(robot)->mapped_manipulator();
  UniquenessOptions options;
  options.slice = test::slice_of(manipulator, {{joint, value}});
  return compute_uniqueness(manipulator, options).uniqueness;
}

const Uniqueness& three_rrr() {
  static const auto found = uniqueness_of("three_rrr", "crank_1_joint", 0.3);
  return *found;
}

const Uniqueness& three_prr() {
  static const auto found = uniqueness_of("three_prr", "slider_1_joint", 0.3);
  return *found;
}

/// Of poses, then of actuated values.
std::vector<PageCurves> curves_of(const PagePicture& picture, const std::string& start) {
  std::vector<PageCurves> found;
  for (const PageElement& element : picture.elements)
    if (const auto* curves = std::get_if<PageCurves>(&element);
        curves != nullptr && curves->title.rfind(start, 0) == 0)
      found.push_back(*curves);
  return found;
}

std::vector<std::string> texts_of(const PagePicture& picture) {
  std::vector<std::string> texts;
  for (const PageElement& element : picture.elements)
    if (const auto* text = std::get_if<PageText>(&element)) texts.push_back(text->text);
  return texts;
}

bool has(const PagePicture& picture, const std::string& text) {
  const std::vector<std::string> texts = texts_of(picture);
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

/// The share of corners at which a line turns by more than 60 degrees.
double share_of_corners(const PageCurves& curves) {
  double sharp = 0.0, all = 0.0;
  for (const PageLine& line : curves.lines)
    for (std::size_t i = 2; i < line.size(); ++i) {
      const PagePoint before = line[i - 1] - line[i - 2], after = line[i] - line[i - 1];
      all += 1.0;
      if (before.dot(after) < 0.5 * before.norm() * after.norm()) sharp += 1.0;
    }
  return all > 0.0 ? sharp / all : 0.0;
}

TEST(UniquenessDrawing, CurvesOfActuatedValuesAreSmooth) {
  for (const Uniqueness* uniqueness : {&three_rrr(), &three_prr()})
    for (const char* kind : {"serial", "parallel"}) {
      const auto curves = curves_of(draw_uniqueness(*uniqueness), kind);
      ASSERT_EQ(curves.size(), 2U);
      EXPECT_LT(share_of_corners(curves.back()), 0.05) << kind;  // cusps are corners
    }
}

/// Of the curves that are drawn of a slice.
std::vector<SingularPiece> singular_pieces(const Uniqueness& uniqueness, const JointProjection& projection) {
  const PoseSlice plane(*uniqueness.map->manipulator(), *uniqueness.map->slice());
  SingularCurves curves(*uniqueness.map, projection);
  for (const WorkingMode& mode : uniqueness.map->working_modes())
    for (const BoundarySegment& segment :
         trace_slice(*uniqueness.map, mode, plane, slice_bounds(*uniqueness.map, *uniqueness.map->slice()),
                     240)
             .segments)
      curves.follow(segment, mode);
  return curves.pieces();
}

std::optional<std::size_t> number_at(const Uniqueness& uniqueness, const Vector2d& at) {
  JointVector q(3);
  q << uniqueness.map->slice()->joint->value, at;
  const auto component = uniqueness.component_at(q);
  if (!component) return std::nullopt;
  return uniqueness.basic_components[*component].solutions.size();
}

// Direct solutions meet or vanish on either side of a curve of det A = 0, and nowhere else.
TEST(UniquenessDrawing, NumbersChangeAcrossParallelSingularities) {
  const JointProjection projection(three_rrr().map);
  const JointWindow& window = projection.window();
  std::vector<Vector2d> points;
  int changes = 0, looked_at = 0;
  for (const SingularPiece& piece : singular_pieces(three_rrr(), projection)) {
    if (piece.kind != BoundaryKind::parallel) continue;
    const Vector2d along = (piece.actuated[1] - piece.actuated[0]).normalized(),
                   across = 0.02 * Vector2d(-along.y(), along.x());
    points.push_back(window.wrapped(piece.actuated[0]));
    const auto left = number_at(three_rrr(), window.wrapped(piece.actuated[0] + across)),
               right = number_at(three_rrr(), window.wrapped(piece.actuated[0] - across));
    if (!left || !right) continue;
    ++looked_at;
    changes += left != right;
  }
  EXPECT_GT(looked_at, 300);
  EXPECT_GT(changes, 0.8 * looked_at);  // two curves can be nearer to each other
  std::mt19937_64 random(5);
  for (int i = 0; i < 20000; ++i) {
    const Vector2d at(test::uniform(random, -3.1, 3.1), test::uniform(random, -3.1, 3.1));
    const Vector2d other = at + 0.05 * Vector2d(i % 2, 1 - i % 2);
    const auto here = number_at(three_rrr(), at), there = number_at(three_rrr(), other);
    if (!here || !there || *here == *there) continue;
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const Vector2d& each) {
      return (each - at).norm() < 0.07;
    })) << at.transpose();
  }
}

TEST(UniquenessDrawing, ShowsTheLargestModeUnlessAnotherIsChosen) {
  const PagePicture largest = draw_uniqueness(three_prr());
  EXPECT_TRUE(has(largest, "poses in working mode (-,-,-)"));
  const PagePicture first = draw_uniqueness(three_prr(), WorkingMode::from_signs({1, 1, 1}));
  EXPECT_TRUE(has(first, "poses in working mode (+,+,+)"));
}

// Each cusp is named once in the plane of actuated values, and there once more where it is of the mode.
TEST(UniquenessDrawing, NamesCuspsOfTheModeAlone) {
  for (const WorkingMode& mode :
       {*WorkingMode::from_signs({-1, 1, 1}), *WorkingMode::from_signs({1, -1, -1})}) {
    const std::vector<std::string> texts = texts_of(draw_uniqueness(three_rrr(), mode));
    for (std::size_t i = 4; i < three_rrr().cusps.size(); ++i)  // ticks are named 1, 2, 3 too
      EXPECT_EQ(std::count(texts.begin(), texts.end(), std::to_string(i + 1)),
                three_rrr().cusps[i].mode == mode ? 2 : 1)
          << to_string(mode) << ", cusp " << i + 1;
  }
}

TEST(UniquenessDrawing, ShowsSlicesWithoutComponents) {
  const auto empty = uniqueness_of("three_prr", "slider_1_joint", 1.2);
  ASSERT_TRUE(empty->map->aspects().empty());
  EXPECT_TRUE(has(draw_uniqueness(*empty), "actuated values"));
}

TEST(UniquenessDrawing, SaysWhatWhiteIs) {
  EXPECT_TRUE(has(draw_uniqueness(three_rrr()), "no number is proved, no solution, or out of reach"));
}

}  // namespace
}  // namespace parallel_aspects::tools
