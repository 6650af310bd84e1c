// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/setup.h"

#include "urdf/description/nearest_name.h"
#include "urdf/reading/tree_reader.h"
#include "urdf/setup/closed_search.h"
#include "urdf/setup/open_ends.h"

#include <tinyxml2.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

std::vector<std::string> movable_joints(const Tree& tree) {
  std::vector<std::string> names;
  for (const std::size_t joint : tree.movable) names.push_back(tree.joints[joint].name);
  return names;
}

class Setup {
 public:
  Setup(const Tree& tree, const LoopSource& source, const SetupAnswers& answers, const SetupControl& control,
        const std::string& urdf_text)
      : tree_(tree),
        source_(source),
        answers_(answers),
        bodies_(tree),
        evidence_(find_joint_evidence(source)),
        subject_{tree,     bodies_, evidence_, urdf_text, source.files.urdf, source.files.config,
                 answers_, control} {
    result_.robot = tree.name;
  }

  SetupResult find() {
    check_answers();
    if (!result_.problems.empty()) return result_;
    if (!answers_.closures.empty()) return asked_closures();
    const FoundLoops described = find_described_loops(source_, result_.problems);
    if (!result_.problems.empty()) return result_;
    if (!described.loops.closures.empty()) {
      take(search_closed(subject_, described.loops.closures,
                         {{}, "the URDF describes them by " + std::string(described.dialect)}));
      return result_;
    }
    return open_ends();
  }

 private:
  void problem(const std::string& option, const std::string& kind, const std::string& name,
               const std::vector<std::string>& known) {
    result_.problems.push_back(option + " names " + kind + " '" + name + "', but " + source_.files.urdf +
                               " has no such " + kind + suggestion(name, known, result_.problems));
  }

  void check_link(const std::string& option, const std::string& name) {
    if (!name.empty() && !tree_.link_named(name)) problem(option, "link", name, tree_.links);
  }

  void check_answers() {
    check_link("--base", answers_.base_link);
    check_link("--platform", answers_.operational_point);
    for (const auto& pair : answers_.closures)
      for (const std::string& link : pair) check_link("--closures", link);
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
      result_.problems = found.problems;
      return;
    }
    SetupDraft& draft = found.draft;
    draft.task_space = found.mechanism->manipulator()->task_space();
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
    result_.mechanism =
        load_mechanism(subject_.urdf_text, subject_.urdf_name, result_.config, subject_.config_name);
  }

  SetupResult asked_closures() {
    Pairing asked{{}, "as asked for"};
    for (const auto& pair : answers_.closures)
      asked.pairs.push_back({*tree_.link_named(pair[0]), *tree_.link_named(pair[1]), ""});
    take(search_closed(subject_, closures_of(tree_, asked), described(asked)));
    return result_;
  }

  SetupCandidate described(const Pairing& pairing) const {
    SetupCandidate candidate{{}, pairing.reason};
    for (const EndPair& pair : pairing.pairs)
      candidate.values.push_back(tree_.links[pair.one] + "=" + tree_.links[pair.other]);
    return candidate;
  }

  SetupResult open_ends() {
    const OpenEnds ends = find_open_ends(tree_, bodies_);
    Problems first;
    for (const EqualPairings& equals : ends.pairings) {
      if (try_equals(equals, ends)) return result_;
      if (first.empty()) first = result_.problems;
      if (result_.cut_short) break;
    }
    result_.problems = first;
    if (ends.pairings.empty() || result_.cut_short || needs_frame(ends)) ask_for_closures(ends);
    return result_;
  }

  // Whether what was tried first holds a chain at its own last joint.
  static bool needs_frame(const OpenEnds& ends) {
    const auto& pairs = ends.pairings.front().front().pairs;
    return std::any_of(pairs.begin(), pairs.end(), [&](const EndPair& pair) {
      return std::count(ends.blunt.begin(), ends.blunt.end(), pair.other) > 0;
    });
  }

  // Whether one of them loads, or several do, which is a question.
  bool try_equals(const EqualPairings& equals, const OpenEnds& ends) {
    std::vector<std::pair<SetupCandidate, ClosedResult>> found;
    Problems first;
    bool cut_short = ends.cut_short && &equals == &ends.pairings.back();
    for (const Pairing& pairing : equals) {
      const SetupCandidate candidate = described(pairing);
      ClosedResult closed = search_closed(subject_, closures_of(tree_, pairing), candidate);
      cut_short = cut_short || closed.cut_short;
      if (first.empty()) first = closed.problems;
      if (closed.mechanism) found.emplace_back(candidate, std::move(closed));
      if (cut_short && closed.cut_short) break;
    }
    result_.problems = first;
    result_.cut_short = result_.cut_short || cut_short;
    if (found.empty()) return false;
    if (found.size() == 1 && !(cut_short && equals.size() > 1)) {
      result_.problems.clear();
      take(std::move(found.front().second));
      return true;
    }
    SetupQuestion question{"closures",
                           source_.files.urdf +
                               " does not tell which open ends meet: equally much speaks for " +
                               std::to_string(found.size()) + " ways to close the loops",
                           {}};
    for (auto& [candidate, closed] : found) question.candidates.push_back(candidate);
    result_.question = question;
    result_.problems.clear();
    return true;
  }

  void ask_for_closures(const OpenEnds& ends) {
    if (ends.links.size() < 2 && ends.blunt.size() < 2) {
      result_.problems = {
          source_.files.urdf +
          " is a serial chain with one end, which has no loops to close; this package treats parallel "
          "robots."};
      return;
    }
    SetupQuestion question{"closures", source_.files.urdf + " does not tell where its loops are closed", {}};
    if (!ends.blunt.empty())
      question.text +=
          "; link '" + tree_.links[ends.blunt.front()] +
          "' ends a chain and has no frame at its far end, so fix a link there to be named in --closures";
    else if (result_.cut_short)
      question.text += " in the time there is";
    for (const EqualPairings& equals : ends.pairings)
      for (const Pairing& pairing : equals)
        if (ends.blunt.empty()) question.candidates.push_back(described(pairing));
    result_.question = question;
    result_.problems.clear();
  }

  const Tree& tree_;
  const LoopSource& source_;
  const SetupAnswers& answers_;
  Bodies bodies_;
  JointEvidence evidence_;
  SetupSubject subject_;
  SetupResult result_;
};

}  // namespace

SetupResult set_up(const std::string& urdf_text, const std::string& urdf_name, const std::string& config_name,
                   const SetupAnswers& answers, const SetupControl& control) {
  SetupResult refused;
  std::vector<std::string> notes;
  const auto tree = read_tree(urdf_text, urdf_name, refused.problems, notes);
  if (!tree) return refused;
  tinyxml2::XMLDocument document;
  document.Parse(urdf_text.data(), urdf_text.size());
  const YAML::Node no_config(YAML::NodeType::Map);
  const SourceNames files{urdf_name, config_name};
  const LoopSource source{*document.FirstChildElement("robot"), no_config, *tree, files};
  return Setup(*tree, source, answers, control, urdf_text).find();
}

}  // namespace parallel_aspects
