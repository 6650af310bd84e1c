// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/open_ends.h"

#include "model/message_text.h"
#include "urdf/closing/planar_layers.h"
#include "urdf/description/name_words.h"
#include "urdf/setup/left_open.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>

namespace parallel_aspects {
namespace {

// Of the size of the robot: what CAD rounds to four digits, and what is near: less than a link is long.
constexpr double coincident = 1e-4;
constexpr double near = 0.02;
constexpr double on_joint = 1e-6;  // to which lengths are written [m]

// Whether a longer chain, like the one to this end, goes on beside the origin of the link that is like it, as
// a strut does from its piston to the ball at the far end.
bool goes_on_beside(const Tree& tree, std::size_t longer, std::size_t end) {
  const std::vector<std::size_t> carrier = movable_joints_to(tree, longer),
                                 chain = movable_joints_to(tree, end);
  if (chain.size() >= carrier.size()) return false;
  for (std::size_t k = 0; k < chain.size(); ++k)
    if (tree.joints[carrier[k]].motion != tree.joints[chain[k]].motion) return false;
  const TreeJoint& next = tree.joints[carrier[chain.size()]];
  Eigen::Isometry3d place = next.origin;
  for (auto above = tree.joint_above[next.parent]; above && !tree.joints[*above].variable;
       above = tree.joint_above[tree.joints[*above].parent])
    place = tree.joints[*above].origin * place;
  return place.translation().norm() > on_joint;
}

constexpr std::size_t max_hubs = 4;     // base, platform, and a tool or a gripper with frames of its own
constexpr std::size_t max_orders = 24;  // of ends without evidence: those of four chains

class EndFinder {
 public:
  EndFinder(const Tree& tree, const Bodies& bodies, const std::vector<bool>& left_open)
      : tree_(tree), bodies_(bodies), left_open_(left_open) {
    poses_ = link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables()));
    size_ = mechanism_size(tree, 0, poses_);
    normal_ = common_normal(tree, poses_, tree.movable);
    collect();
    is_wrist_ = std::any_of(result_.links.begin(), result_.links.end(),
                            [this](std::size_t link) { return every_chain_ends_at(link); });
  }

  // Without pairings.
  OpenEnds ends() const {
    OpenEnds found = result_;
    found.pairings.clear();
    if (terminal_.size() > 1) found.platform = hubs_first().front().ends.front();
    return found;
  }

  // By what positions and names show.
  std::vector<EqualPairings> evident() {
    if (!begin()) return {};
    for (const Body& hub : hubs_first()) {
      split(hub);
      const auto shared = by_names(true);
      add_first(by_position(), shared ? shared : by_names(false));
      if (shared) add_first(std::nullopt, by_names(false));
    }
    return result_.pairings;
  }

  // Where there is no other way.
  std::vector<EqualPairings> forced() {
    if (!begin()) return {};
    if (tips_.size() == 1 && anchors_.size() == 1)
      add({Pairing{{{anchors_[0], tips_[0].front()}}, "they are the only open ends"}});
    return result_.pairings;
  }

  // All others that are tried.
  std::vector<EqualPairings> others() {
    if (!begin()) return {};
    const EqualPairings pairs = neighbours();
    add(pairs.empty() ? in_one_point(anchors_, tips_) : pairs);
    add_orders();
    add(shared_orders(anchors_, tips_, carried_anchor()));
    return result_.pairings;
  }

  bool cut_short() const { return result_.cut_short; }

  // The sets of frames that it holds together, which several pairings may say.
  std::set<std::set<std::size_t>> meetings(const Pairing& pairing) const {
    std::set<std::set<std::size_t>> groups;
    for (const EndPair& pair : pairing.pairs) {
      std::set<std::size_t> group{place(pair.one), place(pair.other)};
      for (auto other = groups.begin(); other != groups.end();) {
        const bool meets = other->count(place(pair.one)) + other->count(place(pair.other)) > 0;
        if (meets) group.insert(other->begin(), other->end());
        other = meets ? groups.erase(other) : std::next(other);
      }
      groups.insert(group);
    }
    return groups;
  }

 private:
  // With the likeliest hub; whether there are chains.
  bool begin() {
    result_.pairings.clear();
    if (!terminal_.empty()) split(hubs_first().front());
    return !terminal_.empty();
  }

  // Of the links of a body that have one origin, the first.
  std::size_t place(std::size_t link) const {
    const std::vector<std::size_t>& links = bodies_.links(bodies_.of(link));
    return *std::find_if(links.begin(), links.end(),
                         [&](std::size_t other) { return are_one_frame(link, other); });
  }

