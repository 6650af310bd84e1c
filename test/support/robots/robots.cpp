// SPDX-License-Identifier: BSD-3-Clause
#include "support/robots/robots.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <utility>
#include <variant>

namespace parallel_aspects::test {

Leg named_leg(std::size_t index) {
  Leg leg;
  leg.name = "leg_" + std::to_string(index + 1);
  leg.actuated_joint = leg.name + "_joint";
  return leg;
}

std::shared_ptr<const Manipulator> manipulator(const std::string& name, TaskSpace space,
                                               std::vector<Leg> legs, const HingePair& hinges) {
  ManipulatorDescription description;
  description.name = name;
  description.task_space = space;
  description.legs = std::move(legs);
  description.hinges = hinges;
  return std::make_shared<const Manipulator>(description);
}

Leg planar_revolute_leg(std::size_t index, const Eigen::Vector2d& center, double crank, double rod,
                        const Eigen::Vector2d& anchor) {
  Leg leg = named_leg(index);
  leg.actuation = RevoluteActuation{
      {center.x(), center.y(), 0.0}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(), crank};
  leg.rod_length = rod;
  leg.anchor << anchor, 0.0;
  return leg;
}

std::vector<Leg> struts(const Points& base, const Points& anchors) {
  std::vector<Leg> legs;
  for (std::size_t j = 0; j < base.size(); ++j) {
    legs.push_back(named_leg(j));
    legs[j].actuation = StrutActuation{base[j]};
    legs[j].anchor = anchors[j];
  }
  return legs;
}

Points on_circle(double radius, const std::vector<double>& degrees) {
  Points points;
  for (const double each : degrees) {
    const double angle = each * EIGEN_PI / 180.0;
    points.push_back(radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0));
  }
  return points;
}

std::shared_ptr<const Manipulator> five_bar() {
  return manipulator(
      "five_bar", TaskSpace::T2,
      {planar_revolute_leg(0, {0.0, 0.0}, 8.0, 5.0), planar_revolute_leg(1, {9.0, 0.0}, 5.0, 8.0)});
}

std::shared_ptr<const Manipulator> four_bar(double rocker, double base, double crank, double rod) {
  return manipulator("four_bar", TaskSpace::R1,
                     {planar_revolute_leg(0, {base, 0.0}, crank, rod, {rocker, 0.0})});
}

std::shared_ptr<const Manipulator> turned_about_first_hinge(const Manipulator& robot, double angle) {
  ManipulatorDescription description = robot.description();
  const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitZ());
  for (Leg& leg : description.legs) {
    auto& crank = std::get<RevoluteActuation>(leg.actuation);
    crank.center = turn * crank.center;
    crank.axis = turn * crank.axis;
    crank.zero_direction = turn * crank.zero_direction;
  }
  return std::make_shared<const Manipulator>(description);
}

std::shared_ptr<const Manipulator> ankle() {
  using Eigen::Vector3d;
  const HingePair hinges{0.016, 0.5 * EIGEN_PI};
  Eigen::Isometry3d task = Eigen::Isometry3d::Identity();
  task.linear() << -Vector3d::UnitZ(), -Vector3d::UnitX(), Vector3d::UnitY();
  const Pose zero = pose_from_coordinates({TaskSpace::R2, hinges}, Eigen::Vector2d::Zero()).value();
  const Eigen::Isometry3d foot = task * (Eigen::Translation3d(zero.position) * zero.orientation);
  const Vector3d below(0.0, 0.0, -0.016);
  std::vector<Leg> legs;
  for (const double side : {1.0, -1.0}) {
    Leg leg = named_leg(legs.size());
    const Vector3d pivot(-0.005, 0.032 * side, side > 0.0 ? 0.205 : 0.135);
    leg.actuation = RevoluteActuation{task.inverse() * pivot, task.linear().transpose() * -Vector3d::UnitY(),
                                      task.linear().transpose() * Vector3d::UnitX(), 0.024};
    leg.anchor = foot.inverse() * (below + Vector3d(-0.048, 0.026 * side, 0.010));
    leg.rod_length = side > 0.0 ? 0.2119 : 0.1424;
    legs.push_back(leg);
  }
  ManipulatorDescription description;
  description.name = "ankle";
  description.task_space = TaskSpace::R2;
  description.legs = legs;
  description.task_frame = task;
  description.hinges = hinges;
  return std::make_shared<const Manipulator>(description);
}

std::shared_ptr<const Manipulator> limited_five_bar() {
  ManipulatorDescription description{"limited_five_bar", TaskSpace::T2, five_bar()->legs(), "base", {}};
  description.task_frame.setIdentity();
  description.legs[0].limits = {-1.0, 1.5};
  description.legs[1].limits = {0.5, 5.5};
  return std::make_shared<const Manipulator>(description);
}

