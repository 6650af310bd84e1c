// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/wedge_proof.h"

#include "aspects/boxes/box_classifier.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/robots.h"
#include <cmath>
#include <optional>
#include <random>
#include <set>

namespace parallel_aspects {
namespace {

// A leg of the five-bar is stretched or folded on a circle about its base point.
struct Circle {
  double x, radius;
  bool outer;
};
constexpr Circle circles[] = {{0.0, 13.0, true}, {0.0, 3.0, false}, {9.0, 13.0, true}, {9.0, 3.0, false}};

Pose at(const MapPoint& point) {
  Pose pose;
  pose.position << point[0], point[1], 0.0;
  return pose;
}

MapPoint on(const Circle& circle, double angle, double depth) {
  const double radius = circle.radius + (circle.outer ? -depth : depth);
  return {circle.x + radius * std::cos(angle), radius * std::sin(angle)};
}

class WedgeProofTest : public testing::Test {
 protected:
  int sign_at(const MapPoint& point, const WorkingMode& mode) const {
    return test::sign_in_doubles(*robot, at(point), mode);
  }

  // An angle where det A changes its sign along the circle: there det A = 0 touches it.
  std::optional<double> tip(const Circle& circle, double angle, const WorkingMode& mode) const {
    double before = angle, after = angle + 0.1;
    const auto sign = [&](double each) { return sign_at(on(circle, each, 1e-9), mode); };
    if (sign(before) * sign(after) >= 0) return std::nullopt;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (before + after);
      (sign(middle) == sign(before) ? before : after) = middle;
    }
    return before;
  }

  template <class Visit>
  void visit_tips(const Visit& visit) const {
    for (std::size_t mode = 0; mode < modes.size(); ++mode)
      for (const Circle& circle : circles)
        for (double angle = 0.0; angle < 6.28; angle += 0.1)
          if (const auto found = tip(circle, angle, modes[mode])) visit(mode, on(circle, *found, 0.0));
  }

  std::optional<MapPoint> find_wedge(const Box& box, std::size_t mode, int sign) const {
    const RoundingUpward rounding;
    return classifier->find_wedge(0, box, mode, sign);
  }

  Box box_about(const MapPoint& point) {
    const double size = std::pow(10.0, uniform(-6.0, -2.5));
    const MapPoint center{point[0] + size * uniform(-0.5, 0.5), point[1] + size * uniform(-0.5, 0.5)};
    return {2, {center[0] - size, center[1] - size}, {center[0] + size, center[1] + size}};
  }

  MapPoint inside(const Box& box) {
    return {uniform(box.lower[0], box.upper[0]), uniform(box.lower[1], box.upper[1])};
  }

  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(random);
  }

  std::shared_ptr<const Manipulator> robot = test::five_bar();
  std::vector<WorkingMode> modes = working_modes(*robot);
  std::unique_ptr<const BoxClassifier> classifier = make_box_classifier(*robot, modes);
  std::mt19937_64 random{20261121};
};

TEST_F(WedgeProofTest, IsFoundAtEveryTip) {
  int tips = 0, found = 0;
  visit_tips([&](std::size_t mode, const MapPoint& tip) {
    for (const int sign : {1, -1}) {
      ++tips;
      const Box box{2, {tip[0] - 1e-5, tip[1] - 2e-5}, {tip[0] + 2e-5, tip[1] + 1e-5}};
      const auto pose = find_wedge(box, mode, sign);
      found += pose.has_value();
      EXPECT_TRUE(!pose || sign_at(*pose, modes[mode]) == sign) << tip[0] << ' ' << tip[1];
    }
  });
  EXPECT_GE(tips, 2 * 4 * 4);
  EXPECT_EQ(found, tips);
}

// Random poses of the set in a box with a proof, whose aspects the map knows from leaves near by, are all in
// one, and so is the pose that the proof names.
TEST_F(WedgeProofTest, AllOfTheSetInTheBoxIsInOneAspect) {
  const auto map = compute_aspect_map(robot).map;
  int proofs = 0, compared = 0;
  visit_tips([&](std::size_t mode, const MapPoint& tip) {
    for (int i = 0; i < 10; ++i) {
      const Box box = box_about(tip);
      const int sign = i % 2 == 0 ? 1 : -1;
      const auto pose = find_wedge(box, mode, sign);
      if (!pose) continue;
      ++proofs;
      std::set<int> aspects;
      const auto look_at = [&](const MapPoint& point) {
        const Location location = map->locate(at(point), modes[mode]);
        if (location.status == LocationStatus::inside && sign_at(point, modes[mode]) == sign)
          aspects.insert(location.aspect);
      };
      look_at(*pose);
      for (int k = 0; k < 200; ++k) look_at(inside(box));
      compared += !aspects.empty();
      EXPECT_LE(aspects.size(), 1U) << "box {" << box.lower[0] << ", " << box.lower[1] << "} to {"
                                    << box.upper[0] << ", " << box.upper[1] << "} in "
                                    << to_string(modes[mode]);
    }
  });
  EXPECT_GT(proofs, 100);
  EXPECT_GT(compared, proofs / 2);
}

// Away from tips, where several legs or none are at a serial singularity, nothing is claimed.
TEST_F(WedgeProofTest, IsNotFoundWithoutASerialSingularity) {
  EXPECT_FALSE(find_wedge({2, {4.4, 7.9}, {4.6, 8.1}}, 0, 1));
  EXPECT_FALSE(find_wedge({2, {-20.0, -20.0}, {20.0, 20.0}}, 0, 1));
  EXPECT_FALSE(find_wedge({2, {30.0, 30.0}, {31.0, 31.0}}, 0, 1));
}

}  // namespace
}  // namespace parallel_aspects
