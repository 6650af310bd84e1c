// SPDX-License-Identifier: BSD-3-Clause
#include "arms/inverse_candidates.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace parallel_aspects {
namespace {

constexpr double nearly = 1e-7;  // relative: solutions that are lost by rounding at their boundary

double angle_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x());
}

// Angles after Denavit and Hartenberg become joint values.
Eigen::VectorXd joint_values(const std::vector<LinkNumbers>& links, std::initializer_list<double> angles) {
  Eigen::VectorXd q(static_cast<Eigen::Index>(angles.size()));
  Eigen::Index i = 0;
  for (const double angle : angles) {
    q[i] = angle - links[static_cast<std::size_t>(i)].turn;
    ++i;
  }
  return q;
}

// A trigonometric polynomial of degree 2 in an angle, by its values at five of them.
struct SecondDegree {
  std::array<double, 5> by{};  // 1, cos, sin, cos of twice, sin of twice

  explicit SecondDegree(const std::function<double(double)>& function) {
    for (int k = 0; k < 5; ++k) {
      const double angle = 2.0 * half_turn * k / 5.0, value = function(angle) / 5.0;
      by[0] += value;
      by[1] += 2.0 * value * std::cos(angle);
      by[2] += 2.0 * value * std::sin(angle);
      by[3] += 2.0 * value * std::cos(2.0 * angle);
      by[4] += 2.0 * value * std::sin(2.0 * angle);
    }
  }

  // Angles of its zeros z = exp(i angle) near the unit circle: of z^2 p(z), of degree 4.
  std::vector<double> zeros() const {
    using Complex = std::complex<double>;
    const std::array<Complex, 5> c{Complex(by[3], by[4]) / 2.0, Complex(by[1], by[2]) / 2.0, Complex(by[0]),
                                   Complex(by[1], -by[2]) / 2.0, Complex(by[3], -by[4]) / 2.0};
    double largest = 0.0;
    for (const Complex& each : c) largest = std::max(largest, std::abs(each));
    if (!(largest > 0.0)) return {};
    if (std::abs(c[4]) < 1e-13 * largest) return solutions_of_circle(by[1], by[2], -by[0]);
    Eigen::MatrixXcd companion = Eigen::MatrixXcd::Zero(4, 4);
    for (int i = 0; i < 4; ++i) companion(i, 3) = -c[static_cast<std::size_t>(i)] / c[4];
    for (int i = 1; i < 4; ++i) companion(i, i - 1) = 1.0;
    const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> solver(companion, false);
    std::vector<double> angles;
    for (int i = 0; i < 4; ++i) {
      const Complex z = solver.eigenvalues()[i];
      if (std::abs(std::abs(z) - 1.0) < 1e-3) angles.push_back(std::arg(z));
    }
    return angles;
  }
};

}  // namespace

std::vector<double> solutions_of_circle(double a, double b, double c) {
  const double radius = std::hypot(a, b);
  if (!(std::abs(c) <= radius * (1.0 + nearly)) || !(radius > 0.0)) return {};
  const double middle = std::atan2(b, a), half = std::acos(std::clamp(c / radius, -1.0, 1.0));
  return {middle + half, middle - half};
}

