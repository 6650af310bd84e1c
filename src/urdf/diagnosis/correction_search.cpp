// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/diagnosis/correction_search.h"

#include "urdf/closing/actuation_choices.h"
#include "urdf/closing/assembly.h"
#include "urdf/closing/planar_layers.h"
#include "urdf/corrections/chain_corrections.h"
#include "urdf/corrections/closure_end_corrections.h"
#include "urdf/corrections/frame_corrections.h"
#include "urdf/corrections/gap_corrections.h"
#include "urdf/corrections/joint_corrections.h"
#include "urdf/corrections/listed_corrections.h"
#include "urdf/corrections/missing_joints.h"
#include "urdf/corrections/unit_corrections.h"
#include "urdf/recognition/platform_motion.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int starts = 8;                 // from which loops are to close
constexpr std::size_t max_closed = 3;     // configurations whose mobility is looked at
constexpr std::size_t max_named = 8;      // corrections that a message lists
constexpr std::size_t max_tried = 1500;   // of corrections, each of which takes up to a millisecond
constexpr std::size_t max_attempts = 12;  // of those to recognise the mechanism, each of which takes longer

std::vector<Closure> typed(const std::vector<Closure>& closures) {
  return with_type(closures, ClosureType::point);
}

void append(Corrections& all, Corrections more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

Correction together(const Correction& first, const Correction& second) {
  return {first.element, first.fault + ", and " + second.fault, first.remedy + " and " + second.remedy, false,
          [one = first.apply, other = second.apply](Tree& tree, ResolvedConfig& resolved) {
            one(tree, resolved);
            other(tree, resolved);
          }};
}

}  // namespace

bool moves_a_body(const ClosureSystem& system, const Assembly& assembly,
                  const ActuatedJoints& actuated_joints, const SourceNames& files) {
  Problems unused;
  const auto motion = find_platform_motion(system, assembly, actuated_joints, files, unused);
  return motion && !(motion->space == TaskSpace::T3 && motion->point_platform);
}

CorrectionSearch::CorrectionSearch(std::shared_ptr<const Tree> tree, const ResolvedConfig& resolved,
                                   bool closes, const SourceNames& files, const Attempt& attempt)
    : tree_(std::move(tree)),
      resolved_(resolved),
      files_(files),
      attempt_(attempt),
      system_(tree_, resolved.base, typed(resolved.closures)),
      loops_(*tree_, resolved.closures, system_.size()),
      gaps_(*tree_, resolved) {
  if (!closes) open_loops_ = open_loops();
  collect();
}

// Each alone.
std::vector<std::size_t> CorrectionSearch::open_loops() const {
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < system_.closures().size(); ++k) {
    const ClosureSystem loop(tree_, resolved_.base, {system_.closures()[k]});
    if (closed_configurations(loop, starts, 1).empty()) open.push_back(k);
  }
  return open;
}

// A joint is in all loops that cannot be closed; those that are like others come last.
std::vector<std::size_t> CorrectionSearch::suspects() const {
  std::vector<std::size_t> joints = loops_.all();
  for (const std::size_t loop : open_loops_) {
    const LoopJoints of_loop(*tree_, {system_.closures()[loop]}, system_.size());
    joints.erase(std::remove_if(joints.begin(), joints.end(),
                                [&](std::size_t joint) {
                                  return std::count(of_loop.all().begin(), of_loop.all().end(), joint) == 0;
                                }),
                 joints.end());
  }
  std::stable_partition(joints.begin(), joints.end(),
                        [this](std::size_t joint) { return !loops_.is_like_others(joint); });
  return joints;
}

// Those that cannot be closed alone, or all.
std::vector<std::size_t> CorrectionSearch::suspected_closures() const {
  std::vector<std::size_t> closures = open_loops_;
  for (std::size_t k = 0; open_loops_.empty() && k < resolved_.closures.size(); ++k) closures.push_back(k);
  return closures;
}

void CorrectionSearch::collect() {
  if (resolved_.actuation_origin.empty())
    append(corrections_, actuation_corrections(*tree_, resolved_, system_, files_));
  append(corrections_, unit_corrections(*tree_, resolved_, loops_, system_.size(), files_));
  append(corrections_, series_corrections(*tree_, resolved_, loops_, files_));
  append(corrections_, closure_corrections(resolved_, files_));
  append(corrections_, exchanged_ends(*tree_, resolved_, files_));
  append(corrections_, closure_place_corrections(*tree_, resolved_, suspected_closures(), files_));
  for (const std::size_t joint : suspects()) {
    const bool is_fixed = tree_->joints[joint].motion == JointMotion::fixed;
    if (is_fixed) append(corrections_, gap_corrections(*tree_, loops_, joint, files_));
    append(corrections_, joint_corrections(*tree_, resolved_, loops_, joint, files_));
    if (!is_fixed) append(corrections_, gap_corrections(*tree_, loops_, joint, files_));
  }
}

std::optional<Diagnosis> CorrectionSearch::of_frames() {
  for (const Corrections& kind : frame_corrections(*tree_, resolved_, system_, files_))
    if (working_of(kind)) return with_rivals();
  return std::nullopt;
}

std::optional<Diagnosis> CorrectionSearch::of_point() {
  return working_of(point_corrections(*tree_, resolved_, system_, files_));
}

std::optional<Diagnosis> CorrectionSearch::of_missing_joints() {
  return working_of(missing_joint_corrections(*tree_, resolved_, system_, files_));
}

std::optional<Diagnosis> CorrectionSearch::of_chains() {
  for (const Corrections& kind : chain_corrections(*tree_, resolved_, system_, files_))
    if (auto diagnosis = working_of(kind)) return diagnosis;
  return std::nullopt;
}

