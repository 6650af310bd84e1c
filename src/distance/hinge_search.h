// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_HINGE_SEARCH_H
#define PARALLEL_ASPECTS_DISTANCE_HINGE_SEARCH_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/boxes/hinge_chart.h"
#include "aspects/tree/pose_space.h"
#include "distance/leg_boundary.h"
#include "parallel_aspects/distance/boundary_distances.h"

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace parallel_aspects {

/// The searches of BoundaryDistanceMeter in R1 and R2: by branch and bound over the angles, all around. Of a
/// box of angles the distance is bounded by where it can have the anchors, and whether it may hold a pose of
/// the boundary by what `BoxClassifier` proves of it, for limits by the surfaces of `LegBoundary`.
///
/// Allocates when it is made, and nothing after that.
class HingeSearch {
 public:
  HingeSearch(const Manipulator& manipulator, const DistanceOptions& options);

  /// See `BoundaryDistanceMeter::measure`. The numbers must be usable, and the mode one of the robot's.
  BoundaryDistances measure(const Pose& pose, const WorkingMode& mode) noexcept;

 private:
  using Angles = std::array<double, 2>;  ///< in half turns
  using Boundary = LegBoundary<3>;
  enum class Kind { parallel, serial, limit };

  /// What is searched for: det A = 0, B_jj = 0 of a leg or the limit of one.
  struct Target {
    Kind kind;
    std::size_t leg = 0;
    const Boundary* limit = nullptr;
  };

  struct Part {
    double bound;  ///< D of no pose of the box is less
    Box box;
    friend bool operator<(const Part& a, const Part& b) noexcept { return a.bound > b.bound; }
  };

  int most_boxes() const noexcept;
  Angles angles_of(const Pose& pose) const noexcept;
  Pose pose_at(const Angles& angles) const noexcept;
  void look_from(const Pose& pose) noexcept;
  Interval distance_to(const Box& box) const noexcept;
  Spatial<Interval> displacement(const Box& box, std::size_t leg) const noexcept;
  Interval side(const Boundary& boundary, const Box& box) const noexcept;

  BoundaryDistance search(Kind kind) noexcept;
  bool may_hold(Kind kind, const Box& box) const noexcept;
  bool may_hold(const Boundary& boundary, const Box& box) const noexcept;
  template <class Action>
  void for_each_target(Kind kind, const Action& action) const noexcept;
  double least_way(const BoundaryDistance& found) const noexcept;
  void finish(BoundaryDistance& found) const noexcept;

  void look_for_witness(const Target& target, const Angles& start, BoundaryDistance& found) noexcept;
  std::optional<double> value(const Target& target, const Angles& angles) const noexcept;
  std::optional<Angles> slope(const Target& target, const Angles& angles, double value) const noexcept;
  double proved_distance(const Target& target, const Angles& at, const Angles& direction) const noexcept;
  bool is_crossed(const Target& target, const Box& before, const Box& after, const Box& all) const noexcept;
  void describe(const Pose& from, const JointVector& q, BoundaryDistance& found) const noexcept;

  std::shared_ptr<const Manipulator> robot_;
  DistanceOptions options_;
  std::vector<WorkingMode> modes_;
  std::unique_ptr<const BoxClassifier> classifier_;
  std::shared_ptr<const PoseSpace> space_;
  std::variant<R1Chart, R2Chart> chart_;
  std::vector<Boundary> limits_;
  std::size_t dimension_;
  std::vector<Part> queue_;
  std::array<Spatial<Interval>, 2> anchors_;  // at the pose that is looked from
  WorkingMode mode_;
  std::size_t mode_index_ = 0;
  int attempts_ = 0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_HINGE_SEARCH_H
