// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_URDF_CORRECTIONS_FAULTY_ROBOTS_H
#define PARALLEL_ASPECTS_TEST_URDF_CORRECTIONS_FAULTY_ROBOTS_H

#include "support/descriptions.h"
#include <string>
#include <vector>

namespace parallel_aspects::test {

/// A robot with one fault.
struct FaultyRobot {
  std::string kind;     ///< "axis", "millimetres"
  std::string element;  ///< what is at fault: "'elbow_2_joint'", "'a - b'", "actuated_joints"
  Description text;
};

/// A shipped robot with each of the faults that people make, one at a time.
std::vector<FaultyRobot> faulty_robots(const std::string& robot);

/// The same with the fault in all legs at once: of joints whose names differ in numbers alone.
std::vector<FaultyRobot> robots_with_like_faults(const std::string& robot);

/// The remedies of a message: "write ... for joint 'a'".
std::vector<std::string> remedies(const std::string& message);

/// The description after a remedy. Throws where the remedy is not understood.
Description corrected(Description text, const std::string& remedy);

/// The descriptions after what a message says, one for each of the corrections that it lists, or the one
/// after all that it says; none where it has no remedy.
std::vector<Description> followed(const Description& text, const std::string& message);

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_URDF_CORRECTIONS_FAULTY_ROBOTS_H
