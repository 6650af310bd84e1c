// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/node_search.h"

#include "aspects/cusps/strut_slice.h"
#include "aspects/enclosures/strut_images.h"
#include "aspects/zeros/krawczyk.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <queue>
#include <utility>

namespace parallel_aspects {
namespace {

// Boxes that are larger are not worth Krawczyk's test, and those about both of two [half turns].
constexpr double largest_tested = 0.02, largest_hull = 0.25;

// Pairs of boxes that are examined in all. A slice takes some ten thousand.
constexpr std::size_t largest_effort = 2000000;

// So many of them are examined depth first. What is left of these then waits until all larger ones had a
// turn: else one place where images come close to each other would use up the effort, and nodes elsewhere
// would not be found.
constexpr std::size_t largest_turn = 1024;

// Krawczyk's test of somewhat larger boxes also proves nodes that lie on a face.
constexpr double inflation = 1.5;

// What is left after these is rounding.
constexpr int contractions = 8;

double width_of(const Box& box) { return std::max(box.width(0), box.width(1)); }

bool have_images_apart(const ImageStrip& a, const ImageStrip& b) {
  for (std::size_t i = 0; i < 2; ++i)
    if (are_apart(a.range[i], b.range[i]) || are_apart(a.extents[i], b.along(a.frame[i])) ||
        are_apart(a.along(b.frame[i]), b.extents[i]))
      return true;
  return false;
}

/// g and D at one of both poses: in the middle of its box, and their derivatives over it.
struct PoseFunctions {
  std::array<Interval, 3> center;
  std::array<std::array<Interval, 2>, 3> gradients;

  PoseFunctions(const StrutSlice& slice, const Box& box) {
    const SliceTurns over(ranges_of(box)), at(SliceCenter(box).at);
    const Jet<1> g0 = slice.half_square<1>(0, at), g1 = slice.half_square<1>(1, at);
    center = {g0.value(), g1.value(), bracket(g0, g1).value()};
    const Jet<2> first = slice.half_square<2>(0, over), second = slice.half_square<2>(1, over);
    const Jet<1> d = bracket(first, second);
    gradients = {
        {{first.at(1, 0), first.at(0, 1)}, {second.at(1, 0), second.at(0, 1)}, {d.at(1, 0), d.at(0, 1)}}};
  }
};

/// The equations of a node, see `find_node_boxes`, over a box about either pose.
SystemOverBox<4> node_equations(const StrutSlice& slice, const BoxPair& boxes) {
  const PoseFunctions first(slice, boxes[0]), second(slice, boxes[1]);
  SystemOverBox<4> system{};
  for (std::size_t i = 0; i < 2; ++i) {
    system.center[i] = first.center[i] - second.center[i];
    for (std::size_t k = 0; k < 2; ++k) {
      system.jacobian[i][k] = first.gradients[i][k];
      system.jacobian[i][2 + k] = -second.gradients[i][k];
      system.jacobian[2][k] = first.gradients[2][k];
      system.jacobian[3][2 + k] = second.gradients[2][k];
    }
  }
  system.center[2] = first.center[2];
  system.center[3] = second.center[2];
  return system;
}

struct NodeZeros {
  Zeros zeros = Zeros::unknown;
  BoxPair enclosure;
};

NodeZeros test_node(const StrutSlice& slice, const BoxPair& boxes) {
  std::array<DistanceToFaces, 4> faces;
  for (std::size_t i = 0; i < 4; ++i) faces[i] = distance_to_faces(boxes[i / 2], i % 2);
  const auto found = krawczyk_test(faces, node_equations(slice, boxes));
  NodeZeros result{found.zeros, boxes};
  if (found.from_middle)
    for (std::size_t i = 0; i < 4; ++i)
      set_from_middle((*found.from_middle)[i], i % 2, result.enclosure[i / 2]);
  return result;
}

bool contains_pair(const BoxPair& outer, const BoxPair& inner) {
  return (contains_up_to_turns(outer[0], inner[0]) && contains_up_to_turns(outer[1], inner[1])) ||
         (contains_up_to_turns(outer[0], inner[1]) && contains_up_to_turns(outer[1], inner[0]));
}

bool meet(const BoxPair& a, const BoxPair& b) {
  return (meet_up_to_turns(a[0], b[0]) && meet_up_to_turns(a[1], b[1])) ||
         (meet_up_to_turns(a[0], b[1]) && meet_up_to_turns(a[1], b[0]));
}

class NodeSearch {
 public:
  NodeSearch(const StrutSlice& slice, const std::vector<Box>& cusps, const MapControl& control)
      : slice_(slice), control_(control), images_(slice), injective_(slice, cusps) {}

