// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/setup.h"

#include "urdf/closing/ends_of_loops.h"
#include "urdf/description/nearest_name.h"
#include "urdf/description/xml_values.h"
#include "urdf/load_mechanism.h"
#include "urdf/reading/tree_reader.h"
#include "urdf/setup/closed_search.h"
#include "urdf/setup/left_open.h"
#include "urdf/setup/open_ends.h"
#include "urdf/setup/setup_config.h"

#include <tinyxml2.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

std::vector<std::string> movable_joints(const Tree& tree) {
  std::vector<std::string> names;
  for (const std::size_t joint : tree.movable) names.push_back(tree.joints[joint].name);
  return names;
}

// Of open type.
std::vector<Closure> closures_of(const Tree& tree, const Pairing& pairing) {
  std::vector<Closure> closures;
  for (const EndPair& pair : pairing.pairs)
    closures.push_back({tree.links[pair.one] + " - " + tree.links[pair.other],
                        {LinkFrame{pair.one, pair.in_link[0]}, LinkFrame{pair.other, pair.in_link[1]}},
                        ClosureType::automatic});
  return closures;
}

constexpr std::size_t least_of_arm = 3;     // joints: fewer are a turntable, or a rail with one
constexpr std::size_t most_ends_named = 8;  // open ends of a refusal; of more it has the count

using Refused = std::pair<const Pairing*, ClosedResult>;

class Setup {
 public:
  Setup(const Tree& tree, const std::shared_ptr<const Tree>& tree_read, const LoopSource& source,
        const SetupAnswers& answers, const SetupControl& control, const std::string& urdf_text)
      : tree_(tree),
        source_(source),
        answers_(answers),
        control_(control),
        bodies_(tree),
        evidence_(find_joint_evidence(source)),
        subject_{tree,     tree_read, bodies_, evidence_, source.files.urdf, source.files.config,
                 answers_, control},
        urdf_text_(urdf_text) {
    result_.robot = tree.name;
    note_unknown_joints();
  }

  SetupResult find() {
    check_answers();
    if (!result_.problems.empty()) return result_;
    const FoundLoops described = find_described_loops(source_, result_.problems);
    if (!answers_.closures.empty()) return asked_closures(described);
    if (!result_.problems.empty()) return result_;
    if (!described.loops.closures.empty()) {
      described_closures(described);
      return result_;
    }
    return open_ends();
  }

  // These ends as they are written, if a robot is made of them.
  std::optional<SetupCandidate> loading(const Pairing& pairing) const {
    const SetupCandidate candidate = described(pairing);
    const bool loads = search_closed(subject_, {closures_of(tree_, pairing)}, candidate).mechanism != nullptr;
    return loads ? std::optional<SetupCandidate>(candidate) : std::nullopt;
  }

 private:
  // What is stated of joints that are not there, or do not move, is no evidence.
  void note_unknown_joints() {
    for (const std::string& name : evidence_.unknown) {
      const bool is_fixed = tree_.joint_named(name).has_value();
      Problems unused;
      result_.notes.push_back(
          source_.files.urdf + " has a " + evidence_.stated_in + " of joint '" + name + "', " +
          (is_fixed ? "which is fixed; it counts for nothing."
                    : "but no such joint" + suggestion(name, movable_joints(tree_), unused)));
    }
  }

  void problem(const std::string& option, const std::string& kind, const std::string& name,
               const std::vector<std::string>& known) {
    result_.problems.push_back(option + " names " + kind + " '" + name + "', but " + source_.files.urdf +
                               " has no such " + kind + suggestion(name, known, result_.problems));
  }

  void check_link(const std::string& option, const std::string& name) {
    if (name.empty() || tree_.link_named(name)) return;
    const auto frame = placed_frame(name);
    const std::string before = name.substr(0, name.rfind('@'));
    if (!frame && before != name && tree_.link_named(before))
      result_.problems.push_back(option + " has '" + name + "'; write a place in the frame of link '" +
                                 before + "' with three coordinates, as " + before + "@X:Y:Z [m].");
    else
      problem(option, "link", frame ? frame->link : name, tree_.links);
  }

  void check_closure(const std::array<std::string, 2>& links) {
    for (const std::string& link : links) check_link("--closures", link);
    const auto one = tree_.link_named(links[0]), other = tree_.link_named(links[1]);
    if (one && other && bodies_.of(*one) == bodies_.of(*other))
      result_.problems.push_back("--closures has '" + links[0] + "=" + links[1] + "', but in " +
                                 source_.files.urdf +
                                 " these are fixed to each other; name links that joints move apart.");
  }