std::shared_ptr<const Manipulator> bipod() {
  std::vector<Leg> legs = struts({{0.0, 0.0, 0.0}, {5.0, 0.0, 0.0}}, Points(2, Eigen::Vector3d::Zero()));
  legs[0].limits = JointLimits{2.0, 6.0};
  legs[1].limits = JointLimits{4.0, 9.0};
  return manipulator("bipod", TaskSpace::T2, std::move(legs));
}

std::shared_ptr<const Manipulator> three_rpr() {
  const double angle = 0.88260311;
  std::vector<Leg> legs =
      struts({{0.0, 0.0, 0.0}, {15.91, 0.0, 0.0}, {0.0, 10.0, 0.0}},
             {{0.0, 0.0, 0.0}, {17.04, 0.0, 0.0}, {20.84 * std::cos(angle), 20.84 * std::sin(angle), 0.0}});
  for (Leg& leg : legs) leg.limits = JointLimits{10.0, 32.0};
  return manipulator("three_rpr", TaskSpace::SE2, std::move(legs));
}

std::shared_ptr<const Manipulator> three_rrr() {
  return manipulator("three_rrr", TaskSpace::SE2,
                     {planar_revolute_leg(0, {-10.0, -10.0}, 10.0, 10.0, {0.0, 0.0}),
                      planar_revolute_leg(1, {10.0, -10.0}, 10.0, 10.0, {10.0, 0.0}),
                      planar_revolute_leg(2, {0.0, 10.0}, 10.0, 10.0, {10.0, 10.0})});
}

