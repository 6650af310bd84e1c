// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/singularity/margins.h"

#include "model/number_text.h"
#include "parallel_aspects/kinematics/jacobians.h"
#include "parallel_aspects/singularity/indices.h"

#include <cmath>

namespace parallel_aspects {
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
