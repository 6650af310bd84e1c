// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_HELD_JOINT_AT_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_HELD_JOINT_AT_H

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cmath>
#include <optional>
#include <variant>

namespace parallel_aspects::test {

/// Planar legs with one joint held, by formulas of its own in extended precision: each leg by where the
/// circle of its rod about the anchor meets what its joint moves. No elbows, and no heights out of the plane.
class HeldJointAt {
 public:
  using Number = long double;
  struct Vector {
    Number x, y;
  };

  HeldJointAt(const Manipulator& robot, std::size_t held, double q) : robot_(robot), held_(held), q_(q) {}

  /// det A of rows (moment about the operational point, u), where the rod of the held leg has this direction;
  /// 0 where the mode reaches nothing, not within its limits, or not with the serial margin. Nothing where
  /// rounding may tell.
  std::optional<Number> determinant(Number direction, Number phi, const WorkingMode& mode) const {
    const Vector center = held_center();
    const Number length = held_length();
    const Vector rod{length * std::cos(direction), length * std::sin(direction)};
    const Vector anchor = turned(held_, phi);
    const Vector position{center.x + rod.x - anchor.x, center.y + rod.y - anchor.y};
    std::array<Vector, 3> u{};
    bool reached = true;
    for (std::size_t j = 0; j < 3; ++j) {
      const Vector b = turned(j, phi);
      const std::optional<bool> found =
          j == held_ ? in_mode(rod, mode.sign(j))
                     : rod_of(j, {position.x + b.x, position.y + b.y}, mode.sign(j), u[j]);
      if (!found) return std::nullopt;
      reached = reached && *found;
    }
    if (!reached) return 0.0L;
    u[held_] = rod;
    const Number value = determinant_of(u, phi);
    return std::abs(value) < 1e-9L * scale(u) ? std::nullopt : std::optional<Number>(value);
  }

 private:
  static constexpr Number tolerance = 1e-9L;

  static Number cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
  static Number dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }

  /// Whether a number is positive; nothing where it is nearly zero.
  static std::optional<bool> positive(Number value, Number size) {
    if (std::abs(value) < tolerance * size) return std::nullopt;
    return value > 0.0L;
  }

  Vector turned(std::size_t j, Number phi) const {
    const Number x = robot_.leg(j).anchor.x(), y = robot_.leg(j).anchor.y();
    return {x * std::cos(phi) - y * std::sin(phi), x * std::sin(phi) + y * std::cos(phi)};
  }

  Vector crank_tip(const RevoluteActuation& crank, Number q) const {
    const Number sense = crank.axis.z() > 0.0 ? 1.0L : -1.0L, radius = crank.radius;
    const Number x = crank.zero_direction.x(), y = crank.zero_direction.y();
    const Number c = std::cos(q), s = sense * std::sin(q);
    return {crank.center.x() + radius * (c * x - s * y), crank.center.y() + radius * (c * y + s * x)};
  }

  Vector held_center() const {
    const Leg& leg = robot_.leg(held_);
    if (const auto* crank = std::get_if<RevoluteActuation>(&leg.actuation)) return crank_tip(*crank, q_);
    if (const auto* rail = std::get_if<PrismaticActuation>(&leg.actuation))
      return {rail->origin.x() + q_ * rail->direction.x(), rail->origin.y() + q_ * rail->direction.y()};
    const auto& strut = std::get<StrutActuation>(leg.actuation);
    return {strut.base.x(), strut.base.y()};
  }

  Number held_length() const {
    const Leg& leg = robot_.leg(held_);
    const auto* strut = std::get_if<StrutActuation>(&leg.actuation);
    return strut != nullptr ? strut->length_at_zero + strut->sense * q_ : Number(leg.rod_length);
  }

  /// B_jj, a crank turned by a right angle against its rod at most.
  std::optional<bool> has_sign(Number entry, int sign, Number largest) const {
    return positive(sign * entry - robot_.constraints().margins.serial * largest, largest);
  }

  std::optional<bool> in_mode(const Vector& rod, int sign) const {
    const Leg& leg = robot_.leg(held_);
    if (const auto* crank = std::get_if<RevoluteActuation>(&leg.actuation))
      return has_sign(crank_entry(*crank, held_center(), rod), sign, crank->radius * leg.rod_length);
    if (const auto* rail = std::get_if<PrismaticActuation>(&leg.actuation))
      return has_sign(dot({rail->direction.x(), rail->direction.y()}, rod), sign, leg.rod_length);
    return true;
  }

