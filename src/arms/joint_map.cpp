// SPDX-License-Identifier: BSD-3-Clause
#include "arms/joint_map.h"

#include "aspects/components/disjoint_sets.h"
#include "aspects/tree/neighbour_leaves.h"
#include "parallel_aspects/model/problems.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::uint32_t no_component = 0xffffffffU;
constexpr std::uint32_t first_level = 2;        // of boxes of the coarsest map
constexpr std::uint32_t levels_below_base = 7;  // that contacts of components are looked into
constexpr std::uint32_t least_deepest_level = 16;
constexpr std::size_t most_nodes = 3000000;

// Joint values in units that are halved exactly, from -1 to 1 each.
class JointSpace final : public PoseSpace {
 public:
  JointSpace(std::size_t dimension, const std::vector<Gluing>& gluings)
      : PoseSpace(Box{dimension, {-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}, 1, gluings) {}
  MapPosition position(const Pose& /*of no platform*/) const noexcept override { return {}; }
  Pose pose(const MapPosition& /*of no platform*/) const noexcept override { return {}; }
  double measure(const Box& box) const noexcept override { return box.measure(); }
  double longest_edge(const Box& box) const noexcept override {
    double longest = 0.0;
    for (std::size_t i = 0; i < box.dimension; ++i) longest = std::max(longest, box.width(i));
    return longest;
  }
};

}  // namespace

// Factors and their derivatives by the coordinates of the tree over a box, with signs that make them
// positive.
struct JointMap::BoxForms {
  std::vector<Interval> values;
  std::vector<std::array<Interval, 3>> gradients;
  std::array<bool, 3> at_lower_limit{}, at_upper_limit{};
};

JointMap::JointMap(const SerialArm& arm, const FactorGroup& group, double resolution,
                   const MapControl& control)
    : group_(group) {
  add_coordinates(arm);
  std::vector<Gluing> gluings;
  for (std::size_t i = 0; i < coordinates_.size(); ++i) {
    const auto axis = static_cast<std::uint8_t>(i);
    if (coordinates_[i].wraps) gluings.push_back({{0, axis, true}, {0, axis, false}, {0, 1, 2}, {}});
  }
  for (const TrigPolynomial& factor : group.factors) {
    factors_.emplace_back(factor);
    auto& gradient = gradients_.emplace_back();
    for (std::size_t i = 0; i < coordinates_.size(); ++i)
      gradient[i] = EnclosedPolynomial(factor.derivative(coordinates_[i].joint, coordinates_[i].turns));
  }
  tree_ =
      std::make_shared<PoseTree>(std::make_shared<JointSpace>(coordinates_.size(), gluings), mode_count());
  measure_ = measure_of(tree_->region());
  const RoundingUpward rounding;
  classify(0);
  refine_to(2.0 * resolution, control);
  base_level_ = static_cast<std::uint32_t>(std::ceil(-std::log2(resolution)));
  while (!is_cancelled(control) && refine_once(control)) {
  }
  count(control);
}

void JointMap::add_coordinates(const SerialArm& arm) {
  for (const std::size_t joint : group_.joints) {
    const ArmJoint& of = arm.joints()[joint];
    Coordinate coordinate{joint, of.turns, arm.turns_freely(joint), 0.0, half_turn};
    if (!coordinate.wraps) {
      coordinate.middle = 0.5 * (of.limits.lower + of.limits.upper);
      coordinate.half = 0.5 * (of.limits.upper - of.limits.lower);
      if (!std::isfinite(coordinate.half) || !(coordinate.half > 0.0))
        throw InvalidDescription({"Joint '" + of.name + "' of '" + arm.name() +
                                  "' has no range between limits, and det J depends on it; give it limits in "
                                  "the URDF."});
    }
    coordinates_.push_back(coordinate);
  }
}

// Of what wraps t is in half turns itself.
JointNumbers<Affine<3>> JointMap::numbers(const Box& box) const {
  JointNumbers<Affine<3>> result;
  for (std::size_t i = 0; i < coordinates_.size(); ++i) {
    const Coordinate& of = coordinates_[i];
    const auto t = Affine<3>::coordinate(Interval(box.lower[i], box.upper[i]), i);
    const Affine<3> value = Interval(of.half) * t + Affine<3>(of.middle);
    result[of.joint] = of.wraps   ? turn_of_any_half_turns(t)
                       : of.turns ? turn_of_any_half_turns(reciprocal(pi_enclosure()) * value)
                                  : Turn<Affine<3>>{value, Affine<3>(0.0)};
  }
  return result;
}

