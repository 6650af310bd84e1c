// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/closed_search.h"

#include "urdf/closing/freedom.h"
#include "urdf/closing/planar_layers.h"
#include "urdf/description/name_words.h"
#include "urdf/setup/actuation_candidates.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

// How many candidates are tried besides what is taken, to say that they would do as well: each costs an
// attempt, and a longer list is not read.
constexpr std::size_t max_others = 4;
constexpr std::size_t max_robots = 6;  // that a question lists: the legs of a walking machine

// Closures that are seldom, as welds, are tried for so many candidates: those with the most evidence, of
// actuated joints at the base and of others.
constexpr std::size_t max_with_all_types = 2;

// For so many platforms, and numbers of legs, a refusal searches for what would correct it, since each may
// take all attempts of an edit search.
constexpr std::size_t max_diagnosed = 4;

// Loops are closed from so many configurations until enough are found to know their freedom: the most of a
// few, as single ones may be singular, and not every start closes.
constexpr int max_starts = 16;
constexpr std::size_t enough = 4;

struct ClosedLoops {
  ClosureSystem system;
  std::vector<Eigen::VectorXd> closed;
};

class ClosedSearch {
 public:
  ClosedSearch(const SetupSubject& subject, SetupClosures closures, const SetupCandidate& described)
      : subject_(subject),
        tree_(subject.tree),
        bodies_(subject.bodies),
        graph_(subject.tree, subject.bodies, closures.all) {
    result_.closures = std::move(closures);
    for (const bool joint : graph_.in_loop()) result_.joints_in_loops += joint ? 1 : 0;
    result_.draft.robot = subject.tree.name;
    result_.draft.urdf_name = subject.urdf_name;
    result_.draft.closures = described;
    result_.draft.adds_closures =
        result_.closures.described > 0 && result_.closures.described < result_.closures.all.size();
  }

  ClosedResult find() {
    if (!find_base()) {
      result_.problems.push_back(subject_.urdf_name + " has no joint that " + closures() +
                                 " move; name frames at the two ends of each loop with --closures.");
      result_.is_refused = true;
      return result_;
    }
    const std::vector<Platform> all =
        platform_candidates(tree_, bodies_, graph_, base_, result_.closures.all, subject_.answers);
    const ActuationCandidate stated = stated_actuation(subject_.evidence);
    lacks_leg_ = subject_.answers.actuated_joints.empty() &&
                 lacks_a_leg(stated, tree_, bodies_, base_, graph_.in_loop());
    if (lacks_leg_ && !all.empty() && load_once(all.front(), stated)) return result_;
    for (const Platform& platform : all)
      for (const std::vector<GraphPart>& legs : platform.legs)
        if (try_legs(platform, legs)) {
          ask_for_robot(all);
          return result_;
        }
    result_.is_refused = !result_.problems.empty() || !result_.cut_short;
    if (result_.problems.empty()) result_.problems.push_back(reason_for_none());
    return result_;
  }

 private:
  // Where nothing was tried to the end.
  std::string reason_for_none() const {
    if (result_.cut_short) return not_in_time();
    return subject_.urdf_name + " has no link between which and the base link '" +
           result_.draft.base_link.values.front() + "' " + closures() +
           " make one, two, three or six legs; name other loops with --closures, or another base with "
           "--base.";
  }

  std::string not_in_time() const {
    return subject_.urdf_name + " could not be tried with " + closures() +
           " in the time there is; say more with --platform and --actuated.";
  }
  const std::string& link_name(std::size_t link) const { return tree_.links[link]; }

  // "the closures a=b c=d", for messages.
  std::string closures() const {
    if (result_.draft.closures.values.empty()) return "the closures that it describes";
    std::string text = "the closures";
    for (const std::string& pair : result_.draft.closures.values) text += " " + pair;
    return text;
  }
  bool is_late() const { return subject_.control.is_over(); }

  bool stopped() {
    result_.cut_short = result_.cut_short || is_late();
    return result_.cut_short;
  }

  bool find_base() {
    const auto found = graph_.base();
    if (!found) return false;
    base_ = *found;
    SetupCandidate& base = result_.draft.base_link;
    if (!subject_.answers.base_link.empty()) {
      base_ = bodies_.of(*tree_.link_named(subject_.answers.base_link));
      base = {{subject_.answers.base_link}, "as asked for"};
      return true;
    }
    if (const auto named = base_by_name(tree_, bodies_, graph_, base_)) base_ = *named;
    const std::vector<std::size_t>& links = bodies_.links(base_);
    const auto named = std::find_if(links.begin(), links.end(),
                                    [&](std::size_t link) { return says_base(link_name(link)); });
    const std::size_t link = named == links.end() ? links.front() : *named;
    base = {{link_name(link)}, reason_for_base(link)};
    return true;
  }

