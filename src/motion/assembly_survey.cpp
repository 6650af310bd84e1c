// SPDX-License-Identifier: BSD-3-Clause
#include "motion/assembly_survey.h"

#include "interval/interval.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace parallel_aspects {
namespace {

// Allowance for the actuated values: far above the rounding between a pose and its values, far below the
// distances of solutions [rad, or share of the robot's size].
constexpr double allowed = 1e-10;

}  // namespace

SolutionProver::SolutionProver(const SegmentCertifier& segments)
    : segments_(segments), certifier_(*segments.manipulator()) {
  allowance_.resize(static_cast<Eigen::Index>(manipulator().leg_count()));
  for (std::size_t j = 0; j < manipulator().leg_count(); ++j)
    allowance_[static_cast<Eigen::Index>(j)] =
        manipulator().leg(j).actuated_by_angle() ? allowed : allowed * manipulator().size();
}

std::optional<WorkingMode> SolutionProver::mode_of(const CertifiedPoint& point, double radius) const {
  WorkingMode mode(manipulator().leg_count());
  for (std::size_t j = 0; j < manipulator().leg_count(); ++j) {
    const int sign = certifier_.entry_sign(point, j, radius, allowance_[static_cast<Eigen::Index>(j)]);
    if (sign == 0) return std::nullopt;
    mode.set_sign(j, sign);
  }
  return mode;
}

// For all actuated values within the allowance the ball has one solution, which moves with them. The pose is
// that of some of these values: on the straight way from there to q the solution goes to that of q. It stays
// in the ball, where det A and B_jj do not vanish, and all constraints hold.
std::optional<ProvedSolution> SolutionProver::prove(const JointVector& q, const Pose& near) const {
  const RoundingUpward rounding;
  CertifiedPoint point;
  point.pose = near;
  point.q = q;
  if (!certifier_.evaluate(point)) return std::nullopt;
  const TaskVector still = TaskVector::Zero(allowance_.size());
  const CertifiedBall ball = certifier_.ball(point, still, allowance_, 0.0, 0.0);
  if (!ball.certified || !certifier_.assembles_within(point, allowance_)) return std::nullopt;
  const auto mode = mode_of(point, ball.radius);
  const int sign = certifier_.determinant_sign(point);
  if (!mode || sign == 0) return std::nullopt;
  const double turn = ball.radius / manipulator().characteristic_length();
  if (!segments_.prove_around(point.pose, ball.radius, turn, *mode).free) return std::nullopt;
  return ProvedSolution{point.pose, *mode, sign, ball.radius};
}

// A factor that rounding cannot make up for: no radius is below a billionth of the robot's size.
bool SolutionProver::differ(const ProvedSolution& first, const ProvedSolution& second) const {
  if (manipulator().task_space() == TaskSpace::R2) {
    const RoundingUpward rounding;
    return certifier_.distance(first.pose, second.pose) > 2.0 * (first.radius + second.radius);
  }
  const double turned =
      manipulator().characteristic_length() * first.pose.orientation.angularDistance(second.pose.orientation);
  const double moved = (first.pose.position - second.pose.position).norm();
  return std::hypot(turned, moved) > 2.0 * (first.radius + second.radius);
}

namespace {

// The rest searches for the paths.
constexpr double share_of_solutions = 0.9;

// Of the robot's size, and in rad.
constexpr double near_by = 1e-9;

/// A pose of a roadmap: by its side, and by its place there.
struct Vertex {
  std::size_t side = 0;
  std::uint32_t place = 0;
};

/// Two solutions in one aspect.
struct Pair {
  JointVector actuated;
  ProvedSolution from, to;
  bool is_straight = false;  // whether the segment between them is proved free
  double index = 0.0;        // the smaller parallel index

  bool is_worse_than(const Pair& other) const {
    return std::pair(is_straight, index) < std::pair(other.is_straight, other.index);
  }
};

class Survey {
 public:
  Survey(const PoseRoadmap& roadmap, const MapControl& control)
      : roadmap_(roadmap),
        control_(control),
        manipulator_(*roadmap.certifier().manipulator()),
        prover_(roadmap.certifier()) {
    for (const RoadmapSide& side : roadmap.sides()) {
      first_of_side_.push_back(result_.components.size());
      for (std::uint32_t i = 0; i < side.component_sizes.size(); ++i) {
        ComponentSurvey component;
        component.mode = side.mode;
        component.determinant_sign = side.determinant_sign;
        component.component = i;
        component.samples = side.component_sizes[i];
        result_.components.push_back(std::move(component));
      }
    }
    best_.resize(result_.components.size());
  }

  std::optional<AssemblySurvey> of(std::size_t poses) {
    const std::vector<Vertex> vertices = choose(poses);
    for (std::size_t i = 0; i < vertices.size() && !is_cancelled(control_); ++i) {
      look_at(vertices[i]);
      report(share_of_solutions * static_cast<double>(i + 1) / static_cast<double>(vertices.size()));
    }
    for (std::size_t i = 0; i < best_.size() && !is_cancelled(control_); ++i) {
      if (best_[i]) find_path(*best_[i], result_.components[i]);
      report(share_of_solutions +
             (1.0 - share_of_solutions) * static_cast<double>(i + 1) / static_cast<double>(best_.size()));
    }
    if (is_cancelled(control_)) return std::nullopt;
    return std::move(result_);
  }

