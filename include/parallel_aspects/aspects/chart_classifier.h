// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CHART_CLASSIFIER_H
#define PARALLEL_ASPECTS_ASPECTS_CHART_CLASSIFIER_H

#include "parallel_aspects/aspects/box_classifier.h"
#include "parallel_aspects/aspects/dual.h"
#include "parallel_aspects/aspects/leg_rows.h"
#include "parallel_aspects/aspects/limit_verdict.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Boxes of one chart (see charts.h). B_jj^2 and det A are enclosed by their natural interval extensions and,
/// where these do not tell signs, by their mean-value forms. Legs are evaluated once for all working modes.
template <class Chart>
class ChartClassifier final : public BoxClassifier {
 public:
  ChartClassifier(const Manipulator& manipulator, const std::vector<WorkingMode>& modes)
      : chart_(made_under_upward_rounding(manipulator)) {
    for (const WorkingMode& mode : modes) signs_.push_back(signs_of(mode));
  }

  void classify(RootIndex root, const Box& box, ModeSet modes, LeafState* states) const noexcept override {
    Evaluation(*this, root, box).run(modes, states);
  }

  std::optional<Box> reachable_positions() const override { return chart_.reachable_positions(); }

 private:
  static constexpr std::size_t size = Chart::size;
  using Signs = std::array<int, size>;
  using Gradient = Dual<size>;

  class Evaluation;

  static Chart made_under_upward_rounding(const Manipulator& manipulator) {
    const RoundingUpward rounding;
    return Chart(manipulator);
  }

  static Signs signs_of(const WorkingMode& mode) {
    Signs signs;
    for (std::size_t j = 0; j < size; ++j) signs[j] = mode.sign(j);
    return signs;
  }

  Chart chart_;
  std::vector<Signs> signs_;
};

/// What is found of one box.
template <class Chart>
class ChartClassifier<Chart>::Evaluation {
 public:
  Evaluation(const ChartClassifier& classifier, RootIndex root, const Box& box)
      : classifier_(classifier), chart_(classifier.chart_), root_(root), box_(box) {}

  void run(ModeSet modes, LeafState* states) {
    evaluate_naturally();
    if (reachable_nowhere()) return fill(modes, LeafState::outside(), states);
    const ModeSet open = classify_modes(modes, states);
    if (open == 0) return;
    evaluate_gradients();
    if (reachable_nowhere()) return fill(open, LeafState::outside(), states);
    classify_modes(open, states);
  }

 private:
  template <class Scalar>
  struct Legs {
    std::array<LegRows<Scalar, size>, size> rows;
    std::array<typename Chart::template Displacement<Scalar>, size> displacements;
  };

  template <class Scalar>
  Legs<Scalar> legs(const std::array<Scalar, size>& coordinates) const {
    const auto placement = chart_.place(root_, coordinates);
    Legs<Scalar> result;
    for (std::size_t j = 0; j < size; ++j) {
      result.displacements[j] = chart_.displacement(j, placement);
      result.rows[j] = chart_.rows(j, result.displacements[j], placement);
    }
    return result;
  }

  void evaluate_naturally() {
    for (std::size_t i = 0; i < size; ++i) range_[i] = Interval(box_.lower[i], box_.upper[i]);
    natural_ = legs(range_);
    for (std::size_t j = 0; j < size; ++j) squared_entries_[j] = natural_.rows[j].squared_entry;
    find_entries();
  }

  void find_entries() {
    for (std::size_t j = 0; j < size; ++j) {
      if (squared_entries_[j].upper() <= 0.0) return;
      entries_[j] = square_root(not_negative_part(squared_entries_[j]));
      natural_rows_[j] = branch_rows(natural_.rows[j], entries_[j]);
    }
    natural_determinants_.emplace(natural_rows_);
  }

