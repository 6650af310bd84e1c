// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_URDF_SETUP_SETUP_TEXTS_H
#define PARALLEL_ASPECTS_TEST_URDF_SETUP_SETUP_TEXTS_H

#include "urdf/setup/setup.h"

#include "support/robots/shipped.h"
#include <chrono>
#include <string>
#include <vector>

/// What the tests of setup share: texts in, texts out.
namespace parallel_aspects::test {

using Strings = std::vector<std::string>;

// More than any of these searches needs.
inline SetupControl patient() { return {1000000}; }

inline SetupResult set_up_text(const std::string& urdf, const SetupAnswers& answers = {}) {
  return set_up(urdf, "robot.urdf", "robot.yaml", answers, patient());
}

inline Strings actuated_joints(const Mechanism& mechanism) {
  Strings joints;
  for (const Leg& leg : mechanism.manipulator()->legs()) joints.push_back(leg.actuated_joint);
  return joints;
}

inline std::string listed(const Problems& problems) {
  std::string text;
  for (const std::string& problem : problems) text += problem + '\n';
  return text;
}

inline std::string urdf_of(const std::string& name) {
  return test::source_file("test/data/setup/" + name + ".urdf");
}

inline SetupAnswers with_closures(const Strings& pairs) {
  SetupAnswers answers;
  for (const std::string& pair : pairs)
    answers.closures.push_back({pair.substr(0, pair.find('=')), pair.substr(pair.find('=') + 1)});
  return answers;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_URDF_SETUP_SETUP_TEXTS_H
