// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/cusp_trace.h"
#include "aspects/cusps/cusp_tube.h"
#include "aspects/uniqueness/curve_runs.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/slices.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::Robot;
using test::uniform;

/// The cusps of one slice, isolated in two coordinates.
CuspList cusps_at(const Robot& robot, std::size_t leg, double held) {
  return find_cusps(*robot, HeldJoint{leg, held});
}

const CuspCount* count_at(const CuspCurves& found, double held) {
  const auto at = std::find_if(found.counts.begin(), found.counts.end(),
                               [&](const CuspCount& each) { return each.lower < held && held < each.upper; });
  return at == found.counts.end() ? nullptr : &*at;
}

std::size_t count_of(const CuspCurves& found, CuspEventKind kind) {
  std::size_t count = 0;
  for (const CuspCurve& curve : found.curves)
    count +=
        static_cast<std::size_t>(std::count_if(curve.events.begin(), curve.events.end(),
                                               [&](const CuspEvent& event) { return event.kind == kind; }));
  return count;
}

/// Everywhere the slices say the same of the numbers of cusps.
int compare_counts(const Robot& robot, const CuspCurves& found, int values, std::mt19937_64& random) {
  int compared = 0;
  for (int i = 0; i < values; ++i) {
    const double held = uniform(random, found.range.lower, found.range.upper);
    const CuspCount* const count = count_at(found, held);
    const CuspList list = cusps_at(robot, found.range.leg, held);
    if (count == nullptr || !list.complete) continue;
    EXPECT_EQ(list.cusps.size(), count->cusps) << robot->name() << ", held at " << held;
    ++compared;
  }
  return compared;
}

/// Each point of a curve is a cusp of its slice.
void expect_points_are_cusps(const Robot& robot, const CuspCurves& found, std::size_t step) {
  for (const CuspCurve& curve : found.curves)
    for (std::size_t i = 0; i < curve.points.size(); i += step) {
      const Cusp& point = curve.points[i];
      const double held = point.actuated[static_cast<Eigen::Index>(found.range.leg)];
      const CuspList list = cusps_at(robot, found.range.leg, held);
      const auto is_it = [&](const Cusp& cusp) {
        return cusp.mode == point.mode && (cusp.actuated - point.actuated).norm() < 1e-5 &&
               (cusp.pose.position - point.pose.position).norm() < 1e-5;
      };
      EXPECT_TRUE(std::any_of(list.cusps.begin(), list.cusps.end(), is_it))
          << robot->name() << ", held at " << held << ": " << point.actuated.transpose();
    }
}

TEST(CuspCurves, OfTheThreeRprAreComplete) {
  const Robot robot = test::three_rpr();
  const CuspCurves found = find_cusp_curves(*robot, {0, 10.0, 32.0});
  EXPECT_TRUE(found.complete);
  EXPECT_EQ(found.curves.size(), 7U);
  EXPECT_EQ(count_of(found, CuspEventKind::turn), 1U);
  EXPECT_EQ(count_of(found, CuspEventKind::limit), 8U);
  EXPECT_EQ(count_of(found, CuspEventKind::unknown), 0U);
  std::mt19937_64 random(1);
  EXPECT_EQ(compare_counts(robot, found, 100, random), 100);
  expect_points_are_cusps(robot, found, 17);
}

// The number changes at the turn, and slices on both sides of it are proved to show that.
TEST(CuspCurves, ChangeTheirNumberWhereTheyTurn) {
  const Robot robot = test::three_rpr();
  const CuspCurves found = find_cusp_curves(*robot, {0, 26.0, 26.8});
  ASSERT_EQ(count_of(found, CuspEventKind::turn), 1U);
  for (const CuspCurve& curve : found.curves)
    for (const CuspEvent& event : curve.events) {
      if (event.kind != CuspEventKind::turn) continue;
      EXPECT_LT(event.upper - event.lower, 1e-9);
      EXPECT_EQ(cusps_at(robot, 0, event.lower - 1e-4).cusps.size(), 2U);
      EXPECT_EQ(cusps_at(robot, 0, event.upper + 1e-4).cusps.size(), 4U);
    }
}

