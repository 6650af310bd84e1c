// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/singularity/indices.h"

#include "model/linear_algebra.h"
#include "model/message_text.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <cmath>

namespace parallel_aspects {
namespace {

struct Anchors {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double distance = 1.0;  // from the middle, root of the mean square
};

Anchors anchors_of(const Manipulator& manipulator) {
  Anchors anchors;
  const auto count = static_cast<double>(manipulator.leg_count());
  for (const Leg& leg : manipulator.legs()) anchors.middle += leg.anchor / count;
  double sum = 0.0;
  for (const Leg& leg : manipulator.legs()) sum += (leg.anchor - anchors.middle).squaredNorm() / count;
  if (sum > 0.0) anchors.distance = std::sqrt(sum);
  return anchors;
}

// What the entries of a row of A can be at most, its rod turned anywhere: a row of one entry, as in T1 and
// R1, is its own norm. In T1 rods are seen in the plane.
double norm_of_row(const Manipulator& manipulator, const Leg& leg, const Eigen::Vector3d& u,
                   const TaskVector& row) {
  const TaskSpace space = manipulator.task_space();
  if (space == TaskSpace::T1) return u.head<2>().norm();
  if (space == TaskSpace::R1) return u.norm() * leg.anchor.head<2>().norm();
  return row.norm();
}

}  // namespace

SingularityIndices singularity_indices(const Manipulator& manipulator, const Pose& pose,
                                       const JointVector& q) {
  const TaskMatrix direct = direct_matrix(manipulator, pose, q);
  const TaskVector values = singular_values(homogenised_matrix(manipulator, pose, q));
  const double largest = values[0];
  const double smallest = values[values.size() - 1];
  return {determinant(direct), inverse_diagonal(manipulator, pose, q), smallest,
          largest > 0.0 ? smallest / largest : 0.0};
}

double parallel_index(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const TaskSpace space = manipulator.task_space();
  const Anchors anchors =
      traits(space).rotations > 0 && traits(space).translations > 0 ? anchors_of(manipulator) : Anchors();
  const auto rotations = static_cast<Eigen::Index>(traits(space).rotations);
  TaskMatrix matrix = direct_matrix(manipulator, pose, q);
  double norms = 1.0;
  for (Eigen::Index j = 0; j < matrix.rows(); ++j) {
    const Leg& leg = manipulator.leg(static_cast<std::size_t>(j));
    const Eigen::Vector3d u = pose.transform(leg.anchor) - leg.proximal_point(q[j]);
    const Eigen::Vector3d b = pose.orientation * (leg.anchor - anchors.middle);
    auto row = matrix.row(j);
    write_row(space, lever_at(pose, b), u, row);
    row.head(rotations) /= anchors.distance;
    norms *= norm_of_row(manipulator, leg, u, row.transpose());
  }
  return norms > 0.0 ? std::abs(determinant(matrix)) / norms : 0.0;
}

TaskVector serial_indices(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  TaskVector indices = inverse_diagonal(manipulator, pose, q).cwiseAbs();
  for (Eigen::Index j = 0; j < indices.size(); ++j) {
    const double largest = manipulator.leg(static_cast<std::size_t>(j)).largest_entry();
    indices[j] = largest > 0.0 ? indices[j] / largest : 1.0;
  }
  return indices;
}

namespace {

void add(const std::string& what, double value, double margin, std::string& text) {
  if (value >= margin) return;
  text += (text.empty() ? "" : "; ") + what + " is " + number_text(value) + ", below the margin " +
          number_text(margin);
}

}  // namespace

std::string to_string(const Margins& margins) {
  std::string text;
  for (const NamedMargin& margin : named_margins)
    if (margins.*margin.member > 0.0)
      text +=
          (text.empty() ? "" : ", ") + std::string(margin.name) + " " + number_text(margins.*margin.member);
  return text;
}

std::string missed_margins(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const Margins& margins = manipulator.constraints().margins;
  std::string text;
  if (margins.parallel > 0.0)
    add("the parallel index", parallel_index(manipulator, pose, q), margins.parallel, text);
  if (margins.serial > 0.0) {
    const TaskVector indices = serial_indices(manipulator, pose, q);
    for (Eigen::Index j = 0; j < indices.size(); ++j)
      add("the serial index of leg '" + manipulator.leg(static_cast<std::size_t>(j)).name + "'", indices[j],
          margins.serial, text);
  }
  if (margins.det_a > 0.0)
    add("|det A|", std::abs(direct_determinant(manipulator, pose, q)), margins.det_a, text);
  return text;
}

}  // namespace parallel_aspects