  void check_answers() {
    check_link("--base", answers_.base_link);
    check_link("--platform", answers_.operational_point);
    for (const auto& pair : answers_.closures) check_closure(pair);
    for (const std::string& name : answers_.actuated_joints) {
      const auto joint = tree_.joint_named(name);
      if (!joint || !tree_.joints[*joint].variable)
        problem("--actuated", "movable joint", name, movable_joints(tree_));
    }
  }

  // What a mechanism was found with becomes the result.
  void take(ClosedResult found) {
    result_.cut_short = result_.cut_short || found.cut_short;
    result_.question = found.question;
    if (!found.mechanism) {
      refuse(found);
      result_.problems.insert(result_.problems.end(), result_.notes.begin(), result_.notes.end());
      return;
    }
    SetupDraft& draft = found.draft;
    result_.notes.insert(result_.notes.end(), found.notes.begin(), found.notes.end());
    draft.task_space = found.mechanism->manipulator()->task_space();
    for (const std::string& note :
         wrist_notes(tree_, bodies_, *found.mechanism, draft.closures.values, source_.files.urdf))
      result_.notes.push_back(note);
    draft.notes = result_.notes;
    for (const auto& [key, candidate] :
         {std::pair<const char*, const SetupCandidate*>{"base_link", &draft.base_link},
          {"closures", &draft.closures},
          {"operational_point", &draft.operational_point},
          {"actuated_joints", &draft.actuated_joints}}) {
      SetupChoice choice{key, *candidate, {}};
      for (const SetupChoice& others : draft.others)
        if (others.key == key) choice.others = others.others;
      result_.choices.push_back(choice);
    }
    if (result_.question) return;
    result_.config = config_text(draft);
    try {
      result_.mechanism =
          load_mechanism(urdf_text_, subject_.urdf_name, result_.config, subject_.config_name);
    } catch (const InvalidDescription&) {  // as of places far away, or by lengths of another link
      result_.problems = problems_as_options();
      return;
    }
    for (const Note& note : result_.mechanism->notes_in_pieces())
      if (note.has(Note::Piece::Kind::closures)) draft.closure_notes.push_back(note);
    draft.home = result_.mechanism->home().pose;
    result_.config = config_text(draft);
  }

  Problems problems_as_options() const {
    LoadSearch search;
    search.as_options = true;
    try {
      load_mechanism(urdf_text_, subject_.urdf_name, result_.config, subject_.config_name, "", search);
    } catch (const InvalidDescription& invalid) {
      return invalid.problems();
    }
    return {};
  }

  // Whether it is known why.
  bool refuse(const ClosedResult& found) {
    const Refusal refusal = refusal_of(subject_, found);
    result_.problems = refusal.problems;
    if (const auto arm = refusal.is_explained ? std::nullopt : arm_with_loops(found))
      result_.problems.insert(result_.problems.begin(), *arm);
    return refusal.is_explained;
  }

  // As an arm with a gripper of four-bars.
  std::optional<std::string> arm_with_loops(const ClosedResult& found) const {
    if (found.draft.base_link.values.empty()) return std::nullopt;
    const std::string& base = found.draft.base_link.values.front();
    const std::size_t joints = movable_joints_to(tree_, *tree_.link_named(base)).size();
    if (joints < least_of_arm) return std::nullopt;
    return source_.files.urdf + " is a serial arm of " + std::to_string(joints) + " joints from link '" +
           tree_.links.front() + "' to link '" + base +
           "'; only parallel robots are treated, and the loops that it carries make none.";
  }

  // By a part of the work that is left, so that some is for why they make no robot.
  ClosedResult search_by_part(SetupClosures closures, const SetupCandidate& described,
                              std::size_t parts) const {
    SetupSubject subject = subject_;
    const std::size_t left = control_.work - std::min(control_.work, *control_.done);
    subject.control.work -= left - left / parts;
    return search_closed(subject, std::move(closures), described);
  }

  void described_closures(const FoundLoops& loops) {
    SetupClosures closures{loops.loops.closures, 0, std::string(loops.dialect)};
    closures.described = closures.all.size();
    take(search_by_part(std::move(closures), {{}, "the URDF describes them by " + std::string(loops.dialect)},
                        2));
  }

