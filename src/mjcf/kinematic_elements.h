// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MJCF_KINEMATIC_ELEMENTS_H
#define PARALLEL_ASPECTS_MJCF_KINEMATIC_ELEMENTS_H

#include "parallel_aspects/model/problems.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects::mjcf {

/// Where an element stands that is in the text: files may include others.
struct SourceLine {
  std::string file;
  int line = 0;
};

/// A <connect> or <weld> of two sites, which MuJoCo knows since 3.1 only.
struct SiteEquality {
  std::string name, element;
  std::array<std::string, 2> sites;
  bool is_weld = false;
};

/// An actuator that drives a joint.
struct JointActuator {
  std::string element;  ///< for messages, as "<motor> 'm1'"
  std::string joint;
};

/// What of an MJCF concerns kinematics: bodies, joints, sites, defaults of these, and equalities. Without
/// meshes and the like, robots are read whose meshes are not at hand, and those of later versions of MuJoCo.
struct KinematicElements {
  std::string text;                     ///< an MJCF, with its includes in their places
  std::vector<SourceLine> lines;        ///< of its elements, in their order
  std::vector<std::string> equalities;  ///< names of those in the text, in their order, for messages
  std::vector<SiteEquality> site_equalities;
  std::vector<JointActuator> actuators;
  std::vector<std::string> followers;  ///< joints that are a function of another one
  std::vector<std::string> notes;      ///< what is not used, without the name of the file
};

/// Reads them from a file. What is wrong is added to `problems`.
KinematicElements kinematic_elements(const std::string& file, Problems& problems);

}  // namespace parallel_aspects::mjcf

#endif  // PARALLEL_ASPECTS_MJCF_KINEMATIC_ELEMENTS_H
