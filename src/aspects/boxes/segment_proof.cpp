// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/segment_proof.h"

#include "interval/interval.h"

namespace parallel_aspects {
namespace {

/// The segment from `from` to `to` in one working mode.
struct Segment {
  const BoxClassifier& classifier;
  std::size_t dimension;
  std::size_t mode;
  int sign;
  RootIndex root;
  const MapPoint& from;
  const MapPoint& to;
  int most_halvings;

  // A box around the part between the shares `begin` and `end` of its length.
  Box hull(double begin, double end) const noexcept {
    Box box{dimension, {}, {}};
    for (std::size_t i = 0; i < dimension; ++i) {
      const Interval part = Interval(from[i]) + Interval(begin, end) * (Interval(to[i]) - Interval(from[i]));
      box.lower[i] = part.lower();
      box.upper[i] = part.upper();
    }
    return box;
  }

  bool is_free(double begin, double end, int halvings) const noexcept {
    const LeafState state = classifier.state(root, hull(begin, end), mode);
    if (state.is_inside(sign)) return true;
    if (!state.may_be(sign) || halvings == most_halvings) return false;
    const double middle = 0.5 * (begin + end);
    // Most segments that are not free show it at a single point.
    if (!classifier.state(root, hull(middle, middle), mode).is_inside(sign)) return false;
    return is_free(begin, middle, halvings + 1) && is_free(middle, end, halvings + 1);
  }
};

}  // namespace

int proved_sign(const BoxClassifier& classifier, std::size_t dimension, std::size_t mode,
                const MapPosition& position) noexcept {
  const LeafState state =
      classifier.state(position.root, Box{dimension, position.point, position.point}, mode);
  if (!state.is_inside()) return 0;
  return state.is_inside(1) ? 1 : -1;
}

bool segment_is_free(const BoxClassifier& classifier, std::size_t dimension, std::size_t mode, int sign,
                     const MapPosition& from, const MapPoint& to, int most_halvings) noexcept {
  return Segment{classifier, dimension, mode, sign, from.root, from.point, to, most_halvings}.is_free(0.0,
                                                                                                      1.0, 0);
}

}  // namespace parallel_aspects
