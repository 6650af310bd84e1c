// SPDX-License-Identifier: BSD-3-Clause
#include "arms/arm_determinant.h"

#include "parallel_aspects/model/problems.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace parallel_aspects {
namespace {

struct RationalTurn {
  Rational cosine, sine;
};

RationalTurn turn_of(const RationalAngle& angle) {
  const Rational t(angle.half_tangent, 1000000000000LL), square = t * t, one(1);
  RationalTurn turn{(one - square) / (one + square), 2 * t / (one + square)};
  for (int k = 0; k < angle.quarters; ++k) turn = {-turn.sine, turn.cosine};
  return turn;
}

TrigPolynomial metres(std::int64_t nanometres) { return Rational(nanometres, 1000000000LL); }

// A joint with its link, over polynomials: vectors go from the frame behind it to that before it and back.
class Link {
 public:
  Link(const ArmJoint& joint, std::size_t index)
      : length_(metres(joint.length)), offset_(metres(joint.offset)) {
    const RationalTurn turn = turn_of(joint.turn), twist = turn_of(joint.twist);
    cosine_ = TrigPolynomial(turn.cosine);
    sine_ = TrigPolynomial(turn.sine);
    if (joint.turns) {
      const TrigPolynomial c = TrigPolynomial::cosine(index), s = TrigPolynomial::sine(index);
      cosine_ = TrigPolynomial(turn.cosine) * c - TrigPolynomial(turn.sine) * s;
      sine_ = TrigPolynomial(turn.sine) * c + TrigPolynomial(turn.cosine) * s;
    } else {
      offset_ = offset_ + TrigPolynomial::length(index);
    }
    twist_cosine_ = TrigPolynomial(twist.cosine);
    twist_sine_ = TrigPolynomial(twist.sine);
  }

  PolynomialVector turned_back(const PolynomialVector& v) const {  // to the frame behind
    const TrigPolynomial y = cosine_ * v[1] - sine_ * v[0];
    return {cosine_ * v[0] + sine_ * v[1], twist_cosine_ * y + twist_sine_ * v[2],
            twist_cosine_ * v[2] - twist_sine_ * y};
  }
  PolynomialVector turned(const PolynomialVector& v) const {  // to the frame before
    const TrigPolynomial y = twist_cosine_ * v[1] - twist_sine_ * v[2];
    return {cosine_ * v[0] - sine_ * y, sine_ * v[0] + cosine_ * y,
            twist_sine_ * v[1] + twist_cosine_ * v[2]};
  }
  PolynomialVector origin_behind() const {  // in the frame before
    return {cosine_ * length_, sine_ * length_, offset_};
  }
  PolynomialVector origin_before() const {  // in the frame behind
    return {TrigPolynomial() - length_, TrigPolynomial() - twist_sine_ * offset_,
            TrigPolynomial() - twist_cosine_ * offset_};
  }

 private:
  TrigPolynomial cosine_, sine_, twist_cosine_, twist_sine_, length_, offset_;
};

std::vector<Link> links_of(const SerialArm& arm) {
  std::vector<Link> links;
  for (std::size_t i = 0; i < arm.size(); ++i) links.emplace_back(arm.joints()[i], i);
  return links;
}

// Turn of a body, and velocity of its point that is in the origin.
struct Twist {
  PolynomialVector turn, velocity;
};

// The z axis of frame `from`, as a joint, in frame `to`.
Twist axis_twist(const std::vector<Link>& links, std::size_t from, std::size_t to, bool turns) {
  const PolynomialVector z{0, 0, 1}, zero{0, 0, 0};
  Twist twist = turns ? Twist{z, zero} : Twist{zero, z};
  for (; from < to; ++from) {
    const Link& link = links[from];
    twist.velocity = sum(twist.velocity, cross(twist.turn, link.origin_behind()));
    twist = {link.turned_back(twist.turn), link.turned_back(twist.velocity)};
  }
  for (; from > to; --from) {
    const Link& link = links[from - 1];
    twist.velocity = sum(twist.velocity, cross(twist.turn, link.origin_before()));
    twist = {link.turned(twist.turn), link.turned(twist.velocity)};
  }
  return twist;
}

using Column = std::vector<TrigPolynomial>;

// By Laplace's expansion, column after column, over sets of rows.
TrigPolynomial determinant(const std::vector<Column>& columns) {
  const std::size_t count = columns.size();
  std::vector<TrigPolynomial> minors(std::size_t{1} << count);
  minors[0] = 1;
  for (std::size_t rows = 1; rows < minors.size(); ++rows) {
    std::size_t size = 0;
    for (std::size_t row = 0; row < count; ++row) size += rows >> row & 1U;
    std::size_t below = 0;  // rows of the set behind this one
    for (std::size_t row = count; row-- > 0;) {
      if ((rows >> row & 1U) == 0) continue;
      const TrigPolynomial& minor = minors[rows & ~(std::size_t{1} << row)];
      const TrigPolynomial& entry = columns[size - 1][row];
      if (!minor.is_zero() && !entry.is_zero()) {
        const TrigPolynomial term = minor * entry;
        minors[rows] = below % 2 == 0 ? minors[rows] + term : minors[rows] - term;
      }
      ++below;
    }
  }
  return minors.back();
}

class DeterminantOf {
 public:
  explicit DeterminantOf(const SerialArm& arm) : arm_(arm), links_(links_of(arm)), frame_(arm.size() / 2) {
    for (std::size_t i = 0; i < arm.size(); ++i)
      twists_.push_back(axis_twist(links_, i, frame_, arm.joints()[i].turns));
    point_ = {0, 0, metres(arm.tip_height())};
    for (std::size_t i = arm.size(); i > frame_; --i)
      point_ = sum(links_[i - 1].turned(point_), links_[i - 1].origin_behind());
    last_axis_ = axis_twist(links_, arm.size(), frame_, true).turn;
  }