  /// Mean-value forms: value at the center plus gradient over the box times distance from the center.
  void evaluate_gradients() {
    std::array<Gradient, size> coordinates;
    std::array<Interval, size> center;
    for (std::size_t i = 0; i < size; ++i) {
      center[i] = Interval(box_.center(i));
      coordinates[i] = Gradient::coordinate(range_[i], i);
      from_center_[i] = range_[i] - center[i];
    }
    const Legs<Gradient> over_box = legs(coordinates);
    const Legs<Interval> at_center = legs(center);
    for (std::size_t j = 0; j < size; ++j)
      squared_entries_[j] = intersection(
          squared_entries_[j], mean_value(at_center.rows[j].squared_entry, over_box.rows[j].squared_entry));
    find_entries();
    if (reachable_everywhere()) find_mean_value_rows(over_box, at_center);
  }

  // Only away from serial singularities, where the root has a slope.
  void find_mean_value_rows(const Legs<Gradient>& over_box, const Legs<Interval>& at_center) {
    for (std::size_t j = 0; j < size; ++j) {
      Gradient squared_entry = over_box.rows[j].squared_entry;
      squared_entry.value = squared_entries_[j];
      gradient_rows_[j] = branch_rows(over_box.rows[j], square_root(squared_entry));
      const Interval at_middle = square_root(not_negative_part(at_center.rows[j].squared_entry));
      center_rows_[j] = branch_rows(at_center.rows[j], at_middle);
    }
    gradient_determinants_.emplace(gradient_rows_);
    center_determinants_.emplace(center_rows_);
  }

  Interval mean_value(const Interval& at_center, const Gradient& over_box) const {
    Interval result = at_center;
    for (std::size_t i = 0; i < size; ++i) result += over_box.gradient[i] * from_center_[i];
    return result;
  }

  bool reachable_nowhere() const {
    return std::any_of(squared_entries_.begin(), squared_entries_.end(),
                       [](const Interval& entry) { return entry.upper() <= 0.0; });
  }

  bool reachable_everywhere() const {
    return std::all_of(squared_entries_.begin(), squared_entries_.end(),
                       [](const Interval& entry) { return entry.positive(); });
  }

  /// Writes the states of `modes`; returns those that stay undecided.
  ModeSet classify_modes(ModeSet modes, LeafState* states) {
    ModeSet open = 0;
    for (std::size_t mode = 0; mode < classifier_.signs_.size(); ++mode) {
      if ((modes >> mode & 1U) == 0) continue;
      states[mode] = state(classifier_.signs_[mode]);
      if (states[mode].is_undecided()) open |= ModeSet{1} << mode;
    }
    return open;
  }

  LeafState state(const Signs& signs) {
    const Verdict limits = within_limits(signs);
    if (limits == Verdict::fails) return LeafState::outside();
    const Interval value = determinant(signs);
    const bool proved = limits == Verdict::holds && reachable_everywhere();
    if (proved && value.positive()) return LeafState::inside(1);
    if (proved && value.negative()) return LeafState::inside(-1);
    return LeafState::undecided(value.upper() > 0.0, value.lower() < 0.0);
  }

  Interval determinant(const Signs& signs) {
    const Interval natural = natural_determinants_->of(signs);
    if (!gradient_determinants_ || natural.positive() || natural.negative()) return natural;
    return intersection(natural,
                        mean_value(center_determinants_->of(signs), gradient_determinants_->of(signs)));
  }

  Verdict within_limits(const Signs& signs) const {
    Verdict verdict = Verdict::holds;
    for (std::size_t j = 0; j < size && verdict != Verdict::fails; ++j)
      verdict = both(verdict, chart_.within_limits(j, natural_.displacements[j], entries_[j], signs[j]));
    return verdict;
  }

  void fill(ModeSet modes, LeafState value, LeafState* states) const {
    for (std::size_t mode = 0; mode < classifier_.signs_.size(); ++mode)
      if ((modes >> mode & 1U) != 0) states[mode] = value;
  }

  const ChartClassifier& classifier_;
  const Chart& chart_;
  RootIndex root_;
  const Box& box_;
  std::array<Interval, size> range_, from_center_;
  Legs<Interval> natural_;
  std::array<Interval, size> squared_entries_, entries_;
  std::array<BranchRows<Interval, size>, size> natural_rows_, center_rows_;
  std::array<BranchRows<Gradient, size>, size> gradient_rows_;
  std::optional<Determinants<Interval, size>> natural_determinants_, center_determinants_;
  std::optional<Determinants<Gradient, size>> gradient_determinants_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CHART_CLASSIFIER_H
