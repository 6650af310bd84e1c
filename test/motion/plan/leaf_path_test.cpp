// SPDX-License-Identifier: BSD-3-Clause
//
// Paths through leaves that touch at corners alone, by passages beside undecided leaves.
#include "motion/plan/leaf_path.h"

#include "aspects/map/map_contents.h"
#include "motion/plan/map_segments.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/motion/plan_path.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {
namespace {

using test::Robot;

/// A corridor of some hundred leaves that touch at corners alone.
class CorridorOfCorners : public testing::Test {
 protected:
  CorridorOfCorners() {
    Margins margins;
    margins.det_a = 3660.0;
    const Robot robot = test::three_rpr()->with_margins(margins);
    MapOptions options;
    options.slice = test::slice_of(robot, {{robot->leg(0).actuated_joint, 14.98}});
    const AnchorCircle circle = circle_of_anchor(*robot, *options.slice->joint);
    from_.pose = circle.nearest(Pose::planar(14.67394366, -3.01260312, 2.13290437));
    to_.pose = circle.nearest(Pose::planar(-5.49566082, -13.93549828, -0.04733137));
    map_ = test::map_of(robot, options);
  }

  PathEnd from_, to_;
  std::shared_ptr<const AspectMap> map_;
};

TEST_F(CorridorOfCorners, HasAPath) {
  const PlannedPath path = PathPlanner(map_).plan(from_, to_, PathPolicy::stay);
  ASSERT_TRUE(path) << path.message;
  EXPECT_GE(path.least_det_a, 3660.0);
}

/// The search through leaves of the corridor, by itself.
class SearchByPassages : public CorridorOfCorners {
 protected:
  SearchByPassages() {
    const auto aspect = std::find_if(map_->aspects().begin(), map_->aspects().end(), [&](const Aspect& each) {
      return map_->locate(from_.pose, each.mode).aspect == each.id &&
             map_->locate(to_.pose, each.mode).aspect == each.id;
    });
    aspect_ = &*aspect;
    components_.emplace(contents_, *mode_index(contents_, aspect_->mode));
    climbs_ = climbs_between_parts(contents_, *aspect_, *components_, {});
    choice_.first = leaves_near(contents_, *aspect_, from_.pose);
    choice_.last = leaves_near(contents_, *aspect_, to_.pose);
    choice_.passages = &climbs_;
    choice_.proofs = &proofs_;
    choice_.is_free = [this](const Pose& from, const Pose& to) {
      ++proved_;
      if (proved_ == cancel_after_) cancelled_ = true;
      return segments_.is_free(from, to, aspect_->mode, aspect_->determinant_sign);
    };
    choice_.control.cancelled = &cancelled_;
  }

  std::vector<LeafStep> search() {
    return find_leaf_path(contents_, *components_, indices_, aspect_->id, from_.pose, to_.pose, choice_);
  }

  const AspectMap::Contents& contents_ = map_->contents();
  const MapSegments segments_{map_};
  const Aspect* aspect_ = nullptr;
  std::optional<FaceComponents> components_;
  LeafIndices indices_;
  LeafPassages climbs_;
  PassageProofs proofs_;
  LeafChoice choice_;
  std::atomic<bool> cancelled_{false};
  int proved_ = 0, cancel_after_ = -1;
};

TEST_F(SearchByPassages, ProvesNoPassageTwice) {
  const std::vector<LeafStep> first = search();
  ASSERT_FALSE(first.empty());
  ASSERT_GT(proved_, 0);
  const int proved = proved_;
  const std::vector<LeafStep> again = search();
  EXPECT_EQ(proved_, proved);
  ASSERT_EQ(again.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(again[i].leaf, first[i].leaf);
}

TEST_F(SearchByPassages, EndsWhenItIsCancelled) {
  cancel_after_ = 3;
  EXPECT_TRUE(search().empty());
  EXPECT_EQ(proved_, 3);
  EXPECT_TRUE(climbs_between_parts(contents_, *aspect_, *components_, choice_.control).empty());
}

// What was cancelled was not searched for in vain.
TEST_F(CorridorOfCorners, HasAPathAfterASearchThatWasCancelled) {
  PathPlanner planner(map_);
  std::atomic<bool> cancelled{true};
  MapControl control;
  control.cancelled = &cancelled;
  const PlannedPath none = planner.plan(from_, to_, PathPolicy::stay, control);
  EXPECT_FALSE(none);
  EXPECT_EQ(none.message, "Cancelled.");
  EXPECT_TRUE(planner.plan(from_, to_, PathPolicy::stay));
}

}  // namespace
}  // namespace parallel_aspects
