// SPDX-License-Identifier: BSD-3-Clause
#include "support/index_at.h"

#include "support/elimination.h"
#include <algorithm>
#include <cmath>
#include <variant>

namespace parallel_aspects::test {

IndexAt::IndexAt(const Manipulator& robot, const Pose& pose, const JointVector& q)
    : robot_(robot), turned_(pose.orientation.toRotationMatrix().cast<Number>()), q_(q) {
  for (const Leg& leg : robot.legs()) middle_ += leg.anchor.cast<Number>();
  middle_ /= static_cast<Number>(robot.leg_count());
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    const Vector anchor = pose.position.cast<Number>() + turned_ * robot.leg(j).anchor.cast<Number>();
    rods_.push_back(anchor - robot.leg(j).proximal_point(q[static_cast<Eigen::Index>(j)]).cast<Number>());
    anchors_.push_back(anchor);
  }
}

IndexAt::Number IndexAt::parallel() const {
  if (robot_.task_space() == TaskSpace::T1) return std::abs(rods_[0].x()) / rods_[0].head(2).norm();
  if (robot_.task_space() == TaskSpace::R1) {  // the cosine between the rod and the way of the anchor
    const Vector way = Vector::UnitZ().cross(anchors_[0]);
    return std::abs(way.normalized().dot(rods_[0].normalized()));
  }
  Matrix rows = all_rows();
  rows.rowwise().normalize();
  const Matrix products = rows.lazyProduct(rows.transpose());
  return std::sqrt(std::max<Number>(0.0L, determinant_by_elimination(products)));
}

IndexAt::Number IndexAt::signed_determinant() const {
  if (robot_.task_space() == TaskSpace::T1) return rods_[0].x();
  return std::pow(length(), static_cast<Number>(rotations())) * determinant_by_elimination(all_rows());
}

IndexAt::Number IndexAt::serial() const {
  Number least = 1.0L;
  for (std::size_t j = 0; j < rods_.size(); ++j) least = std::min(least, sine(j));
  return least;
}

IndexAt::Number IndexAt::length() const {
  if (!moves()) return 1.0L;
  Number sum = 0.0L;
  for (const Leg& leg : robot_.legs()) sum += (leg.anchor.cast<Number>() - middle_).squaredNorm();
  return std::sqrt(sum / static_cast<Number>(robot_.leg_count()));
}

IndexAt::Matrix IndexAt::all_rows() const {
  const auto n = static_cast<Eigen::Index>(robot_.leg_count()),
             turns = static_cast<Eigen::Index>(rotations());
  Matrix rows(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Vector& u = rods_[static_cast<std::size_t>(j)];
    const Vector from = robot_.leg(static_cast<std::size_t>(j)).anchor.cast<Number>() -
                        (moves() ? middle_ : Vector(Vector::Zero()));
    const Vector moment = (turned_ * from).cross(u) / length();
    if (turns > 0) rows.row(j).head(turns) = moment.tail(turns).transpose();
    if (robot_.task_space() == TaskSpace::R2) {
      rows(j, 0) = Vector::UnitZ().cross(anchors_[static_cast<std::size_t>(j)]).dot(u);
      rows(j, 1) = moment.dot(turned_.col(2));
      continue;
    }
    rows.row(j).tail(n - turns) = u.head(n - turns).transpose();
  }
  return rows;
}

IndexAt::Number IndexAt::sine(std::size_t j) const {
  const Leg& leg = robot_.leg(j);
  const double q = q_[static_cast<Eigen::Index>(j)];
  if (const auto* crank = std::get_if<RevoluteActuation>(&leg.actuation)) {
    const Vector along = (leg.proximal_point(q) - crank->center).cast<Number>();
    const Vector axis = crank->axis.cast<Number>();
    return std::abs(axis.cross(along.normalized()).dot(rods_[j])) / static_cast<Number>(leg.rod_length);
  }
  if (const auto* rail = std::get_if<PrismaticActuation>(&leg.actuation))
    return std::abs(rail->direction.cast<Number>().dot(rods_[j])) / static_cast<Number>(leg.rod_length);
  if (std::get_if<StrutActuation>(&leg.actuation) != nullptr) return 1.0L;
  // The elbow's sine by the law of cosines.
  const auto& elbow = std::get<ElbowActuation>(leg.actuation);
  const Number a = elbow.inner_length, b = elbow.outer_length;
  const Number cosine = (a * a + b * b - rods_[j].squaredNorm()) / (2.0L * a * b);
  return std::sqrt(std::max<Number>(0.0L, 1.0L - cosine * cosine));
}

}  // namespace parallel_aspects::test
