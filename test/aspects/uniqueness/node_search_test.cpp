// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;
using test::Robot;

MapSlice slice_of_first_strut(const Robot& robot, double held) {
  return test::slice_of(robot, {{robot->leg(0).actuated_joint, held}});
}

std::shared_ptr<const Uniqueness> uniqueness_of_slice(const Robot& robot, double held) {
  UniquenessOptions options;
  options.most_cells = 400;  // numbers of solutions are not examined here
  return test::uniqueness_of_slice(robot, 0, held, options);
}

/// The image of det A = 0 in doubles: a segment in each triangle of a grid of the slice whose corners have
/// both signs, with ends that bisection finds on its edges. The triangles of a block are examined where the
/// corners of the blocks about it have both signs.
class ImageCurve {
 public:
  ImageCurve(const Robot& robot, double held)
      : robot_(*robot), circle_(circle_of_anchor(robot_, *slice_of_first_strut(robot, held).joint)) {
    for (int x = 0; x < cells; x += block)
      for (int y = 0; y < cells; y += block)
        if (has_both_signs_about({x, y})) add_block({x, y});
  }

  /// Where segments cross that have no end in common, nor are next to one that has.
  std::vector<Vector2d> crossings() const {
    std::vector<Vector2d> found;
    std::map<std::pair<int, int>, std::vector<std::size_t>> buckets;
    for (std::size_t i = 0; i < segments_.size(); ++i)
      for (const auto& bucket : buckets_of(segments_[i])) {
        for (const std::size_t k : buckets[bucket])
          if (const auto at = crossing(segments_[i], segments_[k])) add_new(*at, found);
        buckets[bucket].push_back(i);
      }
    return found;
  }

 private:
  static constexpr int cells = 1500, block = 6;
  static constexpr double bucket_width = 0.05;
  using Point = std::array<int, 2>;

  struct Segment {
    std::array<Vector2d, 2> slice, image;
  };

  Vector2d at(const Point& point) const {
    return (2.0 * EIGEN_PI / cells) * Vector2d(point[0] + 0.31, point[1] + 0.17);
  }

  JointVector lengths(const Vector2d& at) const {
    return inverse(robot_, circle_.pose(at.x(), at.y()), working_modes(robot_).front()).q;
  }

  double determinant(const Vector2d& at) const {
    return direct_determinant(robot_, circle_.pose(at.x(), at.y()), lengths(at));
  }

  double known_determinant(const Point& point) {
    const auto [entry, is_new] = known_.try_emplace(point, 0.0);
    if (is_new) entry->second = determinant(at(point));
    return entry->second;
  }

  bool has_both_signs_about(const Point& corner) {
    int negative = 0, all = 0;
    for (int x = -block; x <= 2 * block; x += block)
      for (int y = -block; y <= 2 * block; y += block, ++all)
        negative += known_determinant({corner[0] + x, corner[1] + y}) < 0.0 ? 1 : 0;
    return negative > 0 && negative < all;
  }

  void add_block(const Point& corner) {
    for (int x = corner[0]; x < corner[0] + block; ++x)
      for (int y = corner[1]; y < corner[1] + block; ++y) {
        add({Point{x, y}, Point{x + 1, y}, Point{x, y + 1}});
        add({Point{x + 1, y + 1}, Point{x + 1, y}, Point{x, y + 1}});
      }
  }

  Vector2d zero_between(Vector2d negative, Vector2d positive) const {
    for (int i = 0; i < 45; ++i) {
      const Vector2d middle = 0.5 * (negative + positive);
      (determinant(middle) < 0.0 ? negative : positive) = middle;
    }
    return positive;
  }

  void add(const std::array<Point, 3>& corners) {
    std::vector<Vector2d> ends;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point &one = corners[i], &other = corners[(i + 1) % 3];
      const bool first = known_determinant(one) < 0.0, second = known_determinant(other) < 0.0;
      if (first == second) continue;
      ends.push_back(first ? zero_between(at(one), at(other)) : zero_between(at(other), at(one)));
    }
    if (ends.size() != 2) return;
    Segment segment;
    for (std::size_t i = 0; i < 2; ++i) {
      segment.slice[i] = ends[i];
      segment.image[i] = lengths(ends[i]).tail<2>();
    }
    segments_.push_back(segment);
  }

  static std::vector<std::pair<int, int>> buckets_of(const Segment& segment) {
    const auto bucket = [](double value) { return static_cast<int>(std::floor(value / bucket_width)); };
    const Vector2d least = segment.image[0].cwiseMin(segment.image[1]);
    const Vector2d most = segment.image[0].cwiseMax(segment.image[1]);
    std::vector<std::pair<int, int>> result;
    for (int x = bucket(least.x()); x <= bucket(most.x()); ++x)
      for (int y = bucket(least.y()); y <= bucket(most.y()); ++y) result.emplace_back(x, y);
    return result;
  }

  /// Of two poses of the slice, whole turns left out.
  static double distance(const Vector2d& a, const Vector2d& b) {
    constexpr double turn = 2.0 * EIGEN_PI;
    return std::hypot(std::remainder(a.x() - b.x(), turn), std::remainder(a.y() - b.y(), turn));
  }

  static std::optional<Vector2d> crossing(const Segment& a, const Segment& b) {
    if (distance(a.slice[0], b.slice[0]) < 6.0 * 2.0 * EIGEN_PI / cells) return std::nullopt;
    Eigen::Matrix2d ways;
    ways << a.image[1] - a.image[0], b.image[0] - b.image[1];
    const Vector2d shares = ways.inverse() * (b.image[0] - a.image[0]);
    if (!(shares.minCoeff() >= 0.0 && shares.maxCoeff() < 1.0)) return std::nullopt;
    return a.image[0] + shares[0] * (a.image[1] - a.image[0]);
  }

  static void add_new(const Vector2d& at, std::vector<Vector2d>& found) {
    const auto is_known = [&](const Vector2d& other) { return (other - at).norm() < 1e-6; };
    if (std::none_of(found.begin(), found.end(), is_known)) found.push_back(at);
  }

  const Manipulator& robot_;
  AnchorCircle circle_;
  std::map<Point, double> known_;
  std::vector<Segment> segments_;
};

