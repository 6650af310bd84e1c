// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/path_shape.h"

#include "model/angles.h"
#include "motion/plan/leaf_path.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace parallel_aspects {
namespace {

constexpr int samples_of_a_segment = 32;  // as those of `least_index` of a path
// Corners are pulled again while that saves 1 % of the length; six rounds bound the time, since each proves
// all segments anew. Four pulls place a corner to a sixteenth of its way, and the next round begins from
// there.
constexpr int most_rounds = 6;
constexpr int pulls_of_a_corner = 4;
constexpr double worth_a_round = 0.01;             // of the length
constexpr double longest_turn = 0.25 * full_turn;  // of a segment
constexpr int most_parts = 64;                     // of one that turns further

class Shortening {
 public:
  Shortening(const SegmentsInMode& segments, double least_index)
      : segments_(segments), least_index_(least_index) {}

  std::vector<Pose> run(const std::vector<Pose>& path) const {
    std::vector<Pose> kept = without_detours(path);
    for (int round = 0; round < most_rounds && kept.size() > 2; ++round) {
      const double before = length_of(segments_.robot, kept);
      pull_corners(kept);
      kept = without_detours(kept);
      if (!(length_of(segments_.robot, kept) < (1.0 - worth_a_round) * before)) break;
    }
    return kept;
  }

 private:
  bool may_go(const Pose& from, const Pose& to) const {
    return segments_.is_free(from, to) &&
           (least_index_ <= 0.0 || least_index_along({from, to}, segments_) >= least_index_);
  }

  double distance(const Pose& a, const Pose& b) const { return distance_between(segments_.robot, a, b); }

  /// As many poses at once as doubling and halving finds.
  std::vector<Pose> without_detours(const std::vector<Pose>& path) const {
    std::vector<Pose> kept{path.front()};
    for (std::size_t at = 0; at + 1 < path.size();) {
      std::size_t good = at + 1, bad = path.size();
      for (std::size_t step = 2; at + step < path.size(); step *= 2) {
        if (!may_go(path[at], path[at + step])) {
          bad = at + step;
          break;
        }
        good = at + step;
      }
      while (bad - good > 1) {
        const std::size_t middle = good + (bad - good) / 2;
        (may_go(path[at], path[middle]) ? good : bad) = middle;
      }
      kept.push_back(path[good]);
      at = good;
    }
    return kept;
  }

  /// Each towards the segment past it: half the way, and by further halves as far as both segments are free.
  void pull_corners(std::vector<Pose>& path) const {
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const double to_before = distance(path[i - 1], path[i]), to_behind = distance(path[i], path[i + 1]);
      const Pose corner = path[i],
                 straight = segments_.between(path[i - 1], path[i + 1], to_before / (to_before + to_behind));
      double good = 0.0, step = 0.5;
      for (int k = 0; k < pulls_of_a_corner; ++k, step *= 0.5) {
        const Pose pulled = segments_.between(corner, straight, good + step);
        if (!may_go(path[i - 1], pulled) || !may_go(pulled, path[i + 1])) continue;
        good += step;
        path[i] = pulled;
      }
    }
  }

  const SegmentsInMode& segments_;
  double least_index_;
};

/// Poses between the ends of a segment; empty where the parts are not proved. The parts are motions of their
/// own, the nearer to that of the whole the shorter they are: a quaternion runs straight before it is
/// normalised.
std::vector<Pose> division(const Pose& from, const Pose& to, const SegmentsInMode& segments) {
  for (int parts = static_cast<int>(std::ceil(segments.turn(from, to) / longest_turn)); parts <= most_parts;
       parts *= 2) {
    std::vector<Pose> inner;
    bool are_free = true;
    for (int k = 1; k <= parts && are_free; ++k) {
      const Pose next = k == parts ? to : segments.between(from, to, static_cast<double>(k) / parts);
      are_free = segments.is_free(inner.empty() ? from : inner.back(), next);
      if (k < parts) inner.push_back(next);
    }
    if (are_free) return inner;
  }
  return {};
}

}  // namespace

double length_of(const Manipulator& robot, const std::vector<Pose>& path) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) sum += distance_between(robot, path[i], path[i + 1]);
  return sum;
}

double index_at(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
  const InverseSolution solution = inverse(robot, pose, mode);
  return solution.status == InverseStatus::out_of_reach ? 0.0 : parallel_index(robot, pose, solution.q);
}

double least_index_along(const std::vector<Pose>& path, const SegmentsInMode& segments) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    for (int k = 0; k <= samples_of_a_segment; ++k) {
      const Pose pose = segments.between(path[i], path[i + 1], static_cast<double>(k) / samples_of_a_segment);
      least = std::min(least, index_at(segments.robot, pose, segments.mode));
    }
  return least;
}

std::vector<Pose> with_short_turns(const std::vector<Pose>& path, const SegmentsInMode& segments) {
  std::vector<Pose> result;
  for (const Pose& pose : path) {
    if (!result.empty() && segments.turn(result.back(), pose) > longest_turn) {
      const std::vector<Pose> inner = division(result.back(), pose, segments);
      if (inner.empty()) return {};
      result.insert(result.end(), inner.begin(), inner.end());
    }
    result.push_back(pose);
  }
  return result;
}

std::vector<Pose> shortened(const std::vector<Pose>& path, const SegmentsInMode& segments,
                            double least_index) {
  return Shortening(segments, least_index).run(path);
}

}  // namespace parallel_aspects
