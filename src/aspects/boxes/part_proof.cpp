// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/part_proof.h"

namespace parallel_aspects {
namespace {

/// The set is a shell that begins between two corners, or beyond the highest.
class ShellSearch {
 public:
  ShellSearch(const BoxClassifier& classifier, std::size_t mode, int sign, RootIndex root, const Box& box,
              const Monotonicity& shell) noexcept
      : classifier_(classifier),
        mode_(mode),
        sign_(sign),
        root_(root),
        dimension_(box.dimension),
        lowest_(shell.lowest(box)),
        highest_(shell.highest(box)) {}

  // A shell is empty only where its highest corner is not reachable (see BoxSlopes::shell). Else one pose
  // shows where it is: on the diagonal the reachable poses are an interval up to the highest corner, and det
  // A has the sign where it begins. Poses too near the singularity are not proved, those too far have lost
  // the sign, so lengths from tiny to all are tried, and the last of the first ones that pass is taken.
  Part run() const noexcept {
    if (examine(highest_).state.is_outside()) return {Part::Kind::empty, {}};
    double beyond = 0.0, reachable = 1.0;
    for (int i = 0; i < classifier_.policy().shell_bisections; ++i) {
      const double middle = 0.5 * (beyond + reachable);
      (is_reachable(at(middle)) ? reachable : beyond) = middle;
    }
    Part part;
    for (double step = 0x1p-28; step < 1.0; step *= 2.0) {
      const MapPoint pose = at(reachable + step * (1.0 - reachable));
      if (examine(pose).state.is_inside(sign_))
        part = {Part::Kind::connected, pose};
      else if (part.kind == Part::Kind::connected)
        break;
    }
    return part;
  }

 private:
  MapPoint at(double share) const noexcept {
    MapPoint point{};
    for (std::size_t i = 0; i < dimension_; ++i)
      point[i] = share == 1.0 ? highest_[i] : lowest_[i] + share * (highest_[i] - lowest_[i]);
    return point;
  }

  Examined examine(const MapPoint& point) const noexcept {
    return classifier_.examine(root_, Box{dimension_, point, point}, mode_, sign_);
  }

  bool is_reachable(const MapPoint& point) const noexcept {
    return !classifier_.state(root_, Box{dimension_, point, point}, mode_).is_outside();
  }

  const BoxClassifier& classifier_;
  std::size_t mode_;
  int sign_;
  RootIndex root_;
  std::size_t dimension_;
  MapPoint lowest_, highest_;
};

}  // namespace

// Pushed along coordinates along which it grows, the set stays in itself: the face has some of it if the
// box has, and all of the box's is connected with that. Each round flattens a coordinate more, so it ends.
std::optional<Part> part_or_flatten(const BoxClassifier& classifier, std::size_t mode, int sign,
                                    RootIndex root, const Examined& examined, Box& box) noexcept {
  if (examined.state.is_inside(sign)) return Part{Part::Kind::connected, box.middle()};
  if (!examined.state.may_be(sign)) return Part{Part::Kind::empty, {}};
  if (examined.shell) return ShellSearch(classifier, mode, sign, root, box, *examined.shell).run();
  if (!examined.monotonicity.flatten(box)) return Part{};
  return std::nullopt;
}

Part find_part(const BoxClassifier& classifier, std::size_t mode, int sign, RootIndex root,
               Box box) noexcept {
  for (;;) {
    const Examined examined = classifier.examine(root, box, mode, sign);
    if (const auto part = part_or_flatten(classifier, mode, sign, root, examined, box)) return *part;
  }
}

Part find_part_or_wedge(const BoxClassifier& classifier, std::size_t mode, int sign, RootIndex root,
                        const Box& box) noexcept {
  const Part part = find_part(classifier, mode, sign, root, box);
  if (part.kind != Part::Kind::unknown) return part;
  const auto pose = classifier.find_wedge(root, box, mode, sign);
  return pose ? Part{Part::Kind::joined, *pose} : part;
}

}  // namespace parallel_aspects