  // Beside those that the URDF describes, or in their place.
  SetupResult asked_closures(const FoundLoops& described_loops) {
    const std::vector<Closure>& in_urdf = described_loops.loops.closures;
    result_.problems.clear();
    Pairing asked{{}, "as asked for"};
    for (const auto& [one, other] : answers_.closures)
      if (!is_asked_before(one, other, asked))
        asked.pairs.push_back({*tree_.link_named(one), *tree_.link_named(other)});
    const std::vector<Closure> added = closures_of(tree_, asked);
    const std::size_t replaced = closed_again(bodies_, in_urdf, added);
    if (replaced > 0 && replaced < in_urdf.size()) {
      result_.problems = {"--closures has some of the loops that " + source_.files.urdf +
                          " closes itself, and not all; write all loops, or only those that it leaves open."};
      return result_;
    }
    const bool adds = replaced == 0 && !in_urdf.empty();
    SetupClosures closures;
    if (adds) closures = {in_urdf, in_urdf.size(), std::string(described_loops.dialect)};
    closures.all.insert(closures.all.end(), added.begin(), added.end());
    SetupCandidate candidate = described(asked);
    if (adds) candidate.reason += ", beside those that the URDF describes";
    take(search_closed(subject_, std::move(closures), candidate));
    return result_;
  }

  // Either way round.
  bool is_asked_before(const std::string& one, const std::string& other, const Pairing& asked) const {
    return std::any_of(asked.pairs.begin(), asked.pairs.end(), [&](const EndPair& pair) {
      const std::string &first = tree_.links[pair.one], &second = tree_.links[pair.other];
      return (first == one && second == other) || (first == other && second == one);
    });
  }

  SetupCandidate described(const Pairing& pairing) const {
    SetupCandidate candidate{{}, pairing.reason};
    for (const EndPair& pair : pairing.pairs)
      candidate.values.push_back(written(pair.one, pair.in_link[0]) + "=" +
                                 written(pair.other, pair.in_link[1]));
    return candidate;
  }

  std::string written(std::size_t link, const Eigen::Isometry3d& in_link) const {
    const std::string& name = tree_.links[link];
    return in_link.isApprox(Eigen::Isometry3d::Identity())
               ? name
               : placed_name(name, in_link.translation(), roll_pitch_yaw(in_link.linear()));
  }

  SetupResult open_ends() {
    const OpenEnds ends = find_open_ends(tree_, bodies_);
    const auto serial = ends.evident ? std::nullopt : serial_arm_text(tree_, source_.files.urdf);
    if (serial) {
      result_.problems = {*serial};
      result_.is_serial_arm = true;
      return result_;
    }
    result_.question = question_of_places(tree_, ends, source_.files.urdf);
    if (result_.question) return result_;
    const bool lacks_tips = !ends_without_tip_frame(ends).empty();
    if (!have_no_tip_frames(ends)) {
      if (try_hinges(ends)) return result_;
      for (const EqualPairings& equals : ends.pairings) {
        const bool is_first = refused_.empty();
        if (try_equals(equals, ends)) return result_;
        if (is_first) std::stable_partition(refused_.begin(), refused_.end(), holds_each_end_once);
        for (const Refused& refused : refused_)
          if (is_first && !lacks_tips && !ends.may_have_finger && explains(refused.second, ends))
            return result_;
        if (result_.cut_short || lacks_tips) break;
      }
    }
    if (refused_.empty() || lacks_tips || any_untried(ends))
      ask_for_closures(ends);
    else if (why_refused_.empty())
      refuse_ends(refused_.front().second, ends);
    else
      result_.problems = why_refused_;
    return result_;
  }

  // Whether the axes that hinges of like legs have make a robot, where ends alone do not say them.
  bool try_hinges(const OpenEnds& ends) {
    if (!ends.evident || ends.pairings.front().size() > 1) return false;
    const auto hinged = like_hinges(tree_, bodies_, ends.pairings.front().front());
    ClosedResult closed =
        hinged ? search_by_part({closures_of(tree_, *hinged)}, described(*hinged), 4) : ClosedResult{};
    if (!closed.mechanism) return false;
    take(std::move(closed));
    return true;
  }

  // Whether one element that is edited makes a robot of what was refused, or nothing does whatever is edited:
  // then that is the cause, and not which ends meet.
  bool explains(const ClosedResult& refused, const OpenEnds& ends) {
    const Problems before = result_.problems;
    if (refuse_ends(refused, ends)) return true;
    if (why_refused_.empty()) why_refused_ = result_.problems;
    result_.problems = before;
    return false;
  }