  std::string reason_for_base(std::size_t link) const {
    if (base_ != graph_.base())
      return "its name says so, and that of link '" + link_name(bodies_.links(*graph_.base()).front()) +
             "', where the tree starts, that it is the platform";
    if (link == 0) return "it is the root link, and the legs begin there";
    if (base_ == 0) return "its name says so, and it is fixed to the root link '" + link_name(0) + "'";
    const TreeJoint& below = tree_.joints[*tree_.joint_above[bodies_.links(base_).front()]];
    return "the legs begin there; joint '" + below.name + "' below it is in no loop and is left out";
  }

  std::vector<ActuationCandidate> actuations(const std::vector<GraphPart>& legs) const {
    const auto& names = subject_.answers.actuated_joints;
    if (names.empty()) return actuation_candidates(tree_, legs, subject_.evidence);
    std::vector<std::size_t> asked;
    for (const std::string& joint : names) asked.push_back(*tree_.joints[*tree_.joint_named(joint)].variable);
    return {{asked, 0, "as asked for"}};
  }

  // Whether each leg has one of the joints that are asked for.
  bool answers_fit(const std::vector<GraphPart>& legs) const {
    const auto& names = subject_.answers.actuated_joints;
    const auto asked = [&](std::size_t joint) {
      return std::find(names.begin(), names.end(), tree_.joint_of(joint).name) != names.end();
    };
    return names.empty() ||
           (names.size() == legs.size() && std::all_of(legs.begin(), legs.end(), [&](const GraphPart& leg) {
              return std::count_if(leg.variables.begin(), leg.variables.end(), asked) == 1;
            }));
  }

  SetupCandidate described(const ActuationCandidate& actuation) const {
    SetupCandidate candidate{{}, actuation.reason};
    for (const std::size_t joint : actuation.variables)
      candidate.values.push_back(tree_.joint_of(joint).name);
    return candidate;
  }

  // Whether these legs led to a mechanism or a question. Of the candidates that load, those with the
  // strongest evidence are equals, and so are those that there is no time to try; beside a guess the others
  // are listed.
  bool try_legs(const Platform& platform, const std::vector<GraphPart>& legs) {
    const std::vector<ActuationCandidate> candidates = actuations(legs);
    if (!answers_fit(legs)) return load_once(platform, candidates.front());
    legs_ = legs.size();
    std::vector<SetupCandidate> equals, others;
    int weight = 0;
    for (std::size_t k = 0; k < candidates.size() && others.size() < max_others; ++k) {
      const ActuationCandidate& candidate = candidates[k];
      if (lacks_leg_ && !is_stated(candidate, subject_.evidence)) continue;
      if (equals.empty()) {
        if (stopped()) return false;
        if (!try_links(platform, candidate, k < max_with_all_types)) continue;
        weight = candidate.weight;
        equals.push_back(described(candidate));
      } else if (candidate.weight == weight) {
        if (loads(candidate) || stopped()) equals.push_back(described(candidate));
      } else if (candidate.is_guess && loads(candidate)) {
        others.push_back(described(candidate));
      }
    }
    if (equals.empty()) return false;
    if (equals.size() > 1) ask_for_actuated_joints(equals);
    result_.draft.others.push_back({"actuated_joints", equals.front(), others});
    add_other_points(platform);
    note_actuation(legs);
    return true;
  }

  // What the URDF says of actuated joints and was not followed.
  void note_actuation(const std::vector<GraphPart>& legs) {
    std::vector<std::size_t> variables;
    for (const std::string& name : result_.draft.actuated_joints.values)
      variables.push_back(*tree_.joints[*tree_.joint_named(name)].variable);
    const TakenActuation taken{tree_, subject_.evidence, graph_.in_loop(), legs, variables};
    if (const auto note = note_on_stated(taken, subject_.urdf_name)) result_.notes.push_back(*note);
    if (!subject_.answers.actuated_joints.empty()) return;
    const auto ruled_out = ruled_out_by_mimic(taken);
    if (!ruled_out) return;
    SetupDraft draft = result_.draft;
    draft.actuated_joints = described(*ruled_out);
    Problems unused;
    if (loaded(draft, unused)) result_.notes.push_back(note_on_mimic(tree_, *ruled_out, subject_.urdf_name));
  }