  static Number crank_entry(const RevoluteActuation& crank, const Vector& tip, const Vector& rod) {
    const Number sense = crank.axis.z() > 0.0 ? 1.0L : -1.0L;
    return sense * cross({tip.x - crank.center.x(), tip.y - crank.center.y()}, rod);
  }

  static std::optional<bool> within(Number value, const JointLimits& limits, Number period) {
    if (!limits.limited()) return true;
    Number from_lower = value - limits.lower;
    if (period > 0.0L) from_lower -= period * std::floor(from_lower / period);
    const Number width = Number(limits.upper) - limits.lower;
    if (period > 0.0L && width >= period) return true;
    if (std::abs(from_lower) < tolerance || std::abs(from_lower - width) < tolerance) return std::nullopt;
    return from_lower > 0.0L && from_lower < width;
  }

  /// Writes u; whether the anchor is reached there, within limits.
  std::optional<bool> rod_of(std::size_t j, const Vector& p, int sign, Vector& u) const {
    const Leg& leg = robot_.leg(j);
    if (const auto* crank = std::get_if<RevoluteActuation>(&leg.actuation))
      return rod_of(leg, *crank, p, sign, u);
    if (const auto* rail = std::get_if<PrismaticActuation>(&leg.actuation))
      return rod_of(leg, *rail, p, sign, u);
    const auto& strut = std::get<StrutActuation>(leg.actuation);
    u = {p.x - strut.base.x(), p.y - strut.base.y()};
    return within((std::sqrt(dot(u, u)) - strut.length_at_zero) / strut.sense, leg.limits, 0.0L);
  }

  /// The two angles of the crank at which its tip has the distance of the rod from the anchor.
  std::optional<bool> rod_of(const Leg& leg, const RevoluteActuation& crank, const Vector& p, int sign,
                             Vector& u) const {
    const Vector d{p.x - crank.center.x(), p.y - crank.center.y()};
    const Number distance = std::sqrt(dot(d, d)), a = crank.radius, r = leg.rod_length;
    const Number cosine = (distance * distance + a * a - r * r) / (2.0L * a * distance);
    const auto reached = positive(1.0L - std::abs(cosine), 1.0L);
    if (!reached || !*reached) return reached;
    const Number sense = crank.axis.z() > 0.0 ? 1.0L : -1.0L;
    const Number zero = std::atan2(Number(crank.zero_direction.y()), Number(crank.zero_direction.x()));
    for (const Number side : {1.0L, -1.0L}) {
      const Number angle = std::atan2(d.y, d.x) + side * std::acos(cosine), q = sense * (angle - zero);
      const Vector tip = crank_tip(crank, q);
      u = {p.x - tip.x, p.y - tip.y};
      const auto has = has_sign(crank_entry(crank, tip, u), sign, a * r);
      if (!has) return has;
      if (*has) return within(q, leg.limits, 2.0L * std::acos(-1.0L));
    }
    return false;
  }

  std::optional<bool> rod_of(const Leg& leg, const PrismaticActuation& rail, const Vector& p, int sign,
                             Vector& u) const {
    const Vector along{rail.direction.x(), rail.direction.y()};
    const Vector d{p.x - rail.origin.x(), p.y - rail.origin.y()};
    const Number across = cross(along, d), r = leg.rod_length;
    const auto reached = positive(r - std::abs(across), r);
    if (!reached || !*reached) return reached;
    const Number entry = sign * std::sqrt(r * r - across * across), q = dot(along, d) - entry;
    u = {d.x - q * along.x, d.y - q * along.y};
    const auto has = has_sign(dot(along, u), sign, r);
    return has && *has ? within(q, leg.limits, 0.0L) : has;
  }

  Number determinant_of(const std::array<Vector, 3>& u, Number phi) const {
    std::array<Number, 3> m{};
    for (std::size_t j = 0; j < 3; ++j) m[j] = cross(turned(j, phi), u[j]);
    return m[0] * cross(u[1], u[2]) + m[1] * cross(u[2], u[0]) + m[2] * cross(u[0], u[1]);
  }

  Number scale(const std::array<Vector, 3>& u) const {
    Number product = robot_.size();
    for (const Vector& each : u) product *= std::sqrt(dot(each, each));
    return product;
  }

  const Manipulator& robot_;
  std::size_t held_;
  Number q_;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_HELD_JOINT_AT_H
