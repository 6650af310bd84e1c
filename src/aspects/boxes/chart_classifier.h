// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_CLASSIFIER_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_CLASSIFIER_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/boxes/box_proofs.h"
#include "aspects/boxes/box_slopes.h"
#include "aspects/boxes/index_on_arcs.h"
#include "aspects/boxes/point_conditions.h"
#include "aspects/boxes/wedge_proof.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Boxes of one chart (see charts.h). Legs are evaluated once for all working modes.
template <class Chart>
class ChartClassifier final : public BoxClassifier {
  using Intervals = BoxIntervals<Chart>;
  using Forms = BoxForms<Chart>;
  using Slopes = BoxSlopes<Chart>;
  using Signs = typename Slopes::Signs;
  using Tests = ConstraintTests<Chart::point_dimension>;

 public:
  /// `more`: what the chart is made of besides the manipulator.
  template <class... More>
  ChartClassifier(const Manipulator& manipulator, const std::vector<WorkingMode>& modes,
                  const BoxPolicy& policy, const More&... more)
      : BoxClassifier(policy),
        chart_(made_under_upward_rounding<Chart>(manipulator, more...)),
        tests_(made_under_upward_rounding<Tests>(manipulator)) {
    for (const WorkingMode& mode : modes) signs_.push_back(signs_of(mode));
  }

  void classify(RootIndex root, const Box& box, ModeSet modes, Detail detail,
                LeafState* states) const noexcept override {
    StatesByMode<Chart, double> found(signs_, static_cast<std::int64_t>(modes));
    found.template find<true>(at(root, box), detail, policy());
    for_each(modes, [&](std::size_t mode) { states[mode] = state_of(found[mode]); });
  }

  Examined examine(RootIndex root, const Box& box, std::size_t mode, int sign) const noexcept override {
    return ExaminedBoxes<Chart, double>(at(root, box), signs_[mode], sign, policy().shells).lane(0);
  }

  std::optional<MapPoint> find_wedge(RootIndex root, const Box& box, std::size_t mode,
                                     int sign) const noexcept override {
    if (!policy().wedges) return std::nullopt;
    const Intervals intervals(at(root, box));
    if (intervals.reachable_nowhere()) return std::nullopt;
    const Forms forms(intervals);
    if (!forms.single_unclear_leg(signs_[mode])) return std::nullopt;  // slopes cost more than asking
    return WedgeProof<Chart>(Slopes(forms), signs_[mode], sign, policy()).find();
  }

  BoxFacts facts(RootIndex root, const Box& box, std::size_t mode) const noexcept override {
    const Signs& signs = signs_[mode];
    const Intervals intervals(at(root, box));
    const Forms forms(intervals);
    BoxFacts facts = leg_facts(forms);
    if (forms.reachable_nowhere()) return facts;
    facts.within_limits =
        both(forms.within_limits(signs), forms.is_allowed_otherwise(signs)) == Verdict::holds;
    const ProvedSign<bool> sign = forms.proved_sign(forms.determinant(signs), signs);
    facts.determinant_sign = sign.positive ? 1 : sign.negative ? -1 : 0;
    if (facts.determinant_sign != 0 || !forms.entries().all_clear()) return facts;
    const auto gradient = Slopes(forms).determinant_gradient(signs);
    std::copy(gradient.begin(), gradient.end(), facts.determinant_slope.begin());
    return facts;
  }

  Conditions conditions(const MapPosition& position, std::size_t mode, int sign) const noexcept override {
    const Box box{Chart::coordinate_count, position.point, position.point};
    return PointConditions<Chart>(at(position.root, box)).of(signs_[mode], sign);
  }

  Interval enclose_index(RootIndex root, const Box& box, std::size_t mode, int sign, ParallelIndex index,
                         double share) const noexcept override {
    const EnclosedIndex found =
        BoundedIndices<Chart, double>(at(root, box), signs_[mode], sign, index, share).lane(0);
    return found.may_be_closer ? enclose_index_on_arcs(root, box, mode, sign, index, found.range)
                               : found.range;
  }

  /// The last of the work that `enclose_index` does, where the rest was done before.
  Interval enclose_index_on_arcs(RootIndex root, const Box& box, std::size_t mode, int sign,
                                 ParallelIndex index, const Interval& known) const noexcept {
    const Intervals intervals(at(root, box));
    return IndexOnArcs<Chart>(intervals, signs_[mode]).closer(known, index, sign);
  }

  void find_unknown_constraints(RootIndex root, const Box& box, ModeSet modes,
                                ConstraintKinds* kinds) const noexcept override {
    const Intervals intervals(at(root, box));
    if (is_limited_only()) return find_unknown_limits(intervals, modes, kinds);
    const Forms forms(intervals);
    for_each(modes, [&](std::size_t mode) { kinds[mode] = forms.unknown_constraints(signs_[mode]); });
  }

  std::optional<Box> reachable_positions() const override { return chart_.reachable_positions(); }

  const Chart& chart() const noexcept { return chart_; }

  /// Of B_jj, by working mode.
  const std::vector<Signs>& signs() const noexcept { return signs_; }

  const Tests& tests() const noexcept { return tests_; }

  /// Whether limits of actuated joints are the only constraints.
  bool is_limited_only() const noexcept { return tests_.none() && !tests_.margins().any(); }

 private:
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

  ChartBox<Chart> at(RootIndex root, const Box& box) const { return {chart_, tests_, root, box}; }

  /// Joint values are compared with limits by intervals in every stage: affine forms tell more of B_jj alone.
  void find_unknown_limits(const Intervals& intervals, ModeSet modes, ConstraintKinds* kinds) const {
    for_each(modes, [&](std::size_t mode) {
      kinds[mode][index_of(ConstraintKind::actuated_limits)] =
          !intervals.reachable_nowhere() && intervals.within_limits(signs_[mode]) == Verdict::unknown;
    });
  }

  static BoxFacts leg_facts(const Forms& forms) {
    const BoxEntries<Chart::leg_count>& entries = forms.entries();
    BoxFacts facts;
    for (std::size_t j = 0; j < Chart::leg_count; ++j) {
      facts.legs |= BoxFacts::bit(j);
      if (entries.clear(j)) facts.clear |= BoxFacts::bit(j);
      if (forms.keeps_serial_margin(j) == Verdict::holds) facts.serial_margins |= BoxFacts::bit(j);
      if (entries.square(j).upper() <= 0.0) facts.unreachable |= BoxFacts::bit(j);
    }
    return facts;
  }

  Chart chart_;
  Tests tests_;
  std::vector<Signs> signs_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_CLASSIFIER_H