std::shared_ptr<const Manipulator> three_rrr_actuated_elbow() {
  const Points base{{-10.0, -10.0, 0.0}, {10.0, -10.0, 0.0}, {0.0, 10.0, 0.0}};
  std::vector<Leg> legs = struts(base, {{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, {10.0, 10.0, 0.0}});
  for (std::size_t j = 0; j < 3; ++j)
    legs[j].actuation = ElbowActuation{base[j], 10.0, 8.0, 0.3, j == 1 ? -1.0 : 1.0};
  return manipulator("three_rrr_actuated_elbow", TaskSpace::SE2, std::move(legs));
}

std::shared_ptr<const Manipulator> three_prr() {
  const Points base = on_circle(1.0, {-90.0, 30.0, 150.0}), directions = on_circle(1.0, {0.0, 120.0, 240.0});
  std::vector<Leg> legs = struts(base, on_circle(0.3, {-90.0, 30.0, 150.0}));
  for (std::size_t j = 0; j < 3; ++j) {
    legs[j].actuation = PrismaticActuation{base[j], directions[j]};
    legs[j].rod_length = 0.9;
  }
  return manipulator("three_prr", TaskSpace::SE2, std::move(legs));
}

RevoluteActuation radial_crank(const Eigen::Vector3d& center, double degrees, double length) {
  return {center, on_circle(1.0, {degrees + 90.0})[0], on_circle(1.0, {degrees})[0], length};
}

std::shared_ptr<const Manipulator> delta() {
  const std::vector<double> degrees{0.0, 120.0, 240.0};
  const Points base = on_circle(0.200, degrees);
  std::vector<Leg> legs = struts(base, on_circle(0.045, degrees));
  for (std::size_t j = 0; j < 3; ++j) {
    legs[j].actuation = radial_crank(base[j], degrees[j], 0.235);
    legs[j].rod_length = 0.800;
  }
  return manipulator("delta", TaskSpace::T3, std::move(legs));
}

std::shared_ptr<const Manipulator> linear_delta() {
  const std::vector<double> degrees{90.0, 210.0, 330.0};
  const Points base = on_circle(0.180, degrees);
  std::vector<Leg> legs = struts(base, on_circle(0.030, degrees));
  for (std::size_t j = 0; j < 3; ++j) {
    legs[j].actuation = PrismaticActuation{base[j], Eigen::Vector3d::UnitZ()};
    legs[j].rod_length = 0.300;
  }
  return manipulator("linear_delta", TaskSpace::T3, std::move(legs));
}

Leg spherical_leg(std::size_t index, const Eigen::Vector3d& axis, const Eigen::Vector3d& zero_direction,
                  const Eigen::Vector3d& platform_axis, double alpha1, double alpha2) {
  Leg leg = named_leg(index);
  leg.actuation = RevoluteActuation{std::cos(alpha1) * axis, axis, zero_direction, std::sin(alpha1)};
  leg.rod_length = 2.0 * std::sin(0.5 * alpha2);
  leg.anchor = platform_axis;
  return leg;
}

std::shared_ptr<const Manipulator> agile_eye() {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  const double right_angle = 0.5 * EIGEN_PI;
  std::vector<Leg> legs{spherical_leg(0, x, z, -y, right_angle, right_angle),
                        spherical_leg(1, y, x, -z, right_angle, right_angle),
                        spherical_leg(2, z, y, -x, right_angle, right_angle)};
  for (Leg& leg : legs) std::get<RevoluteActuation>(leg.actuation).center.setZero();
  return manipulator("agile_eye", TaskSpace::SO3, std::move(legs));
}

std::shared_ptr<const Manipulator> spherical_three_rrr() {
  const Points axes{{0.8, 0.1, 0.6}, {-0.5, 0.7, 0.5}, {-0.3, -0.8, 0.4}};
  const Points platform{{0.7, 0.2, -0.5}, {-0.4, 0.8, -0.3}, {-0.2, -0.7, -0.6}};
  const std::array<double, 3> alpha1{1.1, 1.3, 0.9}, alpha2{1.4, 1.2, 1.5};
  std::vector<Leg> legs;
  for (std::size_t j = 0; j < 3; ++j) {
    const Eigen::Vector3d axis = axes[j].normalized();
    legs.push_back(
        spherical_leg(j, axis, axis.unitOrthogonal(), platform[j].normalized(), alpha1[j], alpha2[j]));
  }
  return manipulator("spherical_three_rrr", TaskSpace::SO3, std::move(legs));
}

std::shared_ptr<const Manipulator> dietmaier() {
  return manipulator("dietmaier", TaskSpace::SE3,
                     struts({{0.0, 0.0, 0.0},
                             {1.107915, 0.0, 0.0},
                             {0.549094, 0.756063, 0.0},
                             {0.735077, -0.223935, 0.525991},
                             {0.514188, -0.526063, -0.368418},
                             {0.590473, 0.094733, -0.205018}},
                            {{0.0, 0.0, 0.0},
                             {0.542805, 0.0, 0.0},
                             {0.956919, -0.528915, 0.0},
                             {0.665885, -0.353482, 1.402538},
                             {0.478359, 1.158742, 0.107672},
                             {-0.137087, -0.235121, 0.353913}}));
}

JointVector dietmaier_lengths() {
  JointVector q(6);
  q << 1.0, 0.645275, 1.086284, 1.503439, 1.281933, 0.771071;
  return q;
}

std::shared_ptr<const Manipulator> stewart() {
  return manipulator("stewart", TaskSpace::SE3,
                     struts(on_circle(0.50, {-10.0, 10.0, 110.0, 130.0, 230.0, 250.0}),
                            on_circle(0.30, {-50.0, 50.0, 70.0, 170.0, 190.0, 290.0})));
}

std::shared_ptr<const Manipulator> planar_stewart() {
  return manipulator("planar_stewart", TaskSpace::SE3,
                     struts({{0.50, 0.02, 0.0},
                             {0.40, 0.31, 0.0},
                             {-0.22, 0.47, 0.0},
                             {-0.44, 0.20, 0.0},
                             {-0.31, -0.36, 0.0},
                             {0.27, -0.41, 0.0}},
                            {{0.21, -0.17, 0.0},
                             {0.16, 0.25, 0.0},
                             {0.05, 0.31, 0.0},
                             {-0.29, 0.07, 0.0},
                             {-0.27, -0.03, 0.0},
                             {0.06, -0.33, 0.0}}));
}

std::shared_ptr<const Manipulator> octahedral_stewart() {
  return manipulator("octahedral_stewart", TaskSpace::SE3,
                     struts(on_circle(0.50, {0.0, 0.0, 120.0, 120.0, 240.0, 240.0}),
                            on_circle(0.30, {-60.0, 60.0, 60.0, 180.0, 180.0, 300.0})));
}

std::shared_ptr<const Manipulator> hexa() {
  const std::vector<double> sides{0.0, 0.0, 120.0, 120.0, 240.0, 240.0};
  const Points base = on_circle(0.26, {-20.0, 20.0, 100.0, 140.0, 220.0, 260.0});
  std::vector<Leg> legs = struts(base, on_circle(0.10, {-40.0, 40.0, 80.0, 160.0, 200.0, 280.0}));
  for (std::size_t j = 0; j < 6; ++j) {
    legs[j].actuation = radial_crank(base[j], sides[j], 0.25);
    legs[j].rod_length = 0.60;
  }
  return manipulator("hexa", TaskSpace::SE3, std::move(legs));
}

std::shared_ptr<const Manipulator> six_pus() {
  const Points base = on_circle(0.50, {-10.0, 10.0, 110.0, 130.0, 230.0, 250.0});
  std::vector<Leg> legs = struts(base, on_circle(0.15, {-40.0, 40.0, 80.0, 160.0, 200.0, 280.0}));
  for (std::size_t j = 0; j < 6; ++j) {
    legs[j].actuation = PrismaticActuation{base[j], Eigen::Vector3d::UnitZ()};
    legs[j].rod_length = 0.80;
  }
  return manipulator("six_pus", TaskSpace::SE3, std::move(legs));
}

}  // namespace parallel_aspects::test
