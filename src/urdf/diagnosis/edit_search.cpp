// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/chain.h"
#include "urdf/closing/planar_layers.h"
#include "urdf/diagnosis/diagnosis.h"
#include "urdf/recognition/platform_motion.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int starts = 8;  // from which loops are to close: few, as most of what is tried does not
constexpr std::size_t max_closed = 3;  // configurations whose mobility is examined: one may be singular
constexpr std::size_t max_named = 8;   // edits that a message lists: a longer list is not read
// What bounds a refusal: sorting an edit out takes up to a millisecond, recognising a hexapod some thirty.
constexpr std::size_t max_tried = 1500, max_attempts = 36;

bool is_open(const Closure& closure) { return closure.type == ClosureType::automatic; }

}  // namespace

bool moves_a_body(const ClosureSystem& system, const Assembly& assembly,
                  const ActuatedJoints& actuated_joints, const SourceNames& files) {
  Problems unused;
  const auto motion = find_platform_motion(system, assembly, actuated_joints, files, unused);
  return motion && !(motion->space == TaskSpace::T3 && motion->point_platform);
}

std::vector<std::size_t> loops_that_stay_open(const Subject& subject) {
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < subject.system.closures().size(); ++k) {
    const ClosureSystem loop(subject.shared_tree, subject.resolved.base, {subject.system.closures()[k]});
    if (closed_configurations(loop, starts, 1).empty()) open.push_back(k);
  }
  return open;
}

EditSearch::EditSearch(const Subject& subject, const Attempt& attempt)
    : s_(subject), attempt_(attempt), gaps_(subject.tree, subject.resolved) {}

bool EditSearch::try_all(const Edits& edits) {
  for (const Edit& edit : edits) try_one(edit);
  return !working_.empty();
}

void EditSearch::try_before(const Edits& edits) {
  const auto count = static_cast<std::ptrdiff_t>(working_.size());
  try_all(edits);
  std::rotate(working_.begin(), working_.begin() + count, working_.end());
}

void EditSearch::try_one(const Edit& edit) {
  const bool is_edited = std::any_of(working_.begin(), working_.end(), [&](const Working& other) {
    return other.edit.element == edit.element;
  });
  if (is_edited || !known_.insert(edit.remedy).second) return;
  is_complete_ = is_complete_ && tried_ < max_tried && attempts_ < max_attempts;
  if (!is_complete_) return;
  ++tried_;
  Edited after = edited(s_, edit);
  if (!gaps_.allow(*after.tree, after.resolved)) return;
  join_layers(*after.tree, after.resolved.actuated_joints.platform_link, s_.files, after.resolved.closures);
  if (!closes_and_moves(after)) return;
  ++attempts_;
  if (const auto space = attempt_(after.tree, after.resolved)) working_.push_back({edit, *space});
}

bool EditSearch::closes_and_moves(const Edited& after) const {
  const std::vector<Closure>& closures = after.resolved.closures;
  if (closures.size() == s_.resolved.closures.size())
    for (const std::size_t loop : open_loops_)
      if (closed_configurations(
              {after.tree, after.resolved.base, with_type({closures[loop]}, ClosureType::point)}, starts, 1)
              .empty())
        return false;
  return closes_and_moves(after, ClosureType::point) ||
         (std::any_of(closures.begin(), closures.end(), is_open) &&
          closes_and_moves(after, ClosureType::revolute));
}

// Where it is open which joints are actuated, mobility says nothing.
bool EditSearch::closes_and_moves(const Edited& after, ClosureType type_of_open_ones) const {
  const ResolvedConfig& config = after.resolved;
  const bool is_listed = config.actuation_origin.empty();
  if (is_listed && !is_actuation_count(config.actuated_joints.variables.size())) return false;
  const ClosureSystem system(after.tree, config.base, with_type(config.closures, type_of_open_ones));
  const auto closed = closed_configurations(system, starts, is_listed ? max_closed : 1);
  return std::any_of(closed.begin(), closed.end(), [&](const Eigen::VectorXd& values) {
    return !is_listed || moves_a_body(system, {values, loop_motions(system, values).motions, 0.0},
                                      config.actuated_joints, s_.files);
  });
}

Diagnosis EditSearch::diagnosis() const {
  const Working& first = working_.front();
  if (working_.size() == 1 && is_complete_)
    return {
        {(first.edit.fault + "; " + first.edit.remedy + ", which makes it a robot in " + first.space + ".")
             .text()},
        Diagnosis::Kind::remedy};
  std::string text = s_.files.urdf + " and " + s_.files.config +
                     " do not make a robot, and each of these corrections alone would make it one: ";
  for (std::size_t k = 0; k < working_.size() && k < max_named; ++k)
    text += (k == 0 ? "" : "; or ") + working_[k].edit.remedy + " (" + working_[k].space + ")";
  return {{text + (is_complete_ && working_.size() <= max_named ? "." : "; there may be others.")},
          Diagnosis::Kind::remedy};
}

}  // namespace parallel_aspects
