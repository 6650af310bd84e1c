// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_ROADMAP_H
#define PARALLEL_ASPECTS_MOTION_ROADMAP_H

#include "motion/shortest_paths.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// A configuration: pose and the joint values that assemble with it.
struct Place {
  Pose pose;
  JointVector q;  ///< [rad or m]
};

/// The shortest change of the actuated joints from one place to another: angles without limits turn the short
/// path.
JointVector joint_change(const Manipulator& manipulator, const JointVector& from, const JointVector& to);

/// Whether straight motions of actuated joints between poses that are allowed stay allowed: there are no
/// constraints besides limits of actuated joints.
bool straight_motions_are_allowed(const Manipulator& manipulator);

/// Half of the steps that a tracker takes for one sample, as its options are by default: it follows a motion
/// that is proved in as many, however few samples there are on it.
int steps_of_one_sample() noexcept;

/// Whether the platform, when the actuated joints move straight from `from` by `change`, gets to the pose of
/// `to` with det A away from zero all along; certified by continuation, in at most `max_steps`.
bool straight_motion_exists(const Manipulator& manipulator, const Place& from, const JointVector& change,
                            const Pose& to, int max_steps = steps_of_one_sample());

/// Places of one aspect, and paths between them that avoid singularities with room to spare.
class Roadmap {
 public:
  /// `max_steps`: for the proof of one straight motion. A motion of many samples may take more.
  explicit Roadmap(const Manipulator& manipulator, int max_steps = steps_of_one_sample())
      : manipulator_(manipulator), max_steps_(max_steps) {}

  std::size_t add(const Place& place);
  const Place& place(std::size_t index) const { return places_[index]; }

  /// Places from one to another, both included, such that `straight_motion_exists` between each and the next;
  /// empty where no path is found.
  std::vector<std::size_t> path(std::size_t from, std::size_t to);

 private:
  void connect();
  double cost(std::size_t a, std::size_t b) const;
  std::vector<std::size_t> cheapest(std::size_t from, std::size_t to) const;
  bool is_passable(std::size_t a, std::size_t b) const;

  const Manipulator& manipulator_;
  int max_steps_;
  std::vector<Place> places_;
  std::vector<double> narrowness_;  // 1 over the smallest singular value, for each place
  std::vector<std::vector<std::size_t>> neighbours_;
  ProvedEdges motions_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_ROADMAP_H