  TrigPolynomial value() const {
    switch (arm_.task()) {
      case ArmTask::plane_position:
        return dot(normal(), cross(velocity(0), velocity(1)));
      case ArmTask::direction:
        return dot(last_axis_, cross(twists_[0].turn, twists_[1].turn));
      case ArmTask::position:
        return determinant({column(0, false), column(1, false), column(2, false)});
      case ArmTask::orientation:
        return dot(twists_[0].turn, cross(twists_[1].turn, twists_[2].turn));
      case ArmTask::plane_pose:
      case ArmTask::position_and_turn:
        return with_turn_about_normal();
      case ArmTask::position_and_direction:
        return with_turn_about_last_axis();
      case ArmTask::pose:
        break;
    }
    std::vector<Column> columns;
    for (std::size_t i = 0; i < arm_.size(); ++i) columns.push_back(column(i, true));
    return determinant(columns);
  }

 private:
  PolynomialVector velocity(std::size_t i) const {
    return sum(twists_[i].velocity, cross(twists_[i].turn, point_));
  }
  Column column(std::size_t i, bool with_turn) const {
    const PolynomialVector v = velocity(i);
    Column result{v[0], v[1], v[2]};
    if (with_turn) result.insert(result.end(), twists_[i].turn.begin(), twists_[i].turn.end());
    return result;
  }

  // Of the plane, in this frame. It is the z axis of every frame behind a turning joint, or the opposite.
  PolynomialVector normal() const {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(arm_.size()));
    const Eigen::Vector3d wanted = arm_.plane().col(2);
    const Eigen::Vector3d here = arm_.frames(zero)[frame_].linear().transpose() * wanted;
    const auto rounded = [](double x) { return TrigPolynomial(static_cast<int>(std::lround(x))); };
    return {rounded(here.x()), rounded(here.y()), rounded(here.z())};
  }

  // Rows x, y, (z,) turn: with the normal n, what turns about nothing else, and moves along n as well where
  // that is no coordinate, det [v; n.w] is the determinant with a column for each that is missing.
  TrigPolynomial with_turn_about_normal() const {
    const PolynomialVector n = normal();
    std::vector<Column> columns;
    for (std::size_t i = 0; i < arm_.size(); ++i) {
      Column each = column(i, false);
      each.push_back(dot(n, twists_[i].turn));
      columns.push_back(each);
    }
    if (arm_.task() == ArmTask::plane_pose)  // as the third of four: x, y, n, turn
      columns.insert(columns.begin() + 2, Column{n[0], n[1], n[2], 0});
    return determinant(columns);
  }

  // The turn that the direction leaves open is another joint, about the last axis through the point.
  TrigPolynomial with_turn_about_last_axis() const {
    std::vector<Column> columns;
    for (std::size_t i = 0; i < arm_.size(); ++i) columns.push_back(column(i, true));
    columns.push_back({0, 0, 0, last_axis_[0], last_axis_[1], last_axis_[2]});
    return determinant(columns);
  }

  const SerialArm& arm_;
  std::vector<Link> links_;
  std::size_t frame_;  // in which all is
  std::vector<Twist> twists_;
  PolynomialVector point_, last_axis_;
};

