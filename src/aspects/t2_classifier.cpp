// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/t2_classifier.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {

/// Rows of A up to a positive factor, for both signs of B_jj.
template <class Scalar>
struct T2Classifier::LegValues {
  Planar<Scalar> displacement;
  Interval squared_entry;  // B_jj^2
  Interval entry;          // |B_jj|
  Planar<Scalar> positive_row, negative_row;

  const Planar<Scalar>& row(int sign) const { return sign > 0 ? positive_row : negative_row; }
};

/// What is known of one box; the mean-value parts only once they are needed.
struct T2Classifier::Evaluation {
  std::array<LegValues<Interval>, 2> natural;
  bool reachable_everywhere = false;
  std::optional<std::array<LegValues<Dual<2>>, 2>> with_gradient;
  std::optional<std::array<LegValues<Interval>, 2>> at_center;
};

namespace {

const Interval& value_of(const Interval& a) { return a; }
const Interval& value_of(const Dual<2>& a) { return a.value; }

Interval root_of(const Interval& squared_entry) { return square_root(not_negative_part(squared_entry)); }
Dual<2> root_of(const Dual<2>& squared_entry) { return square_root(squared_entry); }

Planar<Interval> ranges(const Box& box) {
  return {Interval(box.lower[0], box.upper[0]), Interval(box.lower[1], box.upper[1])};
}

Planar<Dual<2>> coordinates(const Planar<Interval>& range) {
  return {Dual<2>::coordinate(range.x, 0), Dual<2>::coordinate(range.y, 1)};
}

}  // namespace

T2Classifier::T2Classifier(const Manipulator& manipulator, const std::vector<WorkingMode>& modes)
    : modes_(modes) {
  const RoundingUpward rounding;
  for (std::size_t j = 0; j < 2; ++j) {
    const Leg& leg = manipulator.leg(j);
    legs_.emplace_back(leg);
    offsets_[j] = {Interval(leg.anchor.x()) - legs_[j].base().x,
                   Interval(leg.anchor.y()) - legs_[j].base().y};
  }
}

template <class Scalar>
std::array<T2Classifier::LegValues<Scalar>, 2> T2Classifier::values(const Planar<Scalar>& point) const {
  std::array<LegValues<Scalar>, 2> result;
  for (std::size_t j = 0; j < 2; ++j) {
    const Planar<Scalar> d{point.x + Scalar(offsets_[j].x), point.y + Scalar(offsets_[j].y)};
    const PlanarLegForm<Scalar> form = legs_[j].form(d);
    const Scalar root = root_of(form.squared_entry);
    const Planar<Scalar> turned{root * form.turned.x, root * form.turned.y};
    result[j] = {d,
                 value_of(form.squared_entry),
                 value_of(root),
                 {form.fixed.x + turned.x, form.fixed.y + turned.y},
                 {form.fixed.x - turned.x, form.fixed.y - turned.y}};
  }
  return result;
}

void T2Classifier::classify(const Box& box, ModeSet modes, LeafState* states) const noexcept {
  Evaluation evaluation;
  evaluation.natural = values(ranges(box));
  const Interval first = evaluation.natural[0].squared_entry, second = evaluation.natural[1].squared_entry;
  const bool reachable_nowhere = first.upper() <= 0.0 || second.upper() <= 0.0;
  evaluation.reachable_everywhere = first.positive() && second.positive();
  for (std::size_t i = 0; i < modes_.size(); ++i)
    if ((modes >> i & 1U) != 0)
      states[i] = reachable_nowhere ? LeafState::outside() : state(box, modes_[i], evaluation);
}

LeafState T2Classifier::state(const Box& box, const WorkingMode& mode, Evaluation& evaluation) const {
  const Verdict limits = within_limits(mode, evaluation);
  if (limits == Verdict::fails) return LeafState::outside();

  const auto& legs = evaluation.natural;
  Interval determinant = cross(legs[0].row(mode.sign(0)), legs[1].row(mode.sign(1)));
  // The root has no slope at a serial singularity, so there the natural extension must do.
  if (!determinant.positive() && !determinant.negative() && evaluation.reachable_everywhere)
    determinant = mean_value_determinant(box, mode, evaluation);

  const bool may_be_positive = determinant.upper() > 0.0, may_be_negative = determinant.lower() < 0.0;
  const bool proved = evaluation.reachable_everywhere && limits == Verdict::holds;
  if (proved && determinant.positive()) return LeafState::inside(1);
  if (proved && determinant.negative()) return LeafState::inside(-1);
  return LeafState::undecided(may_be_positive, may_be_negative);
}

Interval T2Classifier::mean_value_determinant(const Box& box, const WorkingMode& mode,
                                              Evaluation& evaluation) const {
  const Planar<Interval> range = ranges(box);
  const Planar<double> middle{box.center(0), box.center(1)};
  if (!evaluation.with_gradient) {
    evaluation.with_gradient = values(coordinates(range));
    evaluation.at_center = values(Planar<Interval>{middle.x, middle.y});
  }
  const int s0 = mode.sign(0), s1 = mode.sign(1);
  const auto& legs = *evaluation.with_gradient;
  const auto& center = *evaluation.at_center;
  const Dual<2> determinant = cross(legs[0].row(s0), legs[1].row(s1));
  return cross(center[0].row(s0), center[1].row(s1)) +
         determinant.gradient[0] * (range.x - Interval(middle.x)) +
         determinant.gradient[1] * (range.y - Interval(middle.y));
}

Verdict T2Classifier::within_limits(const WorkingMode& mode, const Evaluation& evaluation) const {
  Verdict verdict = Verdict::holds;
  for (std::size_t j = 0; j < 2; ++j) {
    const auto& leg = evaluation.natural[j];
    const Verdict one = legs_[j].within_limits(leg.displacement, leg.entry, mode.sign(j));
    if (one == Verdict::fails) return one;
    if (one == Verdict::unsure) verdict = one;
  }
  return verdict;
}

std::optional<Box> T2Classifier::reachable_region() const {
  const RoundingUpward rounding;
  Box box{2, {-HUGE_VAL, -HUGE_VAL, 0.0}, {HUGE_VAL, HUGE_VAL, 0.0}};
  for (std::size_t j = 0; j < 2; ++j) {
    if (!std::isfinite(legs_[j].reach())) continue;
    const Interval reach(-legs_[j].reach(), legs_[j].reach());
    const std::array<Interval, 2> range{reach - offsets_[j].x, reach - offsets_[j].y};
    for (std::size_t i = 0; i < 2; ++i) {
      box.lower[i] = std::max(box.lower[i], range[i].lower());
      box.upper[i] = std::min(box.upper[i], range[i].upper());
    }
  }
  if (!std::isfinite(box.width(0)) || !std::isfinite(box.width(1))) return std::nullopt;
  return box;
}

}  // namespace parallel_aspects