 private:
  void report(double share) const {
    if (control_.progress) control_.progress(share);
  }

  std::size_t index_of(std::size_t side, std::uint32_t component) const {
    return first_of_side_[side] + component;
  }

  /// The poses in turn, one of each component.
  std::vector<Vertex> choose(std::size_t count) const {
    std::vector<std::vector<Vertex>> of_component(result_.components.size());
    std::size_t all = 0;
    for (std::size_t s = 0; s < roadmap_.sides().size(); ++s) {
      const RoadmapSide& side = roadmap_.sides()[s];
      for (std::uint32_t i = 0; i < side.poses.size(); ++i)
        of_component[index_of(s, side.component[i])].push_back({s, i});
      all += side.poses.size();
    }
    std::vector<Vertex> chosen;
    for (std::size_t turn = 0; chosen.size() < std::min(count, all); ++turn)
      for (const auto& vertices : of_component)
        if (turn < vertices.size() && chosen.size() < count) chosen.push_back(vertices[turn]);
    return chosen;
  }

  void look_at(const Vertex& vertex) {
    const RoadmapSide& side = roadmap_.sides()[vertex.side];
    const Pose& pose = roadmap_.poses()[side.poses[vertex.place]];
    const JointVector q = inverse(manipulator_, pose, side.mode).q;
    const DirectResult found = direct(manipulator_, q);
    const std::uint32_t own = side.component[vertex.place];
    const std::size_t index = index_of(vertex.side, own);
    ComponentSurvey& component = result_.components[index];
    ++result_.poses;
    ++component.poses;
    if (!found) ++result_.incomplete;
    std::vector<ProvedSolution> all, in_aspect;
    // The pose itself is one, even if the solver misses it.
    add(q, pose, side, own, all, in_aspect);
    for (const AssemblyMode& mode : found.solutions)
      if (!mode.serially_singular && !add(q, mode.pose, side, own, all, in_aspect)) ++component.unknown;
    ++result_.solutions[all.size()];
    ++component.in_aspect[in_aspect.size()];
    keep_best(q, in_aspect, best_[index]);
  }

  /// Adds a solution, if it is proved. False where it is not known whether it lies in the aspect of the pose.
  bool add(const JointVector& q, const Pose& pose, const RoadmapSide& side, std::uint32_t own,
           std::vector<ProvedSolution>& all, std::vector<ProvedSolution>& in_aspect) const {
    const auto solution = prover_.prove(q, pose);
    if (!solution) return lies_in_no_aspect(pose, side.mode);
    const bool is_new = std::all_of(all.begin(), all.end(), [&](const ProvedSolution& other) {
      return prover_.differ(*solution, other);
    });
    if (!is_new) return true;
    all.push_back(*solution);
    if (solution->mode != side.mode || solution->determinant_sign != side.determinant_sign) return true;
    if (locate(roadmap_, solution->pose, solution->mode).component != own) return false;
    in_aspect.push_back(*solution);
    return true;
  }

  /// Whether poses near a solution that is not proved are proved to violate a constraint.
  bool lies_in_no_aspect(const Pose& pose, const WorkingMode& mode) const {
    return roadmap_.certifier()
               .prove_around(pose, near_by * manipulator_.size(), near_by, mode)
               .proved_violation != Violation::none;
  }

  /// Keeps one of all pairs: one with a straight path, if there is any, and the farthest from singularities.
  void keep_best(const JointVector& q, const std::vector<ProvedSolution>& solutions,
                 std::optional<Pair>& best) const {
    std::vector<double> indices;
    for (const ProvedSolution& solution : solutions)
      indices.push_back(parallel_index(manipulator_, solution.pose, q));
    for (std::size_t i = 0; i < solutions.size(); ++i)
      for (std::size_t k = i + 1; k < solutions.size(); ++k) {
        Pair pair{q, solutions[i], solutions[k], true, std::min(indices[i], indices[k])};
        if (best && !best->is_worse_than(pair)) continue;  // however straight it is
        pair.is_straight = is_straight(solutions[i], solutions[k]);
        if (!best || best->is_worse_than(pair)) best = std::move(pair);
      }
  }

  bool is_straight(const ProvedSolution& from, const ProvedSolution& to) const {
    return roadmap_.certifier().prove(from.pose, to.pose, from.mode).verdict == SegmentVerdict::free;
  }

  void find_path(const Pair& pair, ComponentSurvey& component) const {
    AspectComparison found = same_aspect(roadmap_, {pair.from.pose, component.mode},
                                         {pair.to.pose, component.mode}, SearchEffort::thorough);
    if (found.answer == SameAspect::yes)
      component.change = AssemblyChange{pair.actuated, pair.from, pair.to, std::move(found.path)};
  }

  const PoseRoadmap& roadmap_;
  const MapControl& control_;
  const Manipulator& manipulator_;
  SolutionProver prover_;
  AssemblySurvey result_;
  std::vector<std::size_t> first_of_side_;  // indices of components
  std::vector<std::optional<Pair>> best_;   // by component
};

}  // namespace

std::optional<AssemblySurvey> survey_assembly_modes(const PoseRoadmap& roadmap, std::size_t poses,
                                                    const MapControl& control) {
  return Survey(roadmap, control).of(poses);
}

}  // namespace parallel_aspects
