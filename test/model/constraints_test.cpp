// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"

#include <gtest/gtest.h>

#include "support/robots/constrained_robots.h"
#include "support/robots/robots.h"

namespace parallel_aspects {
namespace {

using test::with;

TEST(Constraints, ThatDoNotFitTheLegsAreRefused) {
  Constraints links;
  links.self_collision.emplace();
  EXPECT_THROW(with(test::delta(), links), InvalidDescription);
  EXPECT_THROW(with(test::agile_eye(), links), InvalidDescription);
  EXPECT_THROW(with(test::three_rrr_actuated_elbow(), links), InvalidDescription);
  Constraints workspace;
  workspace.workspace = WorkspaceBox{{1.0, 0.0, 0.0}, {0.0, 1.0, 1.0}};
  EXPECT_THROW(with(test::five_bar(), workspace), InvalidDescription);
}

}  // namespace
}  // namespace parallel_aspects
