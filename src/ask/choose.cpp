// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/choose.h"

#include "ask/question_parts.h"

#include <utility>

namespace parallel_aspects {

const char* name(Violation kind) noexcept {
  switch (kind) {
    case Violation::singularity:
      return "parallel_singularity";
    case Violation::out_of_reach:
      return "serial_singularity";
    case Violation::joint_limit:
      return "actuated_limit";
    case Violation::constraint:
      return "constraint";
    case Violation::none:
      break;
  }
  return "none";
}

namespace ask {
namespace {

/// One question on its way to an answer.
class Choosing {
 public:
  Choosing(Session& session, const ChooseQuestion& question, const Control& control)
      : session_(session), question_(question), control_(control) {}

  Outcome<ChooseAnswer> run() {
    answer_.task_space = robot().task_space();
    check();
    if (problems_.empty()) question_.path ? choose_for_path() : choose_for_region();
    return outcome_of(std::move(problems_), control_, std::move(answer_));
  }

 private:
  const Manipulator& robot() const { return *session_.robot(); }

  void check() {
    const bool has_region = !question_.region.empty();
    if (!question_.path && !has_region)
      refuse(ProblemKind::missing, "path", "{path} or {region} is required",
             "give the one, for a tool path, or the other, for a box of poses");
    else if (question_.path && has_region)
      refuse(ProblemKind::together, "path",
             "Give one of {path}, for a tool path, and {region}, for a box of poses.", "");
    else if (question_.path && question_.hold)
      refuse(ProblemKind::together, "slice", "{slice} is of {region}", "leave it out with {path}");
    else if (has_region && question_.prefer)
      refuse(ProblemKind::together, "prefer", "{prefer} is of {path}", "leave it out with {region}");
    else if (has_region && question_.changes)
      refuse(ProblemKind::together, "changes", "{changes} is of {path}", "leave it out with {region}");
  }

  void refuse(ProblemKind kind, const char* field, const char* fault, const char* remedy) {
    problems_.push_back({kind, field, fault, remedy});
  }

  // Maps of one or two degrees of freedom are quick; aspects of others are distinguished by the sign of det
  // A alone.
  std::shared_ptr<const AspectMap> map() {
    if (session_.known_map() || question_.brief || degrees_of_freedom(robot().task_space()) > 2)
      return session_.known_map();
    ProblemList of_the_map;  // without one there is an answer, too
    return session_.map({}, {}, control_, of_the_map).map;
  }

  void choose_for_path() {
    answer_.prefer = question_.prefer.value_or(Preference::clear);
    add_told(problems_of(robot(), *question_.path, *answer_.prefer), problems_);
    if (!problems_.empty()) return;
    const auto known = map();
    PathChoiceOptions options;
    options.preference = *answer_.prefer;
    options.map = known.get();
    options.control = control_.begin("Looking into each working mode.");
    answer_.path = choose_working_mode(*session_.certifier(), *question_.path, options);
    if (!question_.changes || control_.is_over()) return;
    answer_.with_changes = choose_posture_changes(*session_.certifier(), *question_.path,
                                                  control_.begin("Looking for changes of posture."));
  }

  void choose_for_region() {
    RegionQuestion region;
    region.slice = answer_.slice = question_.hold;
    answer_.box = question_.region;
    const auto names =
        region.slice ? coordinate_names(*region.slice) : coordinate_names(robot().task_space());
    if (names.size() <= max_map_dimension)
      region.region = box_of("region", names, question_.region, problems_);
    if (problems_.empty()) add_told(problems_of(robot(), region), problems_);
    if (!problems_.empty()) return;
    RegionChoiceOptions options;
    options.control = control_.begin("Looking into the region.");
    answer_.region = choose_working_mode(session_.robot(), region, options);
  }

  Session& session_;
  const ChooseQuestion& question_;
  const Control& control_;
  ChooseAnswer answer_;
  ProblemList problems_;
};

}  // namespace

std::optional<std::vector<Pose>> ChooseAnswer::apart() const {
  if (!region.apart) return std::nullopt;
  return std::vector<Pose>{region.apart->first, region.apart->second};
}

Outcome<ChooseAnswer> answer(Session& session, const ChooseQuestion& question, const Control& control) {
  return Choosing(session, question, control).run();
}

}  // namespace ask
}  // namespace parallel_aspects