  // The joints of a wrist all are in its centre, where only their axes distinguish them; for planar robots it
  // does not matter in which layer a frame is.
  bool are_one_frame(std::size_t one, std::size_t other) const {
    Eigen::Vector3d between = poses_[one].translation() - poses_[other].translation();
    if (normal_) between -= *normal_ * normal_->dot(between);
    return between.norm() <= coincident * size_ && (!is_wrist_ || have_one_axis(one, other));
  }

  bool every_chain_ends_at(std::size_t place) const {
    return std::all_of(terminal_.begin(), terminal_.end(), [&](const Body& body) {
      return std::any_of(body.ends.begin(), body.ends.end(),
                         [&](std::size_t end) { return in_one_place(end, place); });
    });
  }

  bool in_one_place(std::size_t one, std::size_t other) const {
    return distance(one, other) <= coincident * size_;
  }

  // Along z, either way round, as revolute closures hold it.
  bool have_one_axis(std::size_t one, std::size_t other) const {
    return poses_[one].linear().col(2).cross(poses_[other].linear().col(2)).norm() <= near;
  }

  struct Body {
    std::size_t body = 0;
    std::vector<std::size_t> ends;  // links
    bool last = false;              // whether it carries no other body
  };

  // Links without children; where a body that ends a chain has none but itself, its own origin.
  void collect() {
    std::vector<bool> has_child(tree_.links.size(), false), carries(bodies_.count(), false);
    for (const TreeJoint& joint : tree_.joints) {
      if (left_open_[joint.child]) continue;
      has_child[joint.parent] = true;
      if (joint.variable) carries[bodies_.of(joint.parent)] = true;
    }
    for (std::size_t body = 0; body < bodies_.count(); ++body) {
      Body found{body, {}, !carries[body] && body != 0};
      const std::size_t own = bodies_.links(body).front();
      for (const std::size_t link : bodies_.links(body))
        if (!has_child[link] && (link != own || !carries[body]) && !left_open_[link])
          found.ends.push_back(link);
      if (found.last && found.ends == std::vector<std::size_t>{own} && has_no_tip_frame(own))
        result_.without_tip_frame.push_back(own);
      result_.links.insert(result_.links.end(), found.ends.begin(), found.ends.end());
      if (found.last && !found.ends.empty()) terminal_.push_back(found);
      if (!found.ends.empty()) ended_.push_back(found);
    }
  }

  // A slide may end at the joint that it has.
  bool has_no_tip_frame(std::size_t own) const {
    if (tree_.joints[*tree_.joint_above[own]].motion == JointMotion::revolute) return true;
    for (std::size_t link = 0; link < tree_.links.size(); ++link)
      if (goes_on_beside(tree_, link, own)) return true;
    return false;
  }

  // The bodies that may have the anchors, which the other chains reach: those with most ends, but the root
  // last, as chains begin there.
  std::vector<Body> hubs_first() const {
    std::vector<Body> hubs;
    for (const Body& body : ended_)
      if (body.ends.size() > 1) hubs.push_back(body);
    std::stable_sort(hubs.begin(), hubs.end(), [this](const Body& one, const Body& other) {
      return std::pair{!carries_all(one.body), one.ends.size()} >
             std::pair{!carries_all(other.body), other.ends.size()};
    });
    if (hubs.size() > max_hubs) hubs.resize(max_hubs);
    if (hubs.empty()) hubs.push_back(terminal_.size() > 1 ? best_single() : ended_.front());
    return hubs;
  }

  // Whether every chain passes through it on its way from the root.
  bool carries_all(std::size_t body) const {
    return std::all_of(terminal_.begin(), terminal_.end(), [&](const Body& end) {
      std::size_t link = end.ends.front();
      while (bodies_.of(link) != body && tree_.joint_above[link])
        link = tree_.joints[*tree_.joint_above[link]].parent;
      return bodies_.of(link) == body;
    });
  }

  void split(const Body& hub) {
    anchors_ = hub.ends;
    std::stable_partition(anchors_.begin(), anchors_.end(),
                          [this](std::size_t link) { return says_end(tree_.links[link]); });
    tips_.clear();
    for (const Body& body : terminal_)
      if (body.body != hub.body) tips_.push_back(preferred(body.ends));
    std::stable_sort(tips_.begin(), tips_.end(), [this](const auto& one, const auto& other) {
      return start_of_chain(one.front()) < start_of_chain(other.front());
    });
  }

  // The joint that begins it, by the order of the file, which is that of the legs.
  std::size_t start_of_chain(std::size_t end) const {
    return *tree_.joints[movable_joints_to(tree_, end).front()].variable;
  }

  // Of bodies with one end each, that whose name looks most like an operational point.
  const Body& best_single() const {
    return *std::max_element(terminal_.begin(), terminal_.end(), [&](const Body& one, const Body& other) {
      return operational_point_likeness(tree_.links[one.ends.front()]) <
             operational_point_likeness(tree_.links[other.ends.front()]);
    });
  }

