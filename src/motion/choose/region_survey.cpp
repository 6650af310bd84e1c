// SPDX-License-Identifier: BSD-3-Clause
#include "motion/choose/region_survey.h"

#include "aspects/tree/slice_space.h"
#include "interval/interval.h"
#include "model/message_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace parallel_aspects {
namespace {

constexpr int deepest_level = 90;  // halvings of one box; 30 in each of three coordinates

constexpr double index_gap = 0.1;           // between the bounds of the least index, of the upper one
constexpr std::size_t index_boxes = 20000;  // that are examined for it
constexpr double index_share = 0.3;         // see BoxClassifier::enclose_index

/// An angle in half turns, as a lower or an upper bound: two roundings of half a unit in the last place.
double half_turns(double angle, double towards) {
  double value = angle / EIGEN_PI;
  for (int i = 0; i < 3; ++i) value = std::nextafter(value, towards);
  return std::clamp(value, -2.0, 2.0);
}

Box map_box(Box box, std::optional<std::size_t> angle) {
  if (!angle) return box;
  for (std::size_t i = *angle; i < box.dimension; ++i) {
    box.lower[i] = half_turns(box.lower[i], -3.0);
    box.upper[i] = half_turns(box.upper[i], 3.0);
  }
  return box;
}

/// The same with angles from -1 to 1, cut where it goes on beyond. Without rounding, as 2 is added to numbers
/// from -2 to -1 alone, or taken from numbers from 1 to 2.
std::vector<Box> within_half_turns(const Box& region, std::size_t angle) {
  std::vector<Box> parts{region};
  for (std::size_t i = angle; i < region.dimension; ++i) {
    std::vector<Box> cut;
    for (const Box& part : parts)
      for (const double turns : {-2.0, 0.0, 2.0}) {
        Box piece = part;
        piece.lower[i] = std::max(part.lower[i], turns - 1.0) - turns;
        piece.upper[i] = std::min(part.upper[i], turns + 1.0) - turns;
        if (piece.lower[i] < piece.upper[i]) cut.push_back(piece);
      }
    parts = std::move(cut);
  }
  return parts;
}

/// The space that the boxes lie in; it may extend beyond the region.
std::shared_ptr<const PoseSpace> space_of(const Manipulator& manipulator, const RegionQuestion& question,
                                          const Box& region) {
  const double length = manipulator.characteristic_length();
  return question.slice ? make_slice_space(*question.slice, region, length)
                        : make_pose_space(manipulator.motions(), region, length);
}

Box positions_of(Box region, std::optional<std::size_t> angle) {
  if (angle) region.dimension = *angle;
  return region;
}

std::array<Box, 2> halves(const Box& box, std::size_t i) {
  std::array<Box, 2> result{box, box};
  result[0].upper[i] = result[1].lower[i] = box.center(i);
  return result;
}

Box point_box(const Box& box) { return {box.dimension, box.middle(), box.middle()}; }

/// A box with the least index that it can hold.
struct Bounded {
  double lower = 0.0;
  Box box;
  bool operator<(const Bounded& other) const { return lower > other.lower; }
};

}  // namespace

RegionSurvey::RegionSurvey(const Manipulator& manipulator, const RegionQuestion& question,
                           std::optional<std::size_t> angle)
    : modes_(working_modes(manipulator)),
      classifier_(question.slice ? make_slice_classifier(manipulator, modes_, *question.slice)
                                 : make_box_classifier(manipulator, modes_)),
      angle_(angle.value_or(max_map_dimension)),
      region_(map_box(question.region, angle)),
      space_(space_of(manipulator, question, positions_of(region_, angle))),
      found_(modes_.size()) {}

std::vector<ModeInRegion> RegionSurvey::run(const RegionChoiceOptions& options) {
  const RoundingUpward rounding;
  const ModeSet all = modes_.size() == 64 ? ~ModeSet{0} : (ModeSet{1} << modes_.size()) - 1;
  for (const Box& box : within_half_turns(region_, angle_)) parts_.push_back({box, all, 0});
  for (std::size_t looked = 0; !parts_.empty() && looked < options.boxes && !is_cancelled(options.control);
       ++looked) {
    const Part part = parts_.front();
    parts_.pop_front();
    look_at(part);
  }
  for (const Part& part : parts_) leave_open(part);
  std::vector<ModeInRegion> result;
  for (std::size_t mode = 0; mode < modes_.size(); ++mode) result.push_back(conclude(mode));
  return result;
}