void expect_node(const Manipulator& robot, const SolutionNode& node) {
  EXPECT_LT(node.accuracy, 1e-9);
  const WorkingMode mode = working_modes(robot).front();
  for (const Pose& pose : node.poses) {
    const JointVector q = inverse(robot, pose, mode).q;
    EXPECT_LT((q - node.actuated).norm(), 1e-8);
    EXPECT_LT(singular_values(homogenised_matrix(robot, pose, q)).tail<1>()[0], 1e-9);
  }
  EXPECT_GT((node.poses[0].position - node.poses[1].position).norm() +
                node.poses[0].orientation.angularDistance(node.poses[1].orientation),
            1e-3);
}

// Nodes of the proof are the crossings of the curve that is drawn in doubles, and there are no others.
TEST(NodeSearch, FindsWhereTheImageCrossesItself) {
  const Robot robot = test::three_rpr()->with_constraints({});
  for (const double held : {14.98, 17.5, 31.0}) {
    const auto found = uniqueness_of_slice(robot, held);
    EXPECT_TRUE(found->nodes_complete) << held;
    const std::vector<Vector2d> crossings = ImageCurve(robot, held).crossings();
    EXPECT_EQ(found->nodes.size(), crossings.size()) << held;
    for (const SolutionNode& node : found->nodes) {
      expect_node(*robot, node);
      const Vector2d at = node.actuated.tail<2>();
      EXPECT_TRUE(std::any_of(crossings.begin(), crossings.end(),
                              [&](const Vector2d& each) { return (each - at).norm() < 1e-3; }))
          << held << ": " << at.transpose();
    }
  }
  EXPECT_EQ(uniqueness_of_slice(robot, 14.98)->nodes.size(), 6U);
}

void expect_nodes(const Robot& robot, const Uniqueness& found, const std::vector<Vector2d>& expected) {
  ASSERT_EQ(found.nodes.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    expect_node(*robot, found.nodes[i]);
    EXPECT_LT((found.nodes[i].actuated.tail<2>() - expected[i]).norm(), 1e-9);
  }
}

// These and those of the next test are by exact arithmetic: double zeros of the discriminant of the curve
// that is the image of det A = 0 over squared lengths. Arcs beside two of the cusps come close to each other.
TEST(NodeSearch, ProvesThatThereAreNoOthersBetweenArcsOfACusp) {
  const Robot robot =
      test::manipulator("three_rpr_with_close_arcs", TaskSpace::SE2,
                        test::struts({{0.2, -0.2, 0.0}, {-0.3, -1.3, 0.0}, {1.9, -0.9, 0.0}},
                                     {{1.3, -1.0, 0.0}, {-1.6, -1.0, 0.0}, {-1.0, -0.4, 0.0}}));
  const auto found = uniqueness_of_slice(robot, 2.4);
  EXPECT_TRUE(found->nodes_complete);
  expect_nodes(robot, *found,
               {{0.6488831180, 2.1547988256},
                {0.7051251317, 2.3755468329},
                {0.7946282628, 2.2775981157},
                {0.9176344425, 2.3861801767},
                {1.2706506512, 1.6579916363},
                {1.6818033035, 0.9476515216},
                {2.5799228260, 0.2864198141}});
}

// In one place bounds do not tell arcs apart, and it is not proved that there are no other nodes; but those
// of all other places are listed.
TEST(NodeSearch, ListsThoseBesideAPlaceThatIsNotDecided) {
  const Robot robot = test::manipulator("three_rpr_with_closer_arcs", TaskSpace::SE2,
                                        test::struts({{0.8, -1.6, 0.0}, {1.2, -1.8, 0.0}, {-0.5, -0.6, 0.0}},
                                                     {{1.9, 1.9, 0.0}, {-0.4, -1.5, 0.0}, {1.7, -0.6, 0.0}}));
  expect_nodes(robot, *uniqueness_of_slice(robot, 2.5),
               {{1.9114972471, 1.6053818940},
                {1.9540105805, 1.7642137342},
                {2.3138985305, 2.1429367023},
                {2.3978538006, 1.6295721549},
                {3.0588987681, 1.2744986696}});
}

TEST(NodeSearch, ListsNodesWithinLimits) {
  const auto all = uniqueness_of_slice(test::three_rpr()->with_constraints({}), 14.98);
  const auto within = uniqueness_of_slice(test::three_rpr(), 14.98);
  EXPECT_TRUE(within->nodes_complete);
  std::size_t expected = 0;
  for (const SolutionNode& node : all->nodes) {
    bool is_within = true;
    for (std::size_t j = 0; j < 3; ++j)
      is_within = is_within && test::three_rpr()->leg(j).limits.contain(node.actuated[static_cast<int>(j)]);
    expected += is_within ? 1 : 0;
  }
  EXPECT_EQ(within->nodes.size(), expected);
  EXPECT_LT(within->nodes.size(), all->nodes.size());
}

}  // namespace
}  // namespace parallel_aspects