  NodeBoxes run() {
    NodeBoxes result;
    wait(SingularImages::root, SingularImages::root);
    for (std::size_t effort = 0; !waiting_.empty();) {
      if (is_cancelled(control_)) result.cancelled = true;
      if (result.cancelled) break;
      pairs_.push_back(waiting_.top().pair);
      waiting_.pop();
      effort += take_turn(effort < largest_effort ? largest_turn : 0, result.undecided);
    }
    for (const Known& each : known_)
      result.nodes.push_back({without_turns(each.enclosure[0]), without_turns(each.enclosure[1])});
    return result;
  }

 private:
  using Part = SingularImages::Node;
  using PartPair = std::pair<Part, Part>;

  /// The largest has the next turn.
  struct Waiting {
    double width;
    PartPair pair;

    bool operator<(const Waiting& other) const { return width < other.width; }
  };

  struct Known {
    BoxPair unique;     // holds one node
    BoxPair enclosure;  // of it
  };

  /// How many pairs were examined, at most so many; with 0 they are undecided.
  std::size_t take_turn(std::size_t most, std::vector<BoxPair>& undecided) {
    std::size_t looked_at = 0;
    for (; !pairs_.empty() && (most == 0 || looked_at < most); ++looked_at) {
      const auto [a, b] = pairs_.back();
      pairs_.pop_back();
      if (most == 0 || !examine(a, b)) undecided.push_back({images_.box(a), images_.box(b)});
    }
    for (const auto& [a, b] : pairs_) wait(a, b);
    pairs_.clear();
    return looked_at;
  }

  void wait(Part a, Part b) {
    waiting_.push({std::max(width_of(images_.box(a)), width_of(images_.box(b))), {a, b}});
  }

  /// False where the boxes are too small to be divided.
  bool examine(Part a, Part b) {
    const Box &first = images_.box(a), &second = images_.box(b);
    if (a != b && have_images_apart(images_.strip(a), images_.strip(b))) return true;
    const Box hull = hull_of(first, beside(first.middle(), second));
    if (width_of(hull) < largest_hull && injective_.holds(hull)) return true;
    const bool is_small = std::max(width_of(first), width_of(second)) < largest_tested;
    if (a != b && is_small && is_settled({first, second})) return true;
    return divide(a, b);
  }

  bool divide(Part a, Part b) {
    if (width_of(images_.box(a)) < width_of(images_.box(b))) std::swap(a, b);
    if (images_.is_smallest(a)) return false;
    const SingularImages::Parts parts = images_.parts(a);
    for (Part i = 0; i < parts.count; ++i) {
      if (a != b) pairs_.emplace_back(parts[i], b);
      if (a == b)
        for (Part k = i; k < parts.count; ++k) pairs_.emplace_back(parts[i], parts[k]);
    }
    return true;
  }

  /// Whether it is proved that the boxes hold no node, or one, which then is known.
  bool is_settled(const BoxPair& boxes) {
    const auto is_known = [&](const Known& each) { return contains_pair(each.unique, boxes); };
    if (std::any_of(known_.begin(), known_.end(), is_known)) return true;
    const BoxPair wider{scaled(boxes[0], inflation), scaled(boxes[1], inflation)};
    NodeZeros found = test_node(slice_, wider);
    if (found.zeros != Zeros::one) return found.zeros == Zeros::none;
    for (int k = 0; k < contractions; ++k) {
      const NodeZeros next = test_node(slice_, found.enclosure);
      for (std::size_t i = 0; i < 2; ++i)
        found.enclosure[i] = intersection(found.enclosure[i], next.enclosure[i]);
    }
    return note({wider, found.enclosure});
  }

  /// Whether it is proved that the node is a known one, or none of these.
  bool note(const Known& found) {
    for (const Known& each : known_) {
      if (contains_pair(each.unique, found.enclosure) || contains_pair(found.unique, each.enclosure))
        return true;
      if (meet(found.enclosure, each.enclosure)) return false;
    }
    known_.push_back(found);
    return true;
  }

  const StrutSlice& slice_;
  const MapControl& control_;
  StrutImages images_;
  InjectiveBoxes injective_;
  std::vector<PartPair> pairs_;           // of this turn
  std::priority_queue<Waiting> waiting_;  // each for a turn
  std::vector<Known> known_;
};

}  // namespace

NodeBoxes find_node_boxes(const StrutSlice& slice, const std::vector<Box>& cusps, const MapControl& control) {
  assert_rounding_upward();
  return NodeSearch(slice, cusps, control).run();
}

}  // namespace parallel_aspects
