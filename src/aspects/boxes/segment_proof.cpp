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

namespace {

constexpr int max_halvings = 8;

Box part_of(const CrossingSegment& segment, double begin, double end) noexcept {
  return hull(segment.dimension, segment.from, segment.to, begin, end);
}

/// Whether every part of the segment passes, halved as often as needed.
template <class Passes>
bool all_parts(const Passes& passes, double begin, double end, int halvings) noexcept {
  if (passes(begin, end)) return true;
  if (halvings == max_halvings) return false;
  const double middle = 0.5 * (begin + end);
  return all_parts(passes, begin, middle, halvings + 1) && all_parts(passes, middle, end, halvings + 1);
}

/// Whether every part of the path passes: `passes(segment, begin, end)`.
template <class Passes>
bool all_parts(const Passes& passes, const CrossingPath& path) noexcept {
  for (std::size_t i = 0; i < path.count; ++i) {
    const CrossingSegment& segment = path.segments[i];
    if (!all_parts([&](double begin, double end) { return passes(segment, begin, end); }, 0.0, 1.0, 0))
      return false;
  }
  return true;
}

}  // namespace

// Beyond the first zero of B_jj^2 nothing needs to hold. A part on which the leg reaches nowhere begins
// beyond one, if all before it have passed.
bool crosses_serial_singularity(const BoxClassifier& classifier, const CrossingPath& path, std::size_t mode,
                                std::size_t other_mode, std::size_t leg, int sign) noexcept {
  const LegSet crossing = BoxFacts::bit(leg);
  const auto end = classifier.facts(path.last().root, part_of(path.last(), 1.0, 1.0), mode);
  if ((end.unreachable & crossing) == 0) return false;
  const auto passes = [&](const CrossingSegment& segment, double from, double to) {
    const Box box = part_of(segment, from, to);
    const BoxFacts one = classifier.facts(segment.root, box, mode);
    if ((one.unreachable & crossing) != 0) return true;
    if (!one.all_clear_but(crossing) || !one.within_limits || one.determinant_sign != sign) return false;
    const BoxFacts other = classifier.facts(segment.root, box, other_mode);
    return other.within_limits && other.determinant_sign == sign;
  };
  return all_parts(passes, path);
}

// A zero of det A lies on parts alone on which it falls, so there are not two. In other coordinates det A has
// another positive factor: it still falls through its zero, and keeps the sign that it has where segments
// meet.
bool crosses_parallel_singularity(const BoxClassifier& classifier, const CrossingPath& path,
                                  std::size_t mode) noexcept {
  const auto passes = [&](const CrossingSegment& segment, double from, double to) {
    const BoxFacts facts = classifier.facts(segment.root, part_of(segment, from, to), mode);
    if (!facts.all_clear_but(0) || !facts.within_limits) return false;
    if (facts.determinant_sign != 0) return true;
    Interval slope;
    for (std::size_t i = 0; i < segment.dimension; ++i)
      slope = slope + facts.determinant_slope[i] * (Interval(segment.to[i]) - Interval(segment.from[i]));
    return slope.negative();
  };
  return all_parts(passes, path);
}

}  // namespace parallel_aspects