void JointMap::classify(NodeIndex node) {
  const auto joints = numbers(tree_->box(node));
  std::size_t positive = 0, negative = 0;
  for (std::size_t k = 0; k < factors_.size(); ++k) {
    const Interval value = factors_[k].over(joints).range();
    if (value.positive()) positive |= std::size_t{1} << k;
    if (value.negative()) negative |= std::size_t{1} << k;
  }
  for (std::size_t signs = 0; signs < mode_count(); ++signs) {
    LeafState& state = tree_->state(node, signs);
    if (!state.is_pending()) continue;
    if ((positive & ~signs) != 0 || (negative & signs) != 0)
      state = LeafState::outside();
    else
      state = (positive | negative) == mode_count() - 1 ? LeafState::inside(1)
                                                        : LeafState::undecided(true, false);
  }
}

bool JointMap::grows(const BoxForms& forms, const std::array<double, 3>& direction) const {
  Interval growth(0.0);  // of the logarithm of the product
  for (std::size_t k = 0; k < forms.values.size(); ++k) {
    Interval slope(0.0);
    for (std::size_t i = 0; i < coordinates_.size(); ++i)
      slope = slope + Interval(direction[i]) * forms.gradients[k][i];
    const Interval& value = forms.values[k];
    if (value.positive()) {
      growth = growth + slope * reciprocal(value);
    } else {
      if (!(value.upper() > 0.0)) return true;  // the product is positive nowhere in the box
      if (!(slope.lower() > 0.0)) return false;
      growth = growth + Interval(slope.lower()) * Interval(reciprocal(Interval(value.upper())).lower());
    }
  }
  return growth.lower() > 0.0;
}

bool JointMap::has_rising_direction(NodeIndex node, std::size_t signs) const {
  const Box box = tree_->box(node);
  const auto joints = numbers(box);
  BoxForms forms;
  std::vector<std::array<double, 3>> directions;
  std::array<double, 3> of_open{}, of_all{};  // sums of the unit gradients of factors
  for (std::size_t k = 0; k < factors_.size(); ++k) {
    const Interval sign((signs >> k & 1U) != 0 ? 1.0 : -1.0);
    forms.values.push_back(sign * factors_[k].over(joints).range());
    auto& gradient = forms.gradients.emplace_back();
    double norm = 0.0;
    std::array<double, 3> middle{};
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
      gradient[i] = sign * gradients_[k][i].over(joints).range();
      middle[i] = 0.5 * (gradient[i].lower() + gradient[i].upper());
      norm += middle[i] * middle[i];
    }
    if (!(norm > 0.0)) continue;
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
      const double part = middle[i] / std::sqrt(norm);
      of_all[i] += part;
      if (!forms.values.back().positive()) of_open[i] += part;
    }
  }
  directions = {of_all, of_open};
  for (std::size_t i = 0; i < coordinates_.size(); ++i)
    for (const double sense : {1.0, -1.0}) {
      directions.emplace_back();
      directions.back()[i] = sense;
    }
  for (std::array<double, 3> direction : directions) {
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
      if (coordinates_[i].wraps) continue;
      if (box.upper[i] == 1.0 && direction[i] > 0.0) direction[i] = 0.0;
      if (box.lower[i] == -1.0 && direction[i] < 0.0) direction[i] = 0.0;
    }
    if (grows(forms, direction)) return true;
  }
  return false;
}

std::vector<NodeIndex> JointMap::leaves(std::size_t signs) const {
  std::vector<NodeIndex> found, open{0};
  while (!open.empty()) {
    const NodeIndex node = open.back();
    open.pop_back();
    if (!tree_->state(node, signs).is_divided()) {
      if (!tree_->state(node, signs).is_outside()) found.push_back(node);
      continue;
    }
    for (NodeIndex rank = 0; rank < tree_->children_per_node(); ++rank)
      open.push_back(tree_->first_child(node) + rank);
  }
  return found;
}

