// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_T2_CLASSIFIER_H
#define PARALLEL_ASPECTS_ASPECTS_T2_CLASSIFIER_H

#include "parallel_aspects/aspects/box_classifier.h"
#include "parallel_aspects/aspects/planar_leg.h"

#include <array>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Boxes of (x, y) for two planar legs. det A is enclosed by its natural interval extension and, where that
/// does not tell its sign, by its mean-value form.
class T2Classifier final : public BoxClassifier {
 public:
  T2Classifier(const Manipulator& manipulator, const std::vector<WorkingMode>& modes);

  void classify(const Box& box, ModeSet modes, LeafState* states) const noexcept override;
  std::optional<Box> reachable_region() const override;

 private:
  template <class Scalar>
  struct LegValues;
  struct Evaluation;

  template <class Scalar>
  std::array<LegValues<Scalar>, 2> values(const Planar<Scalar>& point) const;

  LeafState state(const Box& box, const WorkingMode& mode, Evaluation& evaluation) const;
  Interval mean_value_determinant(const Box& box, const WorkingMode& mode, Evaluation& evaluation) const;
  Verdict within_limits(const WorkingMode& mode, const Evaluation& evaluation) const;

  std::vector<PlanarLeg> legs_;
  std::array<Planar<Interval>, 2> offsets_;  // d = point + offset: anchor minus base point
  std::vector<WorkingMode> modes_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_T2_CLASSIFIER_H
