// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_CLASSIFIER_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_CLASSIFIER_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/boxes/chart_evaluation.h"
#include "aspects/boxes/wedge_proof.h"

#include <optional>
#include <vector>

namespace parallel_aspects {

/// Boxes of one chart (see charts.h). Legs are evaluated once for all working modes.
template <class Chart>
class ChartClassifier final : public BoxClassifier {
  using Evaluation = ChartEvaluation<Chart>;
  using Signs = typename Evaluation::Signs;

 public:
  /// `more`: what the chart is made of besides the manipulator.
  template <class... More>
  ChartClassifier(const Manipulator& manipulator, const std::vector<WorkingMode>& modes,
                  const BoxPolicy& policy, const More&... more)
      : BoxClassifier(policy),
        chart_(made_under_upward_rounding<Chart>(manipulator, more...)),
        tests_(made_under_upward_rounding<typename Evaluation::Tests>(manipulator)) {
    for (const WorkingMode& mode : modes) signs_.push_back(signs_of(mode));
  }

  void classify(RootIndex root, const Box& box, ModeSet modes, Detail detail,
                LeafState* states) const noexcept override {
    Evaluation evaluation(chart_, tests_, root, box);
    evaluation.evaluate_by_intervals();
    ModeSet open = classify(evaluation, modes, states);
    if (open == 0) return;
    evaluation.evaluate_by_affine_forms();
    open = classify(evaluation, open, states);
    if (detail != Detail::states) add_parts(root, evaluation, open, detail, states);
  }

  Examined examine(RootIndex root, const Box& box, std::size_t mode, int sign) const noexcept override {
    Evaluation evaluation(chart_, tests_, root, box);
    evaluation.evaluate_by_intervals();
    LeafState state = evaluation.state(signs_[mode]);
    if (!state.is_undecided()) return {state, Monotonicity::unknown(), std::nullopt};
    evaluation.evaluate_by_affine_forms();
    state = evaluation.state(signs_[mode]);
    if (!state.may_be(sign) || state.is_inside()) return {state, Monotonicity::unknown(), std::nullopt};
    const Monotonicity monotonicity = evaluation.monotonicity(signs_[mode], sign);
    if (monotonicity.along_all(box)) return {state, monotonicity, std::nullopt};
    return {state, monotonicity, policy().shells ? evaluation.shell(signs_[mode], sign) : std::nullopt};
  }

  std::optional<MapPoint> find_wedge(RootIndex root, const Box& box, std::size_t mode,
                                     int sign) const noexcept override {
    if (!policy().wedges) return std::nullopt;
    Evaluation evaluation(chart_, tests_, root, box);
    if (!evaluation.evaluate_by_both()) return std::nullopt;
    return WedgeProof<Chart>(chart_, root, evaluation, signs_[mode], sign, policy()).find();
  }

  BoxFacts facts(RootIndex root, const Box& box, std::size_t mode) const noexcept override {
    Evaluation evaluation(chart_, tests_, root, box);
    evaluation.evaluate_by_intervals();
    evaluation.evaluate_by_affine_forms();
    return evaluation.facts(signs_[mode]);
  }

  Conditions conditions(const MapPosition& position, std::size_t mode, int sign) const noexcept override {
    const Box box{Chart::coordinate_count, position.point, position.point};
    Evaluation evaluation(chart_, tests_, position.root, box);
    evaluation.evaluate_by_intervals();
    evaluation.evaluate_by_affine_forms();
    return evaluation.conditions(signs_[mode], sign);
  }

  void find_unknown_constraints(RootIndex root, const Box& box, ModeSet modes,
                                ConstraintKinds* kinds) const noexcept override {
    Evaluation evaluation(chart_, tests_, root, box);
    evaluation.evaluate_by_intervals();
    evaluation.evaluate_by_affine_forms();
    for_each(modes, [&](std::size_t mode) { kinds[mode] = evaluation.unknown_constraints(signs_[mode]); });
  }

  std::optional<Box> reachable_positions() const override { return chart_.reachable_positions(); }

 private:
  template <class Made, class... More>
  static Made made_under_upward_rounding(const Manipulator& manipulator, const More&... more) {
    const RoundingUpward rounding;
    return Made(manipulator, more...);
  }

  static Signs signs_of(const WorkingMode& mode) {
    Signs signs;
    for (std::size_t j = 0; j < signs.size(); ++j) signs[j] = mode.sign(j);
    return signs;
  }

  template <class Action>
  void for_each(ModeSet modes, const Action& action) const {
    for (std::size_t mode = 0; mode < signs_.size(); ++mode)
      if ((modes >> mode & 1U) != 0) action(mode);
  }

  /// Writes the states of `modes`; returns those that stay undecided.
  ModeSet classify(Evaluation& evaluation, ModeSet modes, LeafState* states) const {
    ModeSet open = 0;
    for_each(modes, [&](std::size_t mode) {
      states[mode] = evaluation.state(signs_[mode]);
      if (states[mode].is_undecided()) open |= ModeSet{1} << mode;
    });
    return open;
  }

  void add_parts(RootIndex root, Evaluation& evaluation, ModeSet modes, Detail detail,
                 LeafState* states) const {
    for_each(modes, [&](std::size_t mode) {
      LeafState& state = states[mode];
      for (const int sign : {1, -1})
        if (detail != Detail::centers && state.may_be(sign) &&
            is_whole(root, evaluation, signs_[mode], sign, detail))
          state = state.with_whole(sign);
      const int center = evaluation.center_sign(signs_[mode]);
      if (center != 0) state = state.with_center(center);
    });
  }

  bool is_whole(RootIndex root, Evaluation& evaluation, const Signs& signs, int sign, Detail detail) const {
    if (evaluation.is_whole(signs, sign, detail, policy())) return true;
    return detail == Detail::all_parts && policy().wedges &&
           WedgeProof<Chart>(chart_, root, evaluation, signs, sign, policy()).find();
  }

  Chart chart_;
  typename Evaluation::Tests tests_;
  std::vector<Signs> signs_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_CLASSIFIER_H
