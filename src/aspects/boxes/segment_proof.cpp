// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/segment_proof.h"

#include "interval/interval.h"

namespace parallel_aspects {
namespace {

/// The segment from `from` to `to` in one working mode.
struct SegmentInMode {
  const BoxClassifier& classifier;
  std::size_t dimension;
  std::size_t mode;
  int sign;
  RootIndex root;
  const MapPoint& from;
  const MapPoint& to;
  int max_halvings;

  LeafState state(double begin, double end) const noexcept {
    return classifier.state(root, hull(dimension, from, to, begin, end), mode);
  }

  bool is_free(double begin, double end, int halvings) const noexcept {
    const LeafState all = state(begin, end);
    if (all.is_inside(sign)) return true;
    if (!all.may_be(sign) || halvings == max_halvings) return false;
    const double middle = 0.5 * (begin + end);
    // Most segments that are not free show it at a single point.
    if (!state(middle, middle).is_inside(sign)) return false;
    return is_free(begin, middle, halvings + 1) && is_free(middle, end, halvings + 1);
  }
};

}  // namespace

Box hull(std::size_t dimension, const MapPoint& from, const MapPoint& to, double begin, double end) noexcept {
  Box box{dimension, {}, {}};
  for (std::size_t i = 0; i < dimension; ++i) {
    const Interval start(from[i]);
    const Interval part = start + Interval(begin, end) * (Interval(to[i]) - start);
    box.lower[i] = part.lower();
    box.upper[i] = part.upper();
  }
  return box;
}

int proved_sign(const BoxClassifier& classifier, std::size_t dimension, std::size_t mode,
                const MapPosition& position) noexcept {
  // A box of one point: enclosures are as wide as rounding.
  const LeafState state =
      classifier.state(position.root, Box{dimension, position.point, position.point}, mode);
  if (!state.is_inside()) return 0;
  return state.is_inside(1) ? 1 : -1;
}

bool segment_is_free(const BoxClassifier& classifier, std::size_t dimension, std::size_t mode, int sign,
                     const MapPosition& from, const MapPoint& to, int max_halvings) noexcept {
  return SegmentInMode{classifier, dimension, mode, sign, from.root, from.point, to, max_halvings}.is_free(
      0.0, 1.0, 0);
}

}  // namespace parallel_aspects
