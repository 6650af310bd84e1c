// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHOOSE_REGION_SURVEY_H
#define PARALLEL_ASPECTS_MOTION_CHOOSE_REGION_SURVEY_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/tree/pose_space.h"
#include "parallel_aspects/motion/choose_working_mode.h"

#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Divides a region into boxes until each is proved in every working mode. A region is connected; so where
/// all of its boxes are inside with one sign of det A, it lies in one aspect.
class RegionSurvey {
 public:
  /// There must be no `problems_of` the question. `angle`: from which coordinate on they are
  /// angles, if any is.
  RegionSurvey(const Manipulator& manipulator, const RegionQuestion& question,
               std::optional<std::size_t> angle);

  /// One for each working mode, by rising index. To be called once.
  std::vector<ModeInRegion> run(const RegionChoiceOptions& options);

  /// The corners of the region.
  std::vector<Pose> corners() const;

 private:
  /// Part of the region, and the modes in which it is not proved yet.
  struct Part {
    Box box;
    ModeSet open = 0;
    int level = 0;
  };

  /// A box that is proved inside in these modes.
  struct Inside {
    Box box;
    ModeSet modes = 0;
  };

  /// What was found in one mode.
  struct Found {
    std::array<std::optional<MapPoint>, 2> with_sign;  // of det A: positive, negative
    std::optional<MapPoint> outside;
    double undecided = 0.0;  // volume
    bool is_refuted() const { return outside || (with_sign[0] && with_sign[1]); }
  };

  void look_at(const Part& part);
  void take(std::size_t mode, const LeafState& state, const Part& part, ModeSet& inside, ModeSet& undecided);
  void halve(const Part& part, ModeSet open);
  void leave_open(const Part& part);
  std::size_t longest_edge(const Box& box) const;
  ModeInRegion conclude(std::size_t mode) const;
  IndexRange least_index(std::size_t mode, int sign) const;
  Pose pose(const MapPoint& point) const { return space_->pose({0, point}); }

  std::vector<WorkingMode> modes_;
  std::unique_ptr<const BoxClassifier> classifier_;
  std::size_t angle_;
  Box region_;  // in the coordinates of the space, with angles from -2 to 2
  std::shared_ptr<const PoseSpace> space_;
  std::deque<Part> parts_;
  std::vector<Inside> inside_;
  std::vector<Found> found_;
  ModeSet refuted_ = 0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHOOSE_REGION_SURVEY_H