Eigen::Matrix3d about_z(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

Eigen::Matrix3d twist_of(const LinkNumbers& link) {
  Eigen::Matrix3d matrix;
  matrix << 1.0, 0.0, 0.0, 0.0, link.cosine, -link.sine, 0.0, link.sine, link.cosine;
  return matrix;
}

std::vector<LinkNumbers> link_numbers(const SerialArm& arm) {
  std::vector<LinkNumbers> links;
  for (const ArmJoint& joint : arm.joints())
    links.push_back({joint.turn.value(), 1e-9 * static_cast<double>(joint.offset),
                     1e-9 * static_cast<double>(joint.length), std::cos(joint.twist.value()),
                     std::sin(joint.twist.value())});
  return links;
}

// Pieper's equations: with f(theta3), the point in the frame of the second joint, k = shift + Rx f in that
// behind the second turn, r^2 and z of the point in the first frame are
//   r^2 = 2 a1 (c2 k1 - s2 k2) + |k|^2 + a1^2,   z = sin(twist 1) (s2 k1 + c2 k2) + cos(twist 1) k3 + d1,
// with the point's distance r from (0, 0, d1).
Candidates position_candidates(const std::vector<LinkNumbers>& links, double height,
                               const Eigen::Vector3d& point) {
  const LinkNumbers &first = links[0], &second = links[1], &third = links[2];
  const Eigen::Vector3d in_third = shift_of(third) + twist_of(third) * Eigen::Vector3d(0.0, 0.0, height);
  const auto behind_second = [&](double theta3) -> Eigen::Vector3d {
    return shift_of(second) + twist_of(second) * (about_z(theta3) * in_third);
  };
  const double z = point.z() - first.offset, squared = point.head<2>().squaredNorm() + z * z;
  const double a = first.length, s = first.sine, c = first.cosine;
  // What remains for theta2 of the two equations: zero for those that do not have it.
  const auto left_of_squares = [&](double theta3) {
    return squared - a * a - behind_second(theta3).squaredNorm();
  };
  const auto left_of_height = [&](double theta3) { return z - c * behind_second(theta3).z(); };
  const double scale = squared + a * a + in_third.squaredNorm() + shift_of(second).squaredNorm();
  std::vector<double> thirds;
  if (a == 0.0) {
    thirds = SecondDegree(left_of_squares).zeros();
  } else if (std::abs(s) < 1e-9) {
    thirds = SecondDegree(left_of_height).zeros();
  } else {
    thirds = SecondDegree([&](double theta3) {
               const Eigen::Vector3d k = behind_second(theta3);
               const double one = left_of_squares(theta3) / (2.0 * a), other = left_of_height(theta3) / s;
               return (one * one + other * other - k.head<2>().squaredNorm()) / scale;
             }).zeros();
  }
  Candidates found;
  for (const double theta3 : thirds) {
    const Eigen::Vector3d k = behind_second(theta3);
    std::vector<double> seconds;
    if (a == 0.0)
      seconds = solutions_of_circle(k.y(), k.x(), left_of_height(theta3) / s);
    else if (std::abs(s) < 1e-9)
      seconds = solutions_of_circle(k.x(), -k.y(), left_of_squares(theta3) / (2.0 * a));
    else
      seconds = {std::atan2(left_of_height(theta3) / s, left_of_squares(theta3) / (2.0 * a)) -
                 std::atan2(k.y(), k.x())};
    for (const double theta2 : seconds) {
      const Eigen::Vector3d in_first = shift_of(first) + twist_of(first) * (about_z(theta2) * k);
      found.push_back(joint_values(links, {angle_between(in_first, point), theta2, theta3}));
    }
  }
  return found;
}

Candidates wrist_candidates(const SerialArm& arm, const Eigen::Isometry3d& goal) {
  const std::vector<LinkNumbers> links = link_numbers(arm);
  Candidates found;
  for (const Eigen::VectorXd& q : position_candidates(links, links[3].offset, goal.translation())) {
    Eigen::Matrix3d before = Eigen::Matrix3d::Identity();
    for (std::size_t i = 0; i < 3; ++i)
      before = before * about_z(q[static_cast<Eigen::Index>(i)] + links[i].turn) * twist_of(links[i]);
    const Eigen::Matrix3d rest = before.transpose() * goal.linear();
    const LinkNumbers &one = links[3], &two = links[4];
    for (const double theta5 :
         solutions_of_circle(one.sine * two.sine, 0.0, one.cosine * two.cosine - rest(2, 2))) {
      const Eigen::Matrix3d middle = twist_of(one) * about_z(theta5) * twist_of(two);
      const double theta4 = angle_between(middle.col(2), rest.col(2));
      const Eigen::Matrix3d last =
          middle.transpose() * about_z(-theta4) * rest * twist_of(links[5]).transpose();
      Eigen::VectorXd each(6);
      each << q, theta4 - one.turn, theta5 - two.turn, std::atan2(last(1, 0), last(0, 0)) - links[5].turn;
      found.push_back(each);
    }
  }
  return found;
}

// The second to fourth axes point along n(theta1), or the other way; along n the point where the last two
// axes meet is at a fixed distance from the first joint, and n is at a fixed angle to the last axis for
// theta5.
Candidates three_parallel_candidates(const SerialArm& arm, const Eigen::Isometry3d& goal) {
  const std::vector<LinkNumbers> l = link_numbers(arm);
  const Eigen::Vector3d p = goal.translation(), last_axis = goal.linear().col(2);
  const double sense3 = l[1].cosine, sense4 = l[1].cosine * l[2].cosine;  // of the axes, against the second
  const double along =
      l[1].offset + sense3 * l[2].offset + sense4 * (l[3].offset + l[3].cosine * l[4].offset);
  Candidates found;
  for (const double theta1 : solutions_of_circle(-l[0].sine * p.y(), l[0].sine * p.x(),
                                                 along - l[0].cosine * (p.z() - l[0].offset))) {
    const Eigen::Matrix3d first = about_z(theta1) * twist_of(l[0]);
    const Eigen::Vector3d axis = first.transpose() * last_axis;
    const Eigen::Vector3d to = first.transpose() * (p - Eigen::Vector3d(0.0, 0.0, l[0].offset) -
                                                    about_z(theta1) * Eigen::Vector3d(l[0].length, 0.0, 0.0));
    for (const double theta5 :
         solutions_of_circle(l[3].sine * l[4].sine, 0.0, l[3].cosine * l[4].cosine - sense4 * axis.z())) {
      const Eigen::Matrix3d flip = twist_of(l[1]) * twist_of(l[2]);
      const Eigen::Matrix3d behind = flip * twist_of(l[3]) * about_z(theta5) * twist_of(l[4]);
      const double turned = angle_between(behind.col(2), axis);  // of the three parallel axes together
      const Eigen::Vector3d wrist =
          to - about_z(turned) *
                   (flip * (shift_of(l[3]) + twist_of(l[3]) * Eigen::Vector3d(0.0, 0.0, l[4].offset)));
      const double a = l[1].length, b = l[2].length, squared = wrist.head<2>().squaredNorm();
      for (const double elbow : solutions_of_circle(2.0 * a * b, 0.0, squared - a * a - b * b)) {
        const Eigen::Vector3d reach(a + b * std::cos(elbow), b * std::sin(elbow), 0.0);
        const double theta2 = angle_between(reach, wrist), theta3 = sense3 * elbow;
        const double theta4 = sense4 * (turned - theta2 - elbow);
        const Eigen::Matrix3d rest =
            (first * about_z(turned) * behind).transpose() * goal.linear() * twist_of(l[5]).transpose();
        found.push_back(
            joint_values(l, {theta1, theta2, theta3, theta4, theta5, std::atan2(rest(1, 0), rest(0, 0))}));
      }
    }
  }
  return found;
}

Candidates planar_candidates(const SerialArm& arm, const Eigen::Isometry3d& goal) {
  const std::vector<LinkNumbers> links = link_numbers(arm);
  std::vector<std::size_t> turning;
  std::vector<double> sense;  // of each joint's axis, against the first
  double up = 1.0, height = 1e-9 * static_cast<double>(arm.tip_height()), slide_sense = 1.0;
  std::size_t slide = arm.size();
  std::vector<Eigen::Vector2d> lengths;  // of the links behind turning joints, before these turn
  double turn_of_slides = 0.0;
  Eigen::Vector2d before = Eigen::Vector2d::Zero();
  double rise = 0.0;
  for (std::size_t i = 0; i < arm.size(); ++i) {
    sense.push_back(up);
    rise += up * links[i].offset;
    if (arm.joints()[i].turns) {
      turning.push_back(i);
      lengths.emplace_back(links[i].length, 0.0);
      turn_of_slides = 0.0;
    } else {
      slide = i;
      slide_sense = up;
      turn_of_slides += up * links[i].turn;
      const Eigen::Vector2d link(links[i].length * std::cos(turn_of_slides),
                                 links[i].length * std::sin(turn_of_slides));
      (lengths.empty() ? before : lengths.back()) += link;
    }
    up *= links[i].cosine;
  }
  rise += up * height;
  // Turns of slides are constant turns of what is behind them; they are only of use where they are none.
  if (turning.size() < 2 || turning.size() > 3) return {};
  const Eigen::Matrix3d& r = goal.linear();
  Eigen::Vector2d point = (goal * Eigen::Vector3d(0.0, 0.0, height)).head<2>();
  const double heading = std::atan2(r(1, 0), r(0, 0));
  if (turning.size() == 3) {
    const double angle = heading - turn_of_slides;
    point -= Eigen::Rotation2Dd(angle) * lengths[2];
  }
  const double a = lengths[0].norm(), b = lengths[1].norm(),
               at_a = std::atan2(lengths[0].y(), lengths[0].x()),
               at_b = std::atan2(lengths[1].y(), lengths[1].x());
  Candidates found;
  for (const double elbow : solutions_of_circle(2.0 * a * b, 0.0, point.squaredNorm() - a * a - b * b)) {
    const Eigen::Vector3d reach(a + b * std::cos(elbow), b * std::sin(elbow), 0.0);
    const double theta1 = angle_between(reach, {point.x(), point.y(), 0.0}) - at_a;
    const double theta2 = elbow + at_a - at_b;
    Eigen::VectorXd q = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(arm.size()));
    const auto set = [&](std::size_t joint, double angle) {
      q[static_cast<Eigen::Index>(joint)] = sense[joint] * angle - links[joint].turn;
    };
    set(turning[0], theta1);
    set(turning[1], theta2);
    if (turning.size() == 3) set(turning[2], heading - turn_of_slides - theta1 - theta2);
    if (slide < arm.size())
      q[static_cast<Eigen::Index>(slide)] =
          slide_sense * ((goal * Eigen::Vector3d(0.0, 0.0, height)).z() - rise);
    found.push_back(q);
  }
  return found;
}

}  // namespace parallel_aspects