// Into a loop, where they were in none before.
bool CorrectionSearch::takes_in_joints(const Correction& correction) const {
  auto tree = std::make_shared<Tree>(*tree_);
  ResolvedConfig config = resolved_;
  correction.apply(*tree, config);
  const ClosureSystem system(tree, config.base, typed(config.closures));
  const auto count = [](const std::vector<bool>& joints) {
    return std::count(joints.begin(), joints.end(), true);
  };
  return count(system.in_loop()) > count(system_.in_loop());
}

// A chain that was loose speaks for what takes it in. Else a frame that a joint lets loose may be put onto
// another link, or the joint be fixed: corrections of joints come first, as they change less than what is
// joined to what.
Diagnosis CorrectionSearch::with_rivals() {
  const auto frames = static_cast<std::ptrdiff_t>(working_.size());
  if (std::any_of(working_.begin(), working_.end(),
                  [this](const Working& working) { return takes_in_joints(working.correction); }))
    return diagnosis();
  for (const Correction& correction : corrections_)
    if (correction.like_others || correction.fixes_joint) try_one(correction);
  std::rotate(working_.begin(), working_.begin() + frames, working_.end());
  return diagnosis();
}

std::optional<Diagnosis> CorrectionSearch::of_frames_and_actuation() {
  if (!resolved_.actuation_origin.empty()) return std::nullopt;
  for (const Corrections& kind : frame_corrections(*tree_, resolved_, system_, files_))
    if (auto diagnosis = working_of(with_actuation(kind))) return diagnosis;
  return std::nullopt;
}

// Each with those of the actuated joints that are like others once it is applied.
Corrections CorrectionSearch::with_actuation(const Corrections& kind) const {
  Corrections both;
  for (const Correction& first : kind) {
    auto tree = std::make_shared<Tree>(*tree_);
    ResolvedConfig config = resolved_;
    first.apply(*tree, config);
    const ClosureSystem system(tree, config.base, typed(config.closures));
    for (const Correction& second : actuation_corrections(*tree, config, system, files_))
      if (second.like_others) both.push_back(together(first, second));
  }
  return both;
}

std::optional<Diagnosis> CorrectionSearch::like_others() {
  Corrections like_others;
  for (const Correction& correction : corrections_)
    if (correction.like_others) like_others.push_back(correction);
  return working_of(like_others);
}

std::optional<Diagnosis> CorrectionSearch::others() {
  Corrections others;
  for (const Correction& correction : corrections_)
    if (!correction.like_others) others.push_back(correction);
  return working_of(others);
}

std::optional<Diagnosis> CorrectionSearch::working_of(const Corrections& corrections) {
  for (const Correction& correction : corrections) try_one(correction);
  return working_.empty() ? std::nullopt : std::optional<Diagnosis>(diagnosis());
}

void CorrectionSearch::try_one(const Correction& correction) {
  const bool is_corrected = std::any_of(working_.begin(), working_.end(), [&](const Working& other) {
    return other.correction.element == correction.element;
  });
  if (is_corrected) return;
  is_complete_ = is_complete_ && tried_ < max_tried && attempts_ < max_attempts;
  if (!is_complete_) return;
  ++tried_;
  auto tree = std::make_shared<Tree>(*tree_);
  ResolvedConfig config = resolved_;
  correction.apply(*tree, config);
  place_at_zero(*tree, config.closures);
  if (!gaps_.allow(*tree, config)) return;
  join_layers(*tree, config.actuated_joints.platform_link, files_, config.closures);
  if (!closes_and_moves(tree, config)) return;
  ++attempts_;
  if (const auto space = attempt_(tree, config)) working_.push_back({correction, *space});
}

bool CorrectionSearch::closes_and_moves(const std::shared_ptr<const Tree>& tree,
                                        const ResolvedConfig& config) {
  if (config.closures.size() == resolved_.closures.size())
    for (const std::size_t loop : open_loops_)
      if (closed_configurations({tree, config.base, {typed(config.closures)[loop]}}, starts, 1).empty())
        return false;
  const bool any_open =
      std::any_of(config.closures.begin(), config.closures.end(),
                  [](const Closure& closure) { return closure.type == ClosureType::automatic; });
  return closes_and_moves(tree, config, ClosureType::point) ||
         (any_open && closes_and_moves(tree, config, ClosureType::revolute));
}

// Where it is open which joints are actuated, mobility tells nothing.
bool CorrectionSearch::closes_and_moves(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& config,
                                        ClosureType type_of_open_ones) {
  const bool is_listed = config.actuation_origin.empty();
  if (is_listed && !is_actuation_count(config.actuated_joints.variables.size())) return false;
  const ClosureSystem system(tree, config.base, with_type(config.closures, type_of_open_ones));
  const auto closed = closed_configurations(system, starts, is_listed ? max_closed : 1);
  return std::any_of(closed.begin(), closed.end(), [&](const Eigen::VectorXd& values) {
    return !is_listed || moves_a_body(system, {values, loop_motions(system, values).motions, 0.0},
                                      config.actuated_joints, files_);
  });
}

Diagnosis CorrectionSearch::diagnosis() const {
  const Working& first = working_.front();
  if (working_.size() == 1 && is_complete_)
    return with_remedy(first.correction.fault + "; " + first.correction.remedy +
                       ", which makes it a robot in " + first.space + ".");
  std::string text = files_.urdf + " and " + files_.config +
                     " do not make a robot, and each of these corrections alone would make it one: ";
  for (std::size_t k = 0; k < working_.size() && k < max_named; ++k)
    text += (k == 0 ? "" : "; or ") + working_[k].correction.remedy + " (" + working_[k].space + ")";
  return with_remedy(text + (is_complete_ && working_.size() <= max_named ? "." : "; there may be others."));
}

}  // namespace parallel_aspects