// Groups of factors that share no joint.
std::vector<FactorGroup> grouped(const std::vector<TrigPolynomial>& factors) {
  std::vector<FactorGroup> groups;
  for (const TrigPolynomial& factor : factors) {
    FactorGroup group{factor.joints(), {factor}};
    for (auto other = groups.begin(); other != groups.end();) {
      const bool shares = std::any_of(other->joints.begin(), other->joints.end(), [&](std::size_t joint) {
        return std::find(group.joints.begin(), group.joints.end(), joint) != group.joints.end();
      });
      if (!shares) {
        ++other;
        continue;
      }
      group.joints.insert(group.joints.end(), other->joints.begin(), other->joints.end());
      group.factors.insert(group.factors.end(), other->factors.begin(), other->factors.end());
      other = groups.erase(other);
    }
    std::sort(group.joints.begin(), group.joints.end());
    group.joints.erase(std::unique(group.joints.begin(), group.joints.end()), group.joints.end());
    groups.push_back(group);
  }
  std::sort(groups.begin(), groups.end(),
            [](const FactorGroup& a, const FactorGroup& b) { return a.joints < b.joints; });
  return groups;
}

// Into factors of which each has joints of its own, as far as there are such.
void split_all(const TrigPolynomial& a, std::vector<TrigPolynomial>& factors) {
  const std::vector<std::size_t> joints = a.joints();
  for (std::size_t set = 1; set + 1 < std::size_t{1} << joints.size(); ++set) {
    std::vector<std::size_t> part;
    for (std::size_t i = 0; i < joints.size(); ++i)
      if ((set >> i & 1U) != 0) part.push_back(joints[i]);
    const auto found = split(a, part);
    if (found.empty()) continue;
    for (const TrigPolynomial& each : found) split_all(each, factors);
    return;
  }
  factors.push_back(a);
}

// Scaled so that its largest coefficient is 1 or -1; the sign of the scale is left out of nothing.
TrigPolynomial scaled(const TrigPolynomial& a, int& sign) {
  Rational largest = 0;
  for (const auto& term : a.terms()) {
    const Rational size = abs(term.second);
    if (size > abs(largest)) largest = term.second;
  }
  if (largest < 0) sign = -sign;
  return a * TrigPolynomial(Rational(1) / largest);
}

}  // namespace

PolynomialVector cross(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
PolynomialVector sum(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
TrigPolynomial dot(const PolynomialVector& a, const PolynomialVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

PolynomialVector point_behind_first(const SerialArm& arm) {
  const std::vector<Link> links = links_of(arm);
  PolynomialVector point{0, 0, metres(arm.tip_height())};
  for (std::size_t i = arm.size(); i > 1; --i)
    point = sum(links[i - 1].turned(point), links[i - 1].origin_behind());
  ArmJoint first = arm.joints().front();
  first.turns = false;  // with its turn left out, and its value zero
  const RationalTurn twist = turn_of(first.twist);
  const TrigPolynomial c(twist.cosine), s(twist.sine);
  return {point[0] + metres(first.length), c * point[1] - s * point[2],
          s * point[1] + c * point[2] + metres(first.offset)};
}

ArmDeterminant arm_determinant(const SerialArm& arm) {
  ArmDeterminant result{DeterminantOf(arm).value(), 1, {}};
  if (result.whole.is_zero())
    throw InvalidDescription({"det J of '" + arm.name() +
                              "' is zero at all joint values, so that its joints "
                              "cannot do the task " +
                              name(arm.task()) + "; state another mechanism.task."});
  std::vector<TrigPolynomial> factors;
  TrigPolynomial rest = result.whole;
  for (std::size_t joint = 0; joint < arm.size(); ++joint) {
    if (!arm.joints()[joint].turns) continue;
    const Content content = content_in(rest, joint);
    rest = content.rest;
    if (!content.factor.joints().empty()) factors.push_back(content.factor);
  }
  split_all(rest, factors);
  std::vector<TrigPolynomial> varying;
  for (const TrigPolynomial& factor : factors) {
    const TrigPolynomial normed = scaled(factor, result.sign);
    if (!normed.joints().empty()) varying.push_back(normed);
  }
  result.groups = grouped(varying);
  return result;
}

std::string text_of(const TrigPolynomial& a, const SerialArm& arm) {
  std::ostringstream text;
  text.precision(6);
  bool first = true;
  for (const auto& [exponents, coefficient] : a.terms()) {
    const double value = coefficient.convert_to<double>();
    text << (first ? value < 0.0 ? "-" : "" : value < 0.0 ? " - " : " + ");
    first = false;
    std::string factors;
    for (std::size_t joint = 0; joint < arm.size(); ++joint) {
      const std::string& joint_name = arm.joints()[joint].name;
      const auto append = [&](const std::string& factor, unsigned power) {
        if (power == 0) return;
        factors += (factors.empty() ? "" : " ") + factor + (power > 1 ? "^" + std::to_string(power) : "");
      };
      const bool turns = arm.joints()[joint].turns;
      append(turns ? "cos(" + joint_name + ")" : joint_name, exponents[2 * joint]);
      append("sin(" + joint_name + ")", exponents[2 * joint + 1]);
    }
    const double size = std::abs(value);
    if (factors.empty() || size != 1.0) text << size << (factors.empty() ? "" : " ");
    text << factors;
  }
  return text.str();
}

}  // namespace parallel_aspects