  // Those that say that they are ends, where some do.
  std::vector<std::size_t> preferred(const std::vector<std::size_t>& ends) const {
    std::vector<std::size_t> said;
    for (const std::size_t end : ends)
      if (says_end(tree_.links[end])) said.push_back(end);
    return said.empty() ? ends : said;
  }

  double distance(std::size_t one, std::size_t other) const {
    return (poses_[one].translation() - poses_[other].translation()).norm();
  }

  // Every tip has an anchor where it is at zero, or nearly so.
  std::optional<Pairing> by_position() const {
    Pairing pairing{{}, "they coincide while all joints are zero"};
    double widest = 0.0;
    std::set<std::size_t> taken;
    for (const std::vector<std::size_t>& tips : tips_) {
      const auto pair = nearest(tips, taken);
      if (!pair) return std::nullopt;
      taken.insert(pair->one);
      widest = std::max(widest, distance(pair->one, pair->other));
      pairing.pairs.push_back(*pair);
    }
    if (widest > coincident * size_)
      pairing.reason =
          "they come within " + number_text(widest, 2) + " m of each other while all joints are zero";
    return pairing.pairs.empty() ? std::nullopt : std::optional<Pairing>(pairing);
  }

  std::optional<EndPair> nearest(const std::vector<std::size_t>& tips,
                                 const std::set<std::size_t>& taken) const {
    std::optional<EndPair> best;
    double least = near * size_;
    for (const std::size_t tip : tips)
      for (const std::size_t anchor : anchors_)
        if (distance(tip, anchor) < least - coincident * size_ || (!best && distance(tip, anchor) < least)) {
          least = distance(tip, anchor);
          best = EndPair{anchor, tip};
        }
    if (!best) return best;
    for (const std::size_t anchor : anchors_) {
      const double other = distance(best->other, anchor);
      if (!in_one_place(anchor, best->one) && other < distinct * least) return std::nullopt;
    }
    const auto anchor = anchor_at(*best, taken);
    return anchor ? std::optional<EndPair>({*anchor, best->other}) : std::nullopt;
  }

  // Of the anchors in the place of that of the pair, one with the axis of the tip, and one that is not taken.
  // Nothing where many are in the centre of a wrist, and none has that axis.
  std::optional<std::size_t> anchor_at(const EndPair& pair, const std::set<std::size_t>& taken) const {
    std::vector<std::size_t> there;
    for (const std::size_t anchor : anchors_)
      if (in_one_place(anchor, pair.one)) there.push_back(anchor);
    const auto rank = [&](std::size_t anchor) {
      return std::pair{!have_one_axis(anchor, pair.other), taken.count(anchor)};
    };
    const std::size_t best = *std::min_element(
        there.begin(), there.end(), [&](std::size_t one, std::size_t two) { return rank(one) < rank(two); });
    const bool is_told = !is_wrist_ || there.size() == 1 || have_one_axis(best, pair.other);
    return is_told ? std::optional<std::size_t>(best) : std::nullopt;
  }

  // Every tip has one anchor whose name is more like its own than any other, and the other way round; or
  // where anchors are shared by several, as two legs meet in one joint, every tip has one.
  std::optional<Pairing> by_names(bool shared) const {
    std::vector<std::size_t> all;
    for (const auto& tips : tips_) all.insert(all.end(), tips.begin(), tips.end());
    if (all.empty() || anchors_.size() < 2) return std::nullopt;
    const EndLikeness likeness(tree_, all, anchors_);
    Pairing pairing{{}, "their names have the same numbers or words"};
    std::set<std::size_t> taken;
    for (const auto& tips : tips_) {
      const auto pair = likest(tips, likeness);
      if (!pair || (!taken.insert(pair->one).second && !shared)) continue;
      pairing.pairs.push_back(*pair);
    }
    if (shared && !meets_in_pairs(pairing, tips_.size())) return std::nullopt;
    // A chain that ends elsewhere, as the finger of a gripper, is left open where all anchors but some are
    // taken.
    const bool all_tips = pairing.pairs.size() == tips_.size();
    return all_tips || pairing.pairs.size() > 1 ? std::optional<Pairing>(pairing) : std::nullopt;
  }

  std::optional<EndPair> likest(const std::vector<std::size_t>& tips, const EndLikeness& likeness) const {
    EndPair best;
    int most = 0, second = 0;
    for (const std::size_t tip : tips)
      for (const std::size_t anchor : anchors_) {
        const int value = likeness.between(tip, anchor);
        if (value > most) best = {anchor, tip};
        second = std::max(second, std::min(most, value));
        most = std::max(most, value);
      }
    return most >= 3 && second < most ? std::optional<EndPair>(best) : std::nullopt;
  }