/// Where a curve has this held value, between its points, by a straight line.
std::vector<Eigen::VectorXd> places_at(const CuspCurve& curve, double held) {
  std::vector<Eigen::VectorXd> result;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const JointVector &a = curve.points[i].actuated, &b = curve.points[i + 1].actuated;
    if ((a[0] - held) * (b[0] - held) > 0.0) continue;
    result.emplace_back(a + (held - a[0]) / (b[0] - a[0]) * (b - a));
  }
  return result;
}

// Six cusps without limits, found by Newton's method in double precision.
TEST(CuspCurves, PassTheSixOfOneSlice) {
  const Robot robot = test::three_rpr()->with_constraints({});
  const CuspCurves found = find_cusp_curves(*robot, {0, 14.9, 15.1});
  const std::vector<Eigen::Vector2d> expected{{13.85146, 6.26010},  {0.84528, 3.77792},
                                              {17.98855, 26.44618}, {16.02767, 29.56671},
                                              {31.27613, 16.17845}, {30.44913, 26.61916}};
  EXPECT_TRUE(found.complete);
  std::vector<Eigen::VectorXd> places;
  for (const CuspCurve& curve : found.curves)
    for (const Eigen::VectorXd& place : places_at(curve, 14.98)) places.push_back(place);
  EXPECT_EQ(places.size(), expected.size());
  for (const Eigen::Vector2d& each : expected)
    EXPECT_TRUE(std::any_of(places.begin(), places.end(), [&](const Eigen::VectorXd& place) {
      return (place.tail<2>() - each).norm() < 2e-3;
    })) << each.transpose();
}

/// The most direct solutions near a pose, for actuated values about those of a cusp, the held one as it is.
std::size_t most_solutions_beside(const Robot& robot, const Cusp& cusp, double radius) {
  std::size_t most = 0;
  for (int i = 0; i < 1800 && most < 3; ++i) {
    JointVector q = cusp.actuated;
    q[1] += radius * std::cos(test::pi * i / 900.0);
    q[2] += radius * std::sin(test::pi * i / 900.0);
    std::size_t near = 0;
    for (const AssemblyMode& mode : direct(*robot, q).solutions)
      if ((mode.pose.position - cusp.pose.position).norm() < 3.0) ++near;
    most = std::max(most, near);
  }
  return most;
}

// By the complete direct solver.
TEST(CuspCurves, HaveThreeSolutionsBesideThem) {
  const Robot robot = test::three_rpr()->with_constraints({});
  const CuspCurves found = find_cusp_curves(*robot, {0, 14.0, 16.0});
  ASSERT_FALSE(found.curves.empty());
  for (const CuspCurve& curve : found.curves) {
    const Cusp& middle = curve.points[curve.points.size() / 2];
    EXPECT_GE(
        std::max(most_solutions_beside(robot, middle, 1e-3), most_solutions_beside(robot, middle, 1e-2)), 3U)
        << middle.actuated.transpose();
  }
}

// A curve from a cusp of the lower slice comes to one of the upper.
TEST(CuspCurves, BeginAndEndAtCuspsOfTheEndsOfTheRange) {
  const Robot robot = test::three_rpr()->with_constraints({});
  const CuspCurves found = find_cusp_curves(*robot, {1, 12.0, 13.0});
  EXPECT_TRUE(found.complete);
  std::size_t lower = 0, upper = 0;
  for (const CuspCurve& curve : found.curves)
    for (const CuspEvent& event : curve.events) {
      if (event.kind != CuspEventKind::range_end) continue;
      lower += event.lower <= 12.0 ? 1 : 0;
      upper += event.upper >= 13.0 ? 1 : 0;
    }
  EXPECT_EQ(lower, cusps_at(robot, 1, 12.0).cusps.size());
  EXPECT_EQ(upper, cusps_at(robot, 1, 13.0).cusps.size());
}