  // Links of the platform beside the one that was taken: those whose names say so as well, and where none
  // does all that no closure holds.
  void add_other_points(const Platform& platform) {
    if (!subject_.answers.operational_point.empty()) return;
    const std::string taken = result_.draft.operational_point.values.front();
    const bool is_guess = operational_point_likeness(taken) == 0;
    std::vector<SetupCandidate> others;
    for (const std::size_t link : platform.links) {
      const std::string& name = link_name(link);
      if (name == taken || placed_frame(name) || others.size() == max_others || is_late()) continue;
      if (is_guess ? is_closed(result_.closures.all, link) : operational_point_likeness(name) == 0) continue;
      SetupDraft draft = result_.draft;
      draft.operational_point.values = {name};
      if (loads(draft)) others.push_back({{name}, "on the same body"});
    }
    result_.draft.others.push_back({"operational_point", result_.draft.operational_point, others});
  }

  // So that the loader says why it does not.
  bool load_once(const Platform& platform, const ActuationCandidate& actuation) {
    if (!result_.tried.empty()) return false;
    begin_draft(platform, platform.links.front(), actuation);
    result_.draft.closure_type = "spherical";
    return load();
  }

  // Where there are several robots, as the legs of a walking machine, each with joints of its own that are
  // stated to be actuated.
  void ask_for_robot(const std::vector<Platform>& all) {
    const SetupAnswers& answers = subject_.answers;
    if (result_.question || !answers.operational_point.empty() || !answers.actuated_joints.empty()) return;
    std::set<std::string> known(result_.draft.actuated_joints.values.begin(),
                                result_.draft.actuated_joints.values.end());
    std::vector<SetupCandidate> robots{robot_of(result_.draft)};
    for (const Platform& platform : all)
      for (const std::vector<GraphPart>& legs : platform.legs) {
        const auto candidates = actuations(legs);
        if (candidates.empty() || !is_stated(candidates.front(), subject_.evidence)) continue;
        SetupDraft draft = result_.draft;
        draft.actuated_joints = described(candidates.front());
        const std::vector<std::string>& joints = draft.actuated_joints.values;
        const auto is_known = [&](const std::string& joint) { return known.count(joint) > 0; };
        if (std::any_of(joints.begin(), joints.end(), is_known) || robots.size() > max_robots) continue;
        for (const std::size_t link : platform.links) {
          draft.operational_point.values = {link_name(link)};
          if (is_late() || !loads(draft)) continue;
          known.insert(joints.begin(), joints.end());
          robots.push_back(robot_of(draft));
          break;
        }
      }
    if (robots.size() > 1)
      result_.question = {"operational_point",
                          subject_.urdf_name + " has " + std::to_string(robots.size()) +
                              " robots, each with actuated joints of its own; say which is meant",
                          robots,
                          {}};
  }

  static SetupCandidate robot_of(const SetupDraft& draft) {
    std::string joints;
    for (const std::string& joint : draft.actuated_joints.values)
      joints += (joints.empty() ? "'" : ", '") + joint + "'";
    return {draft.operational_point.values, "actuated by " + joints};
  }

  void ask_for_actuated_joints(const std::vector<SetupCandidate>& equals) {
    result_.question = {"actuated_joints",
                        subject_.urdf_name +
                            " does not say which joints are actuated: the evidence is equal for " +
                            std::to_string(equals.size()) + " combinations",
                        equals,
                        {}};
  }

  bool try_links(const Platform& platform, const ActuationCandidate& actuation, bool all_types) {
    for (const std::size_t link : platform.links) {
      begin_draft(platform, link, actuation);
      if (try_types(all_types && link == platform.links.front())) return true;
      if (stopped()) return false;
    }
    return false;
  }

  void begin_draft(const Platform& platform, std::size_t link, const ActuationCandidate& actuation) {
    result_.draft.operational_point = {{link_name(link)}, reason_for_link(platform, link)};
    result_.draft.actuated_joints = described(actuation);
  }

  std::string reason_for_link(const Platform& platform, std::size_t link) const {
    if (!subject_.answers.operational_point.empty()) return "as asked for";
    const bool named = operational_point_likeness(link_name(link)) > 0;
    if (platform.links.size() == 1) return "it is the body that the legs share";
    return named ? "its name says so, among the links of the body that the legs share"
                 : "a guess among the links of the body that the legs share, as no name says it";
  }

  // The first type under which the mechanism loads, revolute where a ball joint would only hold less.
  bool try_types(bool all_types) {
    if (result_.draft.closures.values.empty()) return load();
    std::vector<CountedType> types{
        {"spherical", 3, true}, {"revolute", 5, true}, {"universal", 4, false}, {"fixed", 6, false}};
    const auto is_left_out = [&](const CountedType& type) {
      return !all_types && !type.usual && !fits(type);
    };
    types.erase(std::remove_if(types.begin(), types.end(), is_left_out), types.end());
    std::stable_partition(types.begin(), types.end(), [this](const CountedType& type) { return fits(type); });
    for (const CountedType& type : types) {
      if (!try_type(type.name)) continue;
      if (type.held == 3) prefer_revolute();
      return true;
    }
    return false;
  }