void JointMap::divide(NodeIndex node, std::size_t signs) {
  const NodeIndex first = tree_->divide(node, [signs](std::size_t mode) { return mode == signs; });
  for (NodeIndex child = first; child < first + tree_->children_per_node(); ++child) classify(child);
}

void JointMap::refine_to(double resolution, const MapControl& control) {
  for (std::size_t signs = 0; signs < mode_count(); ++signs) {
    std::vector<NodeIndex> open{0};
    while (!open.empty() && !is_cancelled(control)) {
      const NodeIndex node = open.back();
      open.pop_back();
      const std::uint32_t level = tree_->place(node).level;
      const bool is_coarse = level < first_level || std::ldexp(2.0, -static_cast<int>(level)) > resolution;
      if (tree_->state(node, signs).is_undecided() && is_coarse) divide(node, signs);
      if (!tree_->state(node, signs).is_divided()) continue;
      for (NodeIndex rank = 0; rank < tree_->children_per_node(); ++rank)
        open.push_back(tree_->first_child(node) + rank);
    }
  }
}

// Undecided leaves where two components come together.
std::vector<NodeIndex> JointMap::contacts(std::size_t signs) const {
  const std::vector<NodeIndex> all = leaves(signs);
  std::map<NodeIndex, std::uint32_t> place;
  for (const NodeIndex leaf : all) place.emplace(leaf, static_cast<std::uint32_t>(place.size()));
  std::vector<NodeIndex> node_at(all.size());
  for (const auto& [node, at] : place) node_at[at] = node;
  DisjointSets sets(all.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> faces;
  const auto inside = [&](NodeIndex node) { return tree_->state(node, signs).is_inside(); };
  visit_faces(*tree_, signs, [&](NodeIndex a, NodeIndex b) {
    if (inside(a) && inside(b))
      sets.unite(place.at(a), place.at(b));
    else
      faces.emplace_back(place.at(a), place.at(b));
  });
  std::vector<std::vector<std::uint32_t>> beside(all.size());
  for (const auto& [a, b] : faces) beside[a].push_back(b), beside[b].push_back(a);
  std::vector<std::uint32_t> label(all.size(), no_component), queue;
  for (std::uint32_t at = 0; at < all.size(); ++at)
    if (inside(node_at[at])) label[at] = sets.find(at), queue.push_back(at);
  std::vector<NodeIndex> found;
  for (std::size_t next = 0; next < queue.size(); ++next)
    for (const std::uint32_t other : beside[queue[next]]) {
      if (label[other] == no_component) {
        label[other] = label[queue[next]];
        queue.push_back(other);
      } else if (label[other] != label[queue[next]]) {
        for (const std::uint32_t at : {other, queue[next]})
          if (!inside(node_at[at])) found.push_back(node_at[at]);
      }
    }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool JointMap::refine_once(const MapControl& control) {
  bool any = false;
  for (std::size_t signs = 0; signs < mode_count() && !is_cancelled(control); ++signs) {
    std::vector<NodeIndex> open = contacts(signs);
    rising_.resize(tree_->node_count() * mode_count());
    for (const NodeIndex leaf : leaves(signs)) {
      std::uint8_t& rising = rising_[leaf * mode_count() + signs];
      if (!tree_->state(leaf, signs).is_undecided() || rising != 0) continue;
      rising = has_rising_direction(leaf, signs) ? 2 : 1;
      if (rising == 1) open.push_back(leaf);
    }
    std::sort(open.begin(), open.end());
    open.erase(std::unique(open.begin(), open.end()), open.end());
    for (const NodeIndex leaf : open) {
      const bool is_deep =
          tree_->place(leaf).level >= std::max(least_deepest_level, base_level_ + levels_below_base);
      if (is_deep || tree_->node_count() > most_nodes) continue;
      divide(leaf, signs);
      any = true;
    }
  }
  return any;
}

double JointMap::measure_of(const Box& box) const noexcept {
  double measure = 1.0;
  for (std::size_t i = 0; i < coordinates_.size(); ++i) measure *= coordinates_[i].half * box.width(i);
  return measure;
}

void JointMap::count(const MapControl& control) {
  bool all_rise = true;
  component_of_.assign(mode_count(), std::vector<std::uint32_t>(tree_->node_count(), no_component));
  for (std::size_t signs = 0; signs < mode_count() && !is_cancelled(control); ++signs) {
    const std::vector<NodeIndex> all = leaves(signs);
    DisjointSets proved(tree_->node_count()), possible(tree_->node_count());
    const auto inside = [&](NodeIndex node) { return tree_->state(node, signs).is_inside(); };
    visit_faces(*tree_, signs, [&](NodeIndex a, NodeIndex b) {
      if (inside(a) && inside(b)) proved.unite(a, b);
      possible.unite(a, b);
    });
    std::map<std::uint32_t, std::uint32_t> numbers_of_sets;
    std::vector<double> largest(components_.size(), 0.0);
    std::map<std::uint32_t, bool> apart;
    for (const NodeIndex leaf : all) {
      const Box box = tree_->box(leaf);
      const double size = measure_of(box);
      if (!inside(leaf)) {
        all_rise = all_rise && rising_[leaf * mode_count() + signs] == 2;
        continue;
      }
      apart[possible.find(leaf)] = true;
      const auto [place, is_new] =
          numbers_of_sets.emplace(proved.find(leaf), static_cast<std::uint32_t>(components_.size()));
      if (is_new) {
        components_.push_back({signs, 0.0, Eigen::VectorXd(static_cast<Eigen::Index>(coordinates_.size()))});
        largest.push_back(0.0);
      }
      JointComponent& component = components_[place->second];
      component_of_[signs][leaf] = place->second;
      component.measure += size;
      if (size <= largest[place->second]) continue;
      largest[place->second] = size;
      for (std::size_t i = 0; i < coordinates_.size(); ++i)
        component.witness[static_cast<Eigen::Index>(i)] =
            coordinates_[i].middle + coordinates_[i].half * box.center(i);
    }
    proved_count_ += apart.size();
  }
  undecided_ = measure_;
  for (const JointComponent& component : components_) undecided_ -= component.measure;
  undecided_ = std::max(0.0, undecided_);
  if (all_rise && !is_cancelled(control)) count_at_most_ = components_.size();
}

std::optional<MapPosition> JointMap::position(const Eigen::VectorXd& q) const noexcept {
  MapPosition position;
  for (std::size_t i = 0; i < coordinates_.size(); ++i) {
    const Coordinate& of = coordinates_[i];
    double t = (q[static_cast<Eigen::Index>(of.joint)] - of.middle) / of.half;
    if (of.wraps) t -= 2.0 * std::round(0.5 * t);
    if (!(t >= -1.0 && t <= 1.0)) return std::nullopt;
    position.point[i] = t;
  }
  return position;
}

std::optional<std::size_t> JointMap::signs_at(const Eigen::VectorXd& q) const {
  const RoundingUpward rounding;
  JointNumbers<Interval> joints;
  for (const Coordinate& of : coordinates_) {
    // With what a place in the tree is rounded by.
    const double value = q[static_cast<Eigen::Index>(of.joint)], error = 1e-12 * (1.0 + std::abs(value));
    const Interval range(-(error - value), value + error);
    joints[of.joint] = of.turns ? turn_of_any_half_turns(range * reciprocal(pi_enclosure()))
                                : Turn<Interval>{range, Interval(0.0)};
  }
  std::size_t signs = 0;
  for (std::size_t k = 0; k < factors_.size(); ++k) {
    const Interval value = factors_[k].over(joints);
    if (!value.positive() && !value.negative()) return std::nullopt;
    if (value.positive()) signs |= std::size_t{1} << k;
  }
  return signs;
}

std::optional<std::size_t> JointMap::component_at(const Eigen::VectorXd& q) const noexcept {
  const auto at = position(q);
  if (!at) return std::nullopt;
  const auto signs = signs_at(q);
  if (!signs) return std::nullopt;
  const auto leaf = tree_->leaf_at(*at, *signs);
  if (leaf && tree_->state(*leaf, *signs).is_inside()) return component_of_[*signs][*leaf];
  return only_component(*signs);
}

std::optional<std::size_t> JointMap::only_component(std::size_t signs) const noexcept {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < components_.size(); ++i) {
    if (components_[i].signs != signs) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return count_at_most_ ? found : std::nullopt;
}

}  // namespace parallel_aspects