/// A short range about the value that a random pose has.
HeldRange range_about_pose(const Robot& robot, double width, std::mt19937_64& random) {
  for (;;) {
    const Pose pose = Pose::planar(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0),
                                   uniform(random, -test::pi, test::pi));
    const auto modes = working_modes(*robot);
    const InverseSolution found = inverse(*robot, pose, modes[random() % modes.size()]);
    if (found) return {0, found.q[0] - 0.5 * width, found.q[0] + 0.5 * width};
  }
}

// What is claimed agrees with slices.
TEST(CuspCurves, AgreeWithSlicesOfRandomRobots) {
  std::mt19937_64 random(7);
  test::RandomRobots robots(11);
  int compared = 0;
  for (const test::ActuationKind kind : {test::ActuationKind::strut, test::ActuationKind::strut,
                                         test::ActuationKind::revolute, test::ActuationKind::revolute}) {
    const Robot robot = robots.robot(TaskSpace::SE2, kind)->with_constraints({});
    const double width = kind == test::ActuationKind::strut ? 0.05 : 0.002;
    const CuspCurves found = find_cusp_curves(*robot, range_about_pose(robot, width, random));
    EXPECT_TRUE(found.complete || kind == test::ActuationKind::revolute);
    compared += compare_counts(robot, found, 12, random);
    expect_points_are_cusps(robot, found, 23);
  }
  EXPECT_GT(compared, 30);
}

/// The curve through a cusp of one slice, all of it.
std::optional<CuspTrace> trace_through(const Robot& robot, const Cusp& cusp, const Interval& range) {
  const MapSlice slice = test::slice_of(robot, {{robot->leg(0).actuated_joint, cusp.actuated[0]}});
  const Eigen::Vector2d rod = circle_of_anchor(*robot, *slice.joint).rod(cusp.pose);
  const RoundingUpward rounding;
  const PlanarHeldSlice held(*robot, *slice.joint);
  SliceFamily family(held, held.postures().front());
  const auto& turn = cusp.pose.orientation;
  const MapPoint at{std::atan2(rod.y(), rod.x()) / test::pi,
                    std::remainder(2.0 * std::atan2(turn.z(), turn.w()), 2.0 * test::pi) / test::pi,
                    cusp.actuated[0] / test::pi};
  const auto start = cusp_near(family, 2, at);
  if (!start) return std::nullopt;
  return trace_cusps(family, *start,
                     {range.lower() / test::pi, range.upper() / test::pi, {1.0, 1.0, test::pi / 20.0}}, {},
                     {});
}

/// Each tube begins and ends at points that it holds.
void expect_chain(const CuspTrace& trace) {
  const RoundingUpward rounding;
  const std::size_t count = trace.points.size();
  EXPECT_EQ(trace.tubes.size(), trace.closed ? count : count - 1);
  for (std::size_t i = 0; i < trace.tubes.size(); ++i) {
    EXPECT_TRUE(contains(trace.tubes[i], trace.points[i]));
    EXPECT_TRUE(contains(trace.tubes[i], trace.points[(i + 1) % count]));
  }
}

CurveRuns runs_of_trace(const Robot& robot, const CuspTrace& trace, double lower, double upper) {
  const MapSlice slice = test::slice_of(robot, {{robot->leg(0).actuated_joint, 0.5 * (lower + upper)}});
  const RoundingUpward rounding;
  const PlanarHeldSlice held(*robot, *slice.joint);
  SliceFamily family(held, held.postures().front());
  return runs_of(family, trace, {lower / test::pi, upper / test::pi});
}

// Of ten cusps in one slice some are on a curve that comes back to its start, which passes each value as
// often up as down: so an even number of them.
TEST(CuspTrace, ClosesCurves) {
  const Robot robot = test::three_rpr()->with_constraints({});
  const CuspList list = cusps_at(robot, 0, 28.1);
  ASSERT_EQ(list.cusps.size(), 10U);
  std::size_t closed = 0;
  for (const Cusp& cusp : list.cusps) {
    const auto trace = trace_through(robot, cusp, {1.0, 60.0});
    ASSERT_TRUE(trace);
    expect_chain(*trace);
    if (!trace->closed) continue;
    if (++closed > 1) continue;
    const CurveRuns runs = runs_of_trace(robot, *trace, 1.0, 60.0);
    ASSERT_EQ(runs.runs.size(), 1U);
    EXPECT_TRUE(runs.runs.front().closed);
    EXPECT_EQ(runs.runs.front().events.size(), 8U);
    for (const CuspEvent& event : runs.runs.front().events) EXPECT_EQ(event.kind, CuspEventKind::turn);
  }
  EXPECT_GT(closed, 0U);
  EXPECT_EQ(closed % 2, 0U);
}

