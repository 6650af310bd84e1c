// SPDX-License-Identifier: BSD-3-Clause
#include "arms/ideal_chain.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace parallel_aspects {
namespace {

constexpr double least_note = 1e-8;  // [m or rad]: less is rounding of decimals

// An axis while all joints are zero.
struct Line {
  Eigen::Vector3d point, direction;
};

class ChainBuilder {
 public:
  ChainBuilder(double tolerance_m, double tolerance_rad)
      : tolerance_m_(tolerance_m), tolerance_rad_(tolerance_rad) {}

  void start(const Line& first, const Line& second) {
    frame_.translation() = first.point;
    frame_.linear().col(2) = first.direction;
    set_x(common_normal(first, second));
    chain_.base = frame_;
  }

  // The joint about the z axis of the current frame, and the link to the next axis.
  void add(const ArmAxis& axis, const Line& next) {
    ArmJoint joint{axis.name, axis.turns, axis.limits, {}, {}, 0, 0};
    const Eigen::Vector3d z = frame_.linear().col(2), x = frame_.linear().col(0);
    const Eigen::Vector3d between = next.point - frame_.translation();
    const double sine = z.cross(next.direction).norm(), cosine = z.dot(next.direction);
    Eigen::Vector3d normal = x, foot = frame_.translation();
    if (std::atan2(sine, std::abs(cosine)) < tolerance_rad_) {
      const Eigen::Vector3d across = between - between.dot(z) * z;
      joint.length = nanometres(across.norm(), axis.name, "meets the next axis");
      if (joint.length != 0) normal = across.normalized();
      joint.twist = {cosine > 0.0 ? 0 : 2, 0};
      note_angle(sine, axis.name, "parallel to the next axis");
      foot += joint.length == 0 ? Eigen::Vector3d::Zero().eval() : across;
    } else {
      normal = z.cross(next.direction) / sine;
      const double apart = between.dot(normal);
      joint.length = nanometres(apart, axis.name, "meets the next axis");
      if (joint.length < 0) normal = -normal, joint.length = -joint.length;
      // The foot of the common normal on the current axis.
      const double height = between.dot(z - cosine * next.direction) / (sine * sine);
      joint.offset = nanometres(height, axis.name, "has the feet of both common normals in one point");
      joint.twist = angle(std::atan2(z.cross(next.direction).dot(normal), cosine), axis.name,
                          "perpendicular to the next axis");
      foot += height * z + (joint.length == 0 ? 0.0 : std::abs(apart)) * normal;
    }
    joint.turn = angle(std::atan2(x.cross(normal).dot(z), x.dot(normal)), axis.name,
                       "a quarter turn from the next common normal");
    frame_.translation() = foot;
    frame_.linear().col(2) = next.direction;
    set_x(normal);
    chain_.joints.push_back(joint);
  }

  IdealChain finish(const Eigen::Vector3d& tip) {
    chain_.last = frame_;
    const Eigen::Vector3d rest = frame_.inverse() * tip;
    chain_.tip_height = nanometres(rest.z(), "operational point", "on the last common normal");
    return std::move(chain_);
  }

  Eigen::Vector3d origin() const { return frame_.translation(); }

 private:
  static Eigen::Vector3d any_normal(const Eigen::Vector3d& z) {
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    const Eigen::Vector3d other = std::abs(z.dot(x)) < 0.9 ? x : Eigen::Vector3d::UnitY().eval();
    return (other - other.dot(z) * z).normalized();
  }

  // So that the first joint value has no offset.
  Eigen::Vector3d common_normal(const Line& a, const Line& b) const {
    const Eigen::Vector3d across = a.direction.cross(b.direction), between = b.point - a.point;
    if (across.norm() > tolerance_rad_) {
      const Eigen::Vector3d normal = across.normalized();
      return between.dot(normal) < -tolerance_m_ ? Eigen::Vector3d(-normal) : normal;
    }
    const Eigen::Vector3d apart = between - between.dot(a.direction) * a.direction;
    return apart.norm() > tolerance_m_ ? apart.normalized() : any_normal(a.direction);
  }

  void set_x(const Eigen::Vector3d& x) {
    const Eigen::Vector3d z = frame_.linear().col(2);
    const Eigen::Vector3d across = (x - x.dot(z) * z).normalized();
    frame_.linear().col(0) = across;
    frame_.linear().col(1) = z.cross(across);
  }

  std::int64_t nanometres(double length, const std::string& of, const std::string& fact) {
    if (std::abs(length) >= tolerance_m_) return std::llround(length * 1e9);
    note(std::abs(length), "m", of, fact);
    return 0;
  }

  RationalAngle angle(double radians, const std::string& of, const std::string& fact) {
    const int quarters = static_cast<int>(std::lround(radians / (0.5 * half_turn)));
    const double rest = radians - quarters * (0.5 * half_turn);
    const int turned = ((quarters % 4) + 4) % 4;
    if (std::abs(rest) >= tolerance_rad_) return {turned, std::llround(std::tan(0.5 * rest) * 1e12)};
    note(std::abs(rest), "rad", of, fact);
    return {turned, 0};
  }

  void note_angle(double sine, const std::string& of, const std::string& fact) {
    note(sine, "rad", of, fact);
  }

  void note(double change, const char* unit, const std::string& of, const std::string& fact) {
    if (change < least_note) return;
    std::ostringstream text;
    text.precision(2);
    text << "'" << of << "' is taken as exact: " << fact << ", which the description misses by " << change
         << " " << unit << ".";
    chain_.notes.push_back(text.str());
  }

  double tolerance_m_, tolerance_rad_;
  Eigen::Isometry3d frame_ = Eigen::Isometry3d::Identity();
  IdealChain chain_;
};

Line line_behind(const ArmDescription& description, LastAxis last, const Eigen::Vector3d& origin) {
  const ArmAxis& axis = description.axes.back();
  if (last == LastAxis::of_last_joint) return {origin, axis.direction};
  if (last == LastAxis::parallel_to_it) return {description.tip.translation(), axis.direction};
  return {description.tip.translation(), description.tip.linear().col(2)};
}

}  // namespace

IdealChain ideal_chain(const ArmDescription& description, LastAxis last, double tolerance_m,
                       double tolerance_rad) {
  ChainBuilder builder(tolerance_m, tolerance_rad);
  const std::size_t count = description.axes.size();
  const auto line = [&](std::size_t i) {
    if (i == count) return line_behind(description, last, builder.origin());
    std::size_t at = i;  // where a slide is does not matter: it goes through the next axis, or the tip
    while (at < count && !description.axes[at].turns) ++at;
    return Line{at < count ? description.axes[at].point : description.tip.translation().eval(),
                description.axes[i].direction};
  };
  const Line first = line(0);
  builder.start(first, count > 1 ? line(1) : line_behind(description, last, first.point));
  for (std::size_t i = 0; i < count; ++i) builder.add(description.axes[i], line(i + 1));
  return builder.finish(description.tip.translation());
}

}  // namespace parallel_aspects