void RegionSurvey::look_at(const Part& part) {
  const ModeSet open = part.open & ~refuted_;
  if (open == 0) return;
  std::array<LeafState, 64> states;
  classifier_->classify(0, part.box, open, Detail::centers, states.data());
  ModeSet inside = 0, undecided = 0;
  for (std::size_t mode = 0; mode < modes_.size(); ++mode)
    if ((open >> mode & 1U) != 0) take(mode, states[mode], part, inside, undecided);
  if (inside != 0) inside_.push_back({part.box, inside});
  if (undecided != 0) halve(part, undecided);
}

void RegionSurvey::take(std::size_t mode, const LeafState& state, const Part& part, ModeSet& inside,
                        ModeSet& undecided) {
  Found& found = found_[mode];
  const ModeSet bit = ModeSet{1} << mode;
  const int sign = state.is_inside() ? (state.is_inside(1) ? 1 : -1) : state.center_sign();
  if (sign != 0) found.with_sign[sign > 0 ? 0 : 1] = part.box.middle();
  if (state.is_outside()) found.outside = part.box.middle();
  if (state.is_inside()) inside |= bit;
  if (state.is_undecided()) undecided |= bit;
  if (found.is_refuted()) refuted_ |= bit;
}

void RegionSurvey::halve(const Part& part, ModeSet open) {
  if (part.level == deepest_level) return leave_open({part.box, open, part.level});
  for (const Box& half : halves(part.box, longest_edge(part.box)))
    parts_.push_back({half, open, part.level + 1});
}

void RegionSurvey::leave_open(const Part& part) {
  for (std::size_t mode = 0; mode < modes_.size(); ++mode)
    if ((part.open >> mode & 1U) != 0) found_[mode].undecided += part.box.measure();
}

std::size_t RegionSurvey::longest_edge(const Box& box) const {
  const MapPoint weights = space_->weights();
  std::size_t longest = 0;
  for (std::size_t i = 1; i < box.dimension; ++i)
    if (box.width(i) * weights[i] > box.width(longest) * weights[longest]) longest = i;
  return longest;
}

ModeInRegion RegionSurvey::conclude(std::size_t mode) const {
  const Found& found = found_[mode];
  ModeInRegion result;
  result.mode = modes_[mode];
  if (found.outside) {
    result.answer = TrajectoryAnswer::unsafe;
    result.witnesses = {pose(*found.outside)};
    result.reason = "Proved: a pose of the region lies in no aspect.";
  } else if (found.is_refuted()) {
    result.answer = TrajectoryAnswer::unsafe;
    result.witnesses = {pose(*found.with_sign[0]), pose(*found.with_sign[1])};
    result.reason = "Proved: det A differs in sign at two poses of the region, which no path joins.";
  } else if (found.undecided > 0.0) {
    result.undecided = std::min(1.0, found.undecided / region_.measure());
    result.reason = "Not proved in " + number_text(result.undecided, 3) + " of the region.";
  } else {
    result.answer = TrajectoryAnswer::safe;
    result.determinant_sign = found.with_sign[0] ? 1 : -1;
    result.least_index = least_index(mode, result.determinant_sign);
    result.reason = "Proved: all of the region lies in one aspect.";
  }
  return result;
}

// Always divides the box that may hold the least: its lower bound is that of all.
IndexRange RegionSurvey::least_index(std::size_t mode, int sign) const {
  IndexRange range{0.0, std::numeric_limits<double>::infinity()};
  std::priority_queue<Bounded> boxes;
  const auto bound = [&](const Box& box) {
    return classifier_->enclose_index(0, box, mode, sign, ParallelIndex::normalised, index_share);
  };
  const auto add = [&](const Box& box) {
    range.upper = std::min(range.upper, bound(point_box(box)).upper());
    boxes.push({std::max(0.0, bound(box).lower()), box});
  };
  for (const Inside& inside : inside_)
    if ((inside.modes >> mode & 1U) != 0) add(inside.box);
  for (std::size_t i = 0; i < index_boxes && boxes.top().lower < (1.0 - index_gap) * range.upper; ++i) {
    const Box box = boxes.top().box;
    boxes.pop();
    for (const Box& half : halves(box, longest_edge(box))) add(half);
  }
  range.lower = boxes.top().lower;
  return range;
}

std::vector<Pose> RegionSurvey::corners() const {
  std::vector<Pose> result;
  for (std::size_t corner = 0; corner < std::size_t{1} << region_.dimension; ++corner) {
    MapPoint point{};
    for (std::size_t i = 0; i < region_.dimension; ++i)
      point[i] = (corner >> i & 1U) != 0 ? region_.upper[i] : region_.lower[i];
    result.push_back(pose(point));
  }
  return result;
}

}  // namespace parallel_aspects