// By differences of values over the family, all gradients, that by the held value among them.
TEST(SliceFamily, HasTheGradientsOfItsFunctions) {
  std::mt19937_64 random(3);
  test::RandomRobots robots(5);
  int compared = 0;
  for (const test::ActuationKind kind :
       {test::ActuationKind::strut, test::ActuationKind::revolute, test::ActuationKind::prismatic})
    for (int i = 0; i < 10; ++i) {
      const Robot robot = robots.robot(TaskSpace::SE2, kind)->with_constraints({});
      const double held = range_about_pose(robot, 0.0, random).lower;
      const MapSlice slice = test::slice_of(robot, {{robot->leg(0).actuated_joint, held}});
      const RoundingUpward rounding;
      const PlanarHeldSlice held_slice(*robot, *slice.joint);
      SliceFamily family(held_slice, held_slice.postures().back());
      const MapPoint at{uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0), held / test::pi};
      const auto found = family.at(at);
      for (std::size_t k = 0; found && k < 3; ++k) {
        constexpr double step = 1e-6;
        MapPoint lower = at, upper = at;
        lower[k] -= step;
        upper[k] += step;
        const auto below = family.at(lower), above = family.at(upper);
        if (!below || !above) continue;
        for (std::size_t n = 0; n < 3; ++n) {
          const double slope =
              (above->values[n].lower() - below->values[n].lower()) / (2.0 * test::pi * step);
          const double claimed = found->gradients[n][k].lower();
          EXPECT_NEAR(claimed, slope, 1e-4 * (1.0 + std::abs(slope))) << robot->name() << n << k;
          ++compared;
        }
      }
    }
  EXPECT_GT(compared, 90);
}

TEST(CuspCurves, AreRefusedWithAReason) {
  const Robot robot = test::three_rpr();
  EXPECT_EQ(find_held_range_problem(*robot, {0, 10.0, 32.0}), "");
  for (const HeldRange& range : {HeldRange{0, 9.0, 20.0}, HeldRange{0, 20.0, 12.0}, HeldRange{3, 12.0, 20.0},
                                 HeldRange{0, 12.0, std::nan("")}})
    EXPECT_NE(find_held_range_problem(*robot, range), "");
  EXPECT_NE(find_held_range_problem(*test::bipod(), {0, 0.0, 1.0}), "");
}

TEST(CuspCurves, AreNotCompleteWhenCancelled) {
  const std::atomic<bool> cancelled{true};
  MapControl control;
  control.cancelled = &cancelled;
  const CuspCurves found = find_cusp_curves(*test::three_rpr(), {0, 10.0, 32.0}, control);
  EXPECT_FALSE(found.complete);
  EXPECT_TRUE(found.counts.empty());
}

// Boxes that touch a serial singularity are nowhere decided there.
TEST(CuspCurves, ProgressGoesOnWhereHardlyAnythingIsDecided) {
  const auto robot = test::shipped("three_rrr")->mapped_manipulator();
  constexpr std::size_t most_told = 40;
  std::vector<double> shares;
  std::atomic<bool> cancelled{false};
  MapControl control;
  control.cancelled = &cancelled;
  control.progress = [&](double share) {
    if (shares.size() < most_told) shares.push_back(share);
    cancelled = shares.size() == most_told;
  };
  find_cusp_curves(*robot, {0, -3.1, 3.1}, control);
  ASSERT_EQ(shares.size(), most_told);
  EXPECT_EQ(std::adjacent_find(shares.begin(), shares.end(), std::greater_equal<>()), shares.end());
}

}  // namespace
}  // namespace parallel_aspects