  // Names and positions that contradict each other weigh the same.
  void add_first(const std::optional<Pairing>& at_zero, const std::optional<Pairing>& by_words) {
    EqualPairings first;
    if (at_zero) first.push_back(*at_zero);
    if (by_words && at_zero && meetings(*at_zero) == meetings(*by_words))
      first.front().reason += ", and " + by_words->reason;
    else if (by_words)
      first.push_back(*by_words);
    add(std::move(first));
  }

  void add(EqualPairings pairings) {
    if (!pairings.empty()) result_.pairings.push_back(std::move(pairings));
  }

  // Where no end looks like a platform, and all chains stop at their last joint.
  EqualPairings neighbours() const {
    std::vector<std::size_t> ends;
    for (const Body& body : terminal_) ends.push_back(body.ends.front());
    const bool any_platform = std::any_of(ends.begin(), ends.end(), [this](std::size_t link) {
      return operational_point_likeness(tree_.links[link]) > 0;
    });
    if (any_platform || result_.without_tip_frame != ends) return {};
    return two_by_two(ends, [this](std::size_t one, std::size_t other) { return distance(one, other); });
  }

  // Each order of the anchors, where there are few.
  void add_orders() {
    if (anchors_.size() < tips_.size() || tips_.empty() || anchors_.size() == 1) return;
    EqualPairings orders;
    std::vector<std::size_t> chosen;
    extend(chosen, orders);
    add(std::move(orders));
  }

  // That in the place of the joint that carries the body of the anchors on a chain.
  std::optional<std::size_t> carried_anchor() const {
    if (anchors_.empty()) return std::nullopt;
    const auto above = tree_.joint_above[bodies_.links(bodies_.of(anchors_.front())).front()];
    for (const std::size_t anchor : anchors_)
      if (above && tree_.joints[*above].motion == JointMotion::revolute &&
          in_one_place(anchor, tree_.joints[*above].child))
        return anchor;
    return std::nullopt;
  }

  void extend(std::vector<std::size_t>& chosen, EqualPairings& orders) {
    if (orders.size() >= max_orders) {
      result_.cut_short = true;
      return;
    }
    const std::size_t leg = chosen.size();
    if (leg == tips_.size()) {
      Pairing pairing{{}, "an order of the open ends, without other evidence"};
      for (std::size_t k = 0; k < leg; ++k) pairing.pairs.push_back({chosen[k], tips_[k].front()});
      orders.push_back(pairing);
      return;
    }
    for (const std::size_t anchor : anchors_) {
      if (std::find(chosen.begin(), chosen.end(), anchor) != chosen.end()) continue;
      chosen.push_back(anchor);
      extend(chosen, orders);
      chosen.pop_back();
    }
  }

  const Tree& tree_;
  const Bodies& bodies_;
  const std::vector<bool>& left_open_;  // by link
  Poses poses_;
  double size_ = 1.0;                      // [m]
  bool is_wrist_ = false;                  // whether all chains have an end in one place
  std::optional<Eigen::Vector3d> normal_;  // of the planes of a planar robot
  std::vector<Body> terminal_, ended_;
  std::vector<std::size_t> anchors_;
  std::vector<std::vector<std::size_t>> tips_;  // of each chain, what may be its end
  OpenEnds result_;
};

}  // namespace

OpenEnds find_open_ends(const Tree& tree, const Bodies& bodies) {
  const std::vector<bool> named = fittings(tree), alike = with_fingers(tree, bodies, named);
  const std::vector<bool> single = with_single_finger(tree, bodies, alike);
  EndFinder without_named(tree, bodies, named), without_fingers(tree, bodies, alike);
  EndFinder without_finger(tree, bodies, single);
  OpenEnds found = without_named.ends();
  std::set<std::set<std::set<std::size_t>>> known;
  const auto add = [&](const std::vector<EqualPairings>& all) {
    for (const EqualPairings& equals : all) {
      EqualPairings news;
      for (const Pairing& pairing : equals)
        if (known.insert(without_named.meetings(pairing)).second) news.push_back(pairing);
      if (!news.empty()) found.pairings.push_back(news);
    }
  };
  add(without_named.evident());
  add(without_fingers.evident());
  found.evident = !found.pairings.empty();
  add(without_fingers.forced());
  add(without_named.forced());
  for (const auto& all : {without_finger.evident(), without_finger.forced()}) add(all);
  if (!found.evident) add(without_named.others());
  found.cut_short = without_named.cut_short();
  found.may_have_finger = single != alike;
  return found;
}

}  // namespace parallel_aspects