  static bool holds_each_end_once(const Refused& refused) {
    std::set<std::size_t> ends;
    for (const EndPair& pair : refused.first->pairs) ends.insert({pair.one, pair.other});
    return ends.size() == 2 * refused.first->pairs.size();
  }

  bool refuse_ends(const ClosedResult& first, const OpenEnds& ends) {
    const bool is_explained = refuse(first);
    std::string names = std::to_string(ends.links.size()) + " open ends";
    if (ends.links.size() <= most_ends_named) {
      names = "open ends ";
      for (const std::size_t link : ends.links)
        names += (link == ends.links.front() ? "" : ", ") + tree_.links[link];
    }
    result_.problems.back() += " If others of the " + names +
                               " meet, name them with --closures; those that are in no loop are left out.";
    return is_explained;
  }

  // Links that what was tried first holds at their own joint; with them, those that several chains end at.
  std::vector<std::size_t> ends_without_tip_frame(const OpenEnds& ends) const {
    const std::vector<EndPair> pairs = first_pairs(ends);
    std::vector<std::size_t> without_tip_frame, links;
    std::map<std::size_t, int> closures;
    for (const EndPair& pair : pairs)
      for (const std::size_t link : {pair.one, pair.other}) {
        if (++closures[link] > 1) continue;
        links.push_back(link);
        if (contains(ends.without_tip_frame, link)) without_tip_frame.push_back(link);
      }
    for (const std::size_t link : links)
      if (!without_tip_frame.empty() && closures[link] > 1 && !contains(without_tip_frame, link))
        without_tip_frame.push_back(link);
    return without_tip_frame;
  }

  static bool contains(const std::vector<std::size_t>& links, std::size_t link) {
    return std::find(links.begin(), links.end(), link) != links.end();
  }

  // Rods without any length make no robot. A single pair may be that of hubs, which are held at their joints.
  bool have_no_tip_frames(const OpenEnds& ends) const {
    const std::vector<EndPair> pairs = first_pairs(ends);
    return pairs.size() > 1 && std::all_of(pairs.begin(), pairs.end(), [&](const EndPair& pair) {
             return contains(ends.without_tip_frame, pair.one) &&
                    contains(ends.without_tip_frame, pair.other);
           });
  }

  // Where nothing was tried, each end with what may be the platform.
  std::vector<EndPair> first_pairs(const OpenEnds& ends) const {
    if (!ends.pairings.empty()) return ends.pairings.front().front().pairs;
    std::vector<EndPair> pairs;
    for (const std::size_t link : ends.links)
      if (ends.platform && bodies_.of(link) != bodies_.of(*ends.platform))
        pairs.push_back({*ends.platform, link});
    return pairs;
  }

  // Whether one of them loads, or several do, which is a question.
  bool try_equals(const EqualPairings& equals, const OpenEnds& ends) {
    std::vector<std::pair<SetupCandidate, ClosedResult>> found;
    bool cut_short = ends.cut_short && &equals == &ends.pairings.back();
    for (const Pairing& pairing : equals) {
      const SetupCandidate candidate = described(pairing);
      ClosedResult closed =
          search_by_part({closures_of(tree_, pairing)}, candidate, refused_.empty() ? 2 : 1);
      cut_short = cut_short || closed.cut_short;
      if (closed.mechanism)
        found.emplace_back(candidate, std::move(closed));
      else if (closed.is_refused)
        refused_.emplace_back(&pairing, std::move(closed));
      if (cut_short && closed.cut_short) break;
    }
    result_.cut_short = result_.cut_short || cut_short;
    if (found.empty()) return false;
    const bool only_one = found.size() == 1 && !(cut_short && equals.size() > 1);
    if (only_one) {
      take(std::move(found.front().second));
      return true;
    }
    SetupQuestion question{"closures", source_.files.urdf + why_to_ask(found.size()), {}, {}};
    for (auto& [candidate, closed] : found) question.candidates.push_back(candidate);
    result_.question = question;
    return true;
  }

  bool is_refused(const Pairing& pairing) const {
    return std::any_of(refused_.begin(), refused_.end(),
                       [&](const Refused& refused) { return refused.first == &pairing; });
  }

  bool any_untried(const OpenEnds& ends) const {
    return ends.cut_short ||
           std::any_of(ends.pairings.begin(), ends.pairings.end(), [this](const EqualPairings& equals) {
             return std::any_of(equals.begin(), equals.end(),
                                [this](const Pairing& pairing) { return !is_refused(pairing); });
           });
  }