  struct CountedType {
    const char* name;
    std::size_t held;  // degrees of freedom that it takes in space
    bool usual;
  };

  // Whether the joints less what closures hold make the degrees of freedom of the platform, and no more than
  // a rod of each leg that spins. Planar and spherical robots have fewer by this count.
  bool fits(const CountedType& type) const {
    const std::size_t held = type.held * result_.draft.closures.values.size();
    return result_.joints_in_loops >= held + legs_ && result_.joints_in_loops <= held + 2 * legs_;
  }

  bool try_type(const char* type) {
    result_.draft.closure_type = type;
    if (is_ruled_out("spherical") || is_ruled_out(type)) {
      if (is_new_platform()) result_.tried.push_back(result_.draft);
      return false;
    }
    if (load()) return true;
    learn_freedom(type);
    return false;
  }

  // Whether the platform moves in fewer ways than it has legs; all types hold what spherical closures do.
  bool is_ruled_out(const std::string& type) const {
    const auto known = freedoms_.find(type);
    return known != freedoms_.end() &&
           freedom_of(known->second.system, known->second.closed,
                      *tree_.link_named(result_.draft.operational_point.values.front())) < legs_;
  }

  // Where an attempt has failed, others may.
  void learn_freedom(const std::string& type) {
    const auto known = closure_type_named(type);
    if (!known || *known == ClosureType::automatic || freedoms_.count(type) > 0 || stopped()) return;
    const std::size_t base = *tree_.link_named(result_.draft.base_link.values.front());
    std::vector<Closure> typed = with_type(result_.closures.all, *known);
    subject_.control.count_attempt(result_.joints_in_loops);
    join_layers(tree_, base, {subject_.urdf_name, subject_.config_name}, typed);
    const ClosureSystem system({std::shared_ptr<const Tree>(), &tree_}, base, std::move(typed));
    freedoms_.emplace(type, ClosedLoops{system, closed_configurations(system, max_starts, enough)});
  }

  void prefer_revolute() {
    const TaskSpace space = result_.mechanism->manipulator()->task_space();
    if (space == TaskSpace::SE3 || space == TaskSpace::T3) return;
    const auto ball = result_.mechanism;
    if (try_type("revolute")) return;
    result_.mechanism = ball;
    result_.draft.closure_type = "spherical";
  }

  std::shared_ptr<const Mechanism> loaded(const SetupDraft& draft, Problems& problems) const {
    return tried(subject_, draft, result_.closures, result_.joints_in_loops, false, problems);
  }

  bool load() {
    if (stopped()) return false;
    Problems problems;
    result_.mechanism = loaded(result_.draft, problems);
    if (!result_.mechanism && result_.tried.empty()) result_.problems = problems;
    if (!result_.mechanism && is_new_platform()) result_.tried.push_back(result_.draft);
    stopped();
    return result_.mechanism != nullptr;
  }

  // Or with other legs, as where a chain that it hangs on was taken for one.
  bool is_new_platform() const {
    const std::size_t body = bodies_.of(*tree_.link_named(result_.draft.operational_point.values.front()));
    const std::size_t legs = result_.draft.actuated_joints.values.size();
    return result_.tried.size() < max_diagnosed &&
           std::none_of(result_.tried.begin(), result_.tried.end(), [&](const SetupDraft& other) {
             return bodies_.of(*tree_.link_named(other.operational_point.values.front())) == body &&
                    other.actuated_joints.values.size() == legs;
           });
  }

  // Whether it would do as well as what was found.
  bool loads(const ActuationCandidate& actuation) const {
    SetupDraft draft = result_.draft;
    draft.actuated_joints = described(actuation);
    return loads(draft);
  }
  bool loads(const SetupDraft& draft) const {
    Problems unused;
    return loaded(draft, unused) != nullptr;
  }

  const SetupSubject& subject_;
  const Tree& tree_;
  const Bodies& bodies_;
  BodyGraph graph_;
  std::map<std::string, ClosedLoops> freedoms_;  // under closures of this type
  std::size_t base_ = 0;                         // body
  std::size_t legs_ = 0;                         // of what is being tried
  bool lacks_leg_ = false;                       // one with a joint that is stated to be actuated
  ClosedResult result_;
};

}  // namespace

ClosedResult search_closed(const SetupSubject& subject, SetupClosures closures,
                           const SetupCandidate& described) {
  return ClosedSearch(subject, std::move(closures), described).find();
}

}  // namespace parallel_aspects