  static std::string why_to_ask(std::size_t found) {
    if (found == 1)
      return " does not say which open ends meet; the search ended before all ways to close the loops were "
             "tried, and of those that were one loads";
    return " does not say which open ends meet: the evidence is equal for " + std::to_string(found) +
           " ways to close the loops";
  }

  void ask_for_closures(const OpenEnds& ends) {
    SetupQuestion question{
        "closures", source_.files.urdf + " does not say where its loops are closed", {}, {}};
    const std::vector<std::size_t> without_tip_frame = ends_without_tip_frame(ends);
    for (const EndPair& pair : first_pairs(ends))
      question.example.push_back(example_of(pair.one, without_tip_frame) + "=" +
                                 example_of(pair.other, without_tip_frame));
    if (question.example.empty()) {
      result_.problems = {source_.files.urdf +
                          " has one chain alone that could be in a loop; there is nothing to close, and only "
                          "parallel robots are treated."};
      return;
    }
    if (!without_tip_frame.empty())
      question.text += "; " + ends_of_chains(without_tip_frame) +
                       " no frame at the far end: give each place in the frame of its link as X:Y:Z [m]";
    else if (result_.cut_short)
      question.text += " in the time there is";
    question.text += "; ends that are in no loop, as fingers, are left out of --closures";
    for (const EqualPairings& equals : ends.pairings)
      for (const Pairing& pairing : equals)
        if (without_tip_frame.empty() && !is_refused(pairing))
          question.candidates.push_back(described(pairing));
    result_.question = question;
  }

  std::string example_of(std::size_t link, const std::vector<std::size_t>& without_tip_frame) const {
    return tree_.links[link] + (contains(without_tip_frame, link) ? "@X:Y:Z" : "");
  }

  // "links 'a', 'b' end chains and have"
  std::string ends_of_chains(const std::vector<std::size_t>& links) const {
    std::string names;
    for (const std::size_t link : links) names += (names.empty() ? "'" : ", '") + tree_.links[link] + "'";
    return links.size() == 1 ? "link " + names + " ends a chain and has"
                             : "links " + names + " end chains and have";
  }

  const Tree& tree_;
  const LoopSource& source_;
  const SetupAnswers& answers_;
  const SetupControl& control_;
  Bodies bodies_;
  JointEvidence evidence_;
  SetupSubject subject_;
  const std::string& urdf_text_;
  std::vector<Refused> refused_;  // of the open ends
  Problems why_refused_;          // the first of these, if that is known
  SetupResult result_;
};

// As links of the tree: two legs may meet there.
void add_ends_of_closures(const LoopSource& source, Tree& tree) {
  Problems unused;
  for (const Closure& closure : find_described_loops(source, unused).loops.closures)
    for (const LinkFrame& frame : closure.frames)
      if (!frame.in_link.translation().isZero())
        add_placed_frame(tree, placed_name(tree.links[frame.link], frame.in_link.translation()));
}

// The tree has them as links.
void add_frames(const SetupAnswers& answers, Tree& tree) {
  for (const auto& pair : answers.closures)
    for (const std::string& frame : pair) add_placed_frame(tree, frame);
  add_placed_frame(tree, answers.operational_point);
}

}  // namespace

SetupResult set_up(const std::string& urdf_text, const std::string& urdf_name, const std::string& config_name,
                   const SetupAnswers& answers, const SetupControl& control) {
  if (const auto text = from_latin_1(urdf_text))
    return set_up(*text, urdf_name, config_name, answers, control);
  SetupResult refused;
  Notes notes;
  auto tree = read_tree(urdf_text, urdf_name, refused.problems, notes);
  if (!tree) return refused;
  const auto tree_read = std::make_shared<const Tree>(*tree);
  add_frames(answers, *tree);
  tinyxml2::XMLDocument document;
  document.Parse(urdf_text.data(), urdf_text.size());
  const YAML::Node no_config(YAML::NodeType::Map);
  const SourceNames files{urdf_name, config_name};
  const LoopSource source{*document.FirstChildElement("robot"), no_config, *tree, files};
  add_ends_of_closures(source, *tree);
  Setup setup(*tree, tree_read, source, answers, control, urdf_text);
  SetupResult found = setup.find();
  if (answers.closures.empty() && answers.base_link.empty())
    if (const auto on_root = ends_on_root(*tree, Bodies(*tree), found))
      if (const auto leg = setup.loading(*on_root)) found.question = question_of_leg(found, *leg, urdf_name);
  return found;
}

}  // namespace parallel_aspects
