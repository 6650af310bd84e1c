// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/arm.h"

#include "ask/question_parts.h"
#include "parallel_aspects/model/problems.h"

#include "arms/arm_cusps.h"
#include "arms/arm_determinant.h"
#include "arms/arm_inverse.h"
#include "arms/joint_map.h"
#include "arms/joint_segment.h"
#include <algorithm>
#include <cmath>
#include <random>

namespace parallel_aspects::ask {

// The determinant, and the maps once they are asked for.
class ArmFacts {
 public:
  explicit ArmFacts(const SerialArm& arm) : determinant(arm_determinant(arm)), segments(arm, determinant) {}

  const ArmDeterminant determinant;
  const JointSegments segments;
  std::vector<std::shared_ptr<const JointMap>> maps;  // of the groups, all or none
};

namespace {

constexpr std::size_t most_mapped = 3;  // joints of a group
constexpr int poses_of_search = 400;    // for two inverse solutions in one aspect

// Of the base map: boxes of three joints cost most.
double usual_resolution(std::size_t joints) { return joints == 1 ? 0x1p-14 : joints == 2 ? 0x1p-9 : 0x1p-6; }

std::vector<std::string> arm_joint_names(const SerialArm& arm, const std::vector<std::size_t>& joints) {
  std::vector<std::string> names;
  for (const std::size_t joint : joints) names.push_back(arm.joints()[joint].name);
  return names;
}

std::string quoted_names(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& each : names) text += (text.empty() ? "'" : ", '") + each + "'";
  return text;
}

const FactorGroup* group_too_large(const ArmFacts& facts) {
  for (const FactorGroup& group : facts.determinant.groups)
    if (group.joints.size() > most_mapped) return &group;
  return nullptr;
}

// False, with a problem or cancelled, where there are none.
bool make_maps(ArmSession& session, const std::optional<double>& resolution, const Control& control,
               ProblemList& problems) {
  ArmFacts& facts = session.facts();
  if (const FactorGroup* large = group_too_large(facts)) {
    problems.push_back({ProblemKind::robot, "",
                        "det J of '" + given(session.arm().name()) + "' depends on " +
                            std::to_string(large->joints.size()) + " joints together, " +
                            given(quoted_names(arm_joint_names(session.arm(), large->joints))) +
                            ", and maps have three coordinates at most",
                        "ask `connect` with {from_joints} and {to_joints}, which proves segments"});
    return false;
  }
  if (!resolution && !facts.maps.empty()) return true;
  if (resolution && !(*resolution > 0.0)) {
    problems.push_back(
        {ProblemKind::value, "resolution", "{resolution} is not positive", "give one such as 0.05"});
    return false;
  }
  facts.maps.clear();
  try {
    for (const FactorGroup& group : facts.determinant.groups) {
      const double share = resolution ? std::clamp(*resolution / (2.0 * half_turn), 0x1p-16, 0.25)
                                      : usual_resolution(group.joints.size());
      facts.maps.push_back(std::make_shared<const JointMap>(session.arm(), group, share,
                                                            control.begin("mapping the joint space")));
    }
  } catch (const InvalidDescription& invalid) {
    facts.maps.clear();
    add_told(invalid.problems(), problems);
  }
  return problems.empty() && !control.is_over();
}

// Calls with one component of each map, in the order of ids.
template <class Visitor>
void for_each_aspect(const ArmFacts& facts, const Visitor& visit) {
  std::vector<std::size_t> choice(facts.maps.size(), 0);
  for (const auto& map : facts.maps)
    if (map->components().empty()) return;
  for (;;) {
    visit(choice);
    std::size_t i = 0;
    while (i < choice.size() && ++choice[i] == facts.maps[i]->components().size()) choice[i++] = 0;
    if (i == choice.size()) return;
  }
}

std::vector<int> factor_signs_of(const FactorGroup& group, std::size_t signs) {
  std::vector<int> result;
  for (std::size_t k = 0; k < group.factors.size(); ++k) result.push_back((signs >> k & 1U) != 0 ? 1 : -1);
  return result;
}

double lower_sum(const JointMap& map) {
  double sum = 0.0;
  for (const JointComponent& each : map.components()) sum += each.measure;
  return sum;
}

ArmAspect arm_aspect(const SerialArm& arm, const ArmFacts& facts, const std::vector<std::size_t>& choice,
                     int id) {
  ArmAspect aspect;
  aspect.id = id;
  aspect.measure = aspect.measure_lower = aspect.measure_upper = 1.0;
  aspect.deepest = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(arm.size()));
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const JointLimits& limits = arm.joints()[i].limits;
    if (!limits.contain(0.0))
      aspect.deepest[static_cast<Eigen::Index>(i)] = 0.5 * (limits.lower + limits.upper);
  }
  for (std::size_t g = 0; g < choice.size(); ++g) {
    const JointMap& map = *facts.maps[g];
    const JointComponent& component = map.components()[choice[g]];
    const std::vector<int> signs = factor_signs_of(map.group(), component.signs);
    aspect.factor_signs.insert(aspect.factor_signs.end(), signs.begin(), signs.end());
    aspect.measure *= component.measure * (map.measure() / lower_sum(map));
    aspect.measure_lower *= component.measure;
    aspect.measure_upper *= component.measure + map.undecided();
    for (std::size_t i = 0; i < map.group().joints.size(); ++i)
      aspect.deepest[static_cast<Eigen::Index>(map.group().joints[i])] =
          component.witness[static_cast<Eigen::Index>(i)];
  }
  aspect.sign = facts.segments.determinant_sign(aspect.factor_signs);
  aspect.witness = named_joints(arm, aspect.deepest);
  return aspect;
}

// The id of the aspect that holds joint values; nothing where it is not known.
std::optional<int> aspect_at(const ArmFacts& facts, const Eigen::VectorXd& q) {
  int id = 1, step = 1;
  for (const auto& map : facts.maps) {
    const auto component = map->component_at(q);
    if (!component) return std::nullopt;
    id += step * static_cast<int>(*component);
    step *= static_cast<int>(map->components().size());
  }
  return id;
}

std::optional<Eigen::VectorXd> arm_joint_values(const SerialArm& arm, const std::vector<double>& values,
                                                const std::string& field, ProblemList& problems) {
  const std::string wanted =
      std::to_string(arm.size()) + " numbers, of " + given(quoted_names(arm_joint_names(arm, [&] {
        std::vector<std::size_t> all(arm.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
        return all;
      }())));
  if (values.empty())
    problems.push_back({ProblemKind::missing, field, "{" + field + "} is required", "give " + wanted});
  else if (values.size() != arm.size())
    problems.push_back({ProblemKind::value, field,
                        "{" + field + "} has " + std::to_string(values.size()) + " numbers",
                        "give " + wanted});
  else
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  return std::nullopt;
}

ArmPlace arm_place(const ArmSession& session, const ArmFacts& facts, const Eigen::VectorXd& q) {
  const SerialArm& arm = session.arm();
  ArmPlace place;
  place.q = q;
  place.joints = named_joints(arm, q);
  place.pose = arm.task_coordinates(arm.tip(q));
  const std::vector<std::string> names = coordinate_names(arm.task());
  for (std::size_t i = 0; i < names.size(); ++i)
    place.coordinates.emplace_back(names[i], place.pose[static_cast<Eigen::Index>(i)]);
  place.determinant = arm.jacobian(q).determinant();
  place.within_limits = arm.within_limits(q);
  if (const auto signs = facts.segments.signs(q)) {
    place.factor_signs = *signs;
    place.sign = facts.segments.determinant_sign(*signs);
  }
  return place;
}

bool stays_within_limits(const SerialArm& arm, const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  return arm.within_limits(from) && arm.within_limits(to);
}

// All ways round of joints that turn freely and that det J depends on, the shortest first.
std::vector<Eigen::VectorXd> ways_round(const SerialArm& arm, const ArmFacts& facts,
                                        const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  std::vector<Eigen::VectorXd> ways{short_way_round(arm, from, to)};
  for (std::size_t i = 0; i < arm.size(); ++i) {
    if (!arm.turns_freely(i) || !facts.determinant.whole.depends_on(i)) continue;
    const auto at = static_cast<Eigen::Index>(i);
    const std::size_t count = ways.size();
    for (std::size_t k = 0; k < count; ++k) {
      Eigen::VectorXd other = ways[k];
      other[at] += other[at] > from[at] ? -2.0 * half_turn : 2.0 * half_turn;
      ways.push_back(other);
    }
  }
  std::stable_sort(ways.begin(), ways.end(), [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return (a - from).norm() < (b - from).norm();
  });
  return ways;
}

ArmConnectAnswer connected_joints(ArmSession& session, const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                  const Control& control) {
  const SerialArm& arm = session.arm();
  const ArmFacts& facts = session.facts();
  const auto before = facts.segments.signs(from), behind = facts.segments.signs(to);
  if (!before || !behind)
    return {
        Proved::unknown, "joint values are singular, or so close to it that no sign of det J is proved", {}};
  if (*before != *behind) {
    std::size_t factor = 0;
    while ((*before)[factor] == (*behind)[factor]) ++factor;
    std::size_t at = 0;
    for (const FactorGroup& group : facts.determinant.groups)
      for (const TrigPolynomial& each : group.factors)
        if (at++ == factor)
          return {Proved::no, "a factor of det J has opposite signs there: " + text_of(each, arm), {}};
  }
  bool is_first = true;
  for (const Eigen::VectorXd& way : ways_round(arm, facts, from, to)) {
    if (control.is_over()) break;
    const JointSegmentVerdict verdict = facts.segments.verdict(from, way);
    if (verdict.has_singularity && !*verdict.has_singularity)
      return {
          Proved::yes,
          is_first
              ? "the straight segment of joint values is proved free of singularities"
              : "the straight segment the other way round for some joints is proved free of singularities",
          {named_joints(arm, from), named_joints(arm, way)}};
    is_first = false;
  }
  ProblemList none;
  if (!group_too_large(facts) && make_maps(session, std::nullopt, control, none)) {
    bool all_same = true, all_exact = true;
    for (const auto& map : facts.maps) {
      const auto one = map->component_at(from), other = map->component_at(to);
      if (!one || !other) return {Proved::unknown, "the map does not decide where they are", {}};
      const bool is_exact = map->proved_count() == map->components().size();
      all_same = all_same && *one == *other;
      if (*one != *other && is_exact)
        return {Proved::no, "two components of the map that are proved apart", {}};
      all_exact = all_exact && is_exact;
    }
    if (all_same) return {Proved::yes, "one component of the map holds both", {}};
  }
  return {
      Proved::unknown, "no straight segment between them is proved, whichever way round the joints turn", {}};
}

unsigned degree_of_joint(const TrigPolynomial& factor, std::size_t joint) {
  unsigned degree = 0;
  for (const auto& term : factor.terms())
    degree = std::max<unsigned>(degree, term.first[2 * joint] + term.first[2 * joint + 1]);
  return degree;
}

// Whether det J has one factor in this joint alone, of which each sign leaves one of two solutions.
bool has_simple_factor(const ArmDeterminant& determinant, std::size_t joint) {
  for (const FactorGroup& group : determinant.groups)
    for (const TrigPolynomial& factor : group.factors)
      if (factor.joints() == std::vector<std::size_t>{joint}) return degree_of_joint(factor, joint) == 1;
  return false;
}

// By the closed form.
bool has_unique_solutions(const SerialArm& arm, const ArmDeterminant& determinant) {
  if (!has_one_solution_a_sign(arm)) return false;
  switch (inverse_method(arm)) {
    case InverseMethod::planar:
      return true;
    case InverseMethod::position:
      return has_simple_factor(determinant, 2);
    case InverseMethod::wrist:
    case InverseMethod::three_parallel:
      return has_simple_factor(determinant, 2) && has_simple_factor(determinant, 4);
    case InverseMethod::elimination:
    case InverseMethod::search:
      break;
  }
  return false;
}

void add_cusps(const ArmSession& session, const ArmFacts& facts, ArmUniquenessAnswer& answer) {
  const SerialArm& arm = session.arm();
  if (inverse_method(arm) != InverseMethod::position) return;
  const ArmCusps found = arm_cusps(arm, facts.determinant);
  answer.cusps_complete = found.is_complete;
  answer.cusps.emplace();
  for (const ArmCusp& each : found.all)
    answer.cusps->push_back(
        {each.rho, each.z, {{arm.joints()[1].name, each.theta2}, {arm.joints()[2].name, each.theta3}}});
}

// Two inverse solutions of one pose in one aspect.
bool find_change(ArmSession& session, const Control& control, ArmUniquenessAnswer& answer) {
  const SerialArm& arm = session.arm();
  if (inverse_method(arm) == InverseMethod::search) return false;
  const ArmFacts& facts = session.facts();
  std::mt19937 random(1);
  for (int k = 0; k < poses_of_search && !control.is_over(); ++k) {
    Eigen::VectorXd q(static_cast<Eigen::Index>(arm.size()));
    for (std::size_t i = 0; i < arm.size(); ++i) {
      const JointLimits& limits = arm.joints()[i].limits;
      const bool is_free =
          arm.turns_freely(i) || !(std::isfinite(limits.lower) && std::isfinite(limits.upper));
      q[static_cast<Eigen::Index>(i)] = std::uniform_real_distribution<double>(
          is_free ? -half_turn : limits.lower, is_free ? half_turn : limits.upper)(random);
    }
    const ArmSolutions solutions = inverse_solutions(arm, arm.tip(q));
    for (std::size_t a = 0; a < solutions.all.size(); ++a)
      for (std::size_t b = a + 1; b < solutions.all.size(); ++b) {
        const ArmSolution &one = solutions.all[a], &other = solutions.all[b];
        if (!one.is_proved || !other.is_proved || !stays_within_limits(arm, one.q, other.q)) continue;
        const auto signs = facts.segments.signs(one.q);
        if (!signs || signs != facts.segments.signs(other.q)) continue;
        for (const Eigen::VectorXd& way : ways_round(arm, facts, one.q, other.q)) {
          const JointSegmentVerdict verdict = facts.segments.verdict(one.q, way);
          if (!verdict.has_singularity || *verdict.has_singularity) continue;
          answer.cuspidal = Proved::yes;
          answer.reason =
              "the straight segment between two inverse solutions of one pose is proved free of "
              "singularities";
          answer.solutions = {named_joints(arm, one.q), named_joints(arm, way)};
          return true;
        }
      }
  }
  return false;
}

}  // namespace

ArmSession::ArmSession(std::shared_ptr<const SerialArm> arm)
    : arm_(std::move(arm)), facts_(std::make_unique<ArmFacts>(*arm_)) {}
ArmSession::~ArmSession() = default;

NamedValues named_joints(const SerialArm& arm, const Eigen::VectorXd& q) {
  NamedValues values;
  for (std::size_t i = 0; i < arm.size(); ++i)
    values.emplace_back(arm.joints()[i].name, q[static_cast<Eigen::Index>(i)]);
  return values;
}

Outcome<ArmDescribed> answer(ArmSession& session, const ArmDescribeQuestion& /*question*/,
                             const Control& control) {
  const SerialArm& arm = session.arm();
  ArmDescribed result{arm.name(),
                      name(arm.task()),
                      arm.base_link(),
                      arm.tip_link(),
                      name(inverse_method(arm)),
                      coordinate_names(arm.task()),
                      {},
                      {},
                      arm.notes()};
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const ArmJoint& joint = arm.joints()[i];
    result.joints.push_back({joint.name, joint.turns ? "revolute" : "prismatic", joint.turns ? "rad" : "m",
                             joint.limits, arm.turns_freely(i)});
  }
  for (const FactorGroup& group : session.facts().determinant.groups)
    for (const TrigPolynomial& factor : group.factors)
      result.factors.push_back({arm_joint_names(arm, factor.joints()), text_of(factor, arm)});
  return outcome_of({}, control, result);
}

Outcome<ArmMapAnswer> answer(ArmSession& session, const ArmMapQuestion& question, const Control& control) {
  ProblemList problems;
  if (!make_maps(session, question.resolution, control, problems))
    return outcome_of(problems, control, ArmMapAnswer{});
  const SerialArm& arm = session.arm();
  const ArmFacts& facts = session.facts();
  ArmMapAnswer result;
  result.mechanism = arm.name();
  result.proved_count = 1;
  result.count_at_most = 1;
  result.measure = 1.0;
  int angles = 0, lengths = 0;
  for (const auto& map : facts.maps) {
    for (const std::size_t joint : map->group().joints) {
      result.mapped_joints.push_back(arm.joints()[joint].name);
      ++(arm.joints()[joint].turns ? angles : lengths);
    }
    result.proved_count *= map->proved_count();
    if (!map->count_at_most())
      result.count_at_most.reset();
    else if (result.count_at_most)
      *result.count_at_most *= *map->count_at_most();
    result.measure *= map->measure();
    result.boxes += map->box_count();
  }
  const auto power = [](const char* unit, int count) {
    return count == 0 ? std::string() : std::string(unit) + (count > 1 ? "^" + std::to_string(count) : "");
  };
  result.unit = power("rad", angles) + (angles > 0 && lengths > 0 ? " " : "") + power("m", lengths);
  for_each_aspect(facts, [&](const std::vector<std::size_t>& choice) {
    result.aspects.push_back(arm_aspect(arm, facts, choice, static_cast<int>(result.aspects.size()) + 1));
  });
  return outcome_of({}, control, result);
}

Outcome<ArmPlace> answer(ArmSession& session, const ArmLocateQuestion& question, const Control& control) {
  ProblemList problems;
  const auto q = arm_joint_values(session.arm(), question.joints, "joints", problems);
  if (!q) return outcome_of(problems, control, ArmPlace{});
  ArmPlace place = arm_place(session, session.facts(), *q);
  if (!group_too_large(session.facts()) && place.within_limits && place.sign != 0) {
    if (!make_maps(session, std::nullopt, control, problems)) return outcome_of(problems, control, place);
    place.aspect = aspect_at(session.facts(), *q);
  }
  return outcome_of({}, control, place);
}

Outcome<ArmPlace> answer(ArmSession& session, const ArmDirectQuestion& question, const Control& control) {
  ProblemList problems;
  const auto q = arm_joint_values(session.arm(), question.joints, "joints", problems);
  return outcome_of(problems, control, q ? arm_place(session, session.facts(), *q) : ArmPlace{});
}

Outcome<ArmInverseAnswer> answer(ArmSession& session, const ArmInverseQuestion& question,
                                 const Control& control) {
  const SerialArm& arm = session.arm();
  const std::vector<std::string> names = coordinate_names(arm.task());
  if (question.pose.size() != names.size()) {
    std::string wanted;
    for (const std::string& each : names) wanted += (wanted.empty() ? "" : ", ") + each;
    const Problem problem{question.pose.empty() ? ProblemKind::missing : ProblemKind::value, "pose",
                          question.pose.empty()
                              ? "{pose} is required"
                              : "{pose} has " + std::to_string(question.pose.size()) + " numbers",
                          "give " + std::to_string(names.size()) + ": " + wanted};
    return outcome_of({problem}, control, ArmInverseAnswer{});
  }
  const ArmSolutions found = inverse_solutions(
      arm, tip_with(arm, Eigen::Map<const Eigen::VectorXd>(question.pose.data(),
                                                           static_cast<Eigen::Index>(names.size()))));
  ArmInverseAnswer result{{}, found.is_complete, found.reason, name(inverse_method(arm))};
  for (const ArmSolution& each : found.all) {
    result.solutions.push_back(arm_place(session, session.facts(), each.q));
    result.solutions.back().is_proved = each.is_proved;
  }
  return outcome_of({}, control, result);
}

Outcome<ArmConnectAnswer> answer(ArmSession& session, const ArmConnectQuestion& question,
                                 const Control& control) {
  ProblemList problems;
  const SerialArm& arm = session.arm();
  const auto from = arm_joint_values(arm, question.from_joints, "from_joints", problems);
  const auto to = arm_joint_values(arm, question.to_joints, "to_joints", problems);
  if (!from || !to) return outcome_of(problems, control, ArmConnectAnswer{});
  if (!stays_within_limits(arm, *from, *to))
    return outcome_of(
        {}, control,
        ArmConnectAnswer{
            Proved::no, "joint values are outside their limits, where there are no aspects", {}});
  return outcome_of({}, control, connected_joints(session, *from, *to, control));
}

Outcome<ArmUniquenessAnswer> answer(ArmSession& session, const ArmUniquenessQuestion& /*question*/,
                                    const Control& control) {
  ArmUniquenessAnswer result;
  const ArmFacts& facts = session.facts();
  add_cusps(session, facts, result);
  if (has_unique_solutions(session.arm(), facts.determinant)) {
    result.cuspidal = Proved::no;
    result.reason =
        "each joint solves an equation A cos + B sin = C, whose two solutions a factor of det J tells "
        "apart, so that each aspect holds one solution of a pose at most";
  } else if (!find_change(session, control, result)) {
    const bool no_cusp = result.cusps && result.cusps->empty() && result.cusps_complete;
    if (no_cusp) result.cuspidal = Proved::no;
    result.reason =
        no_cusp ? "its singular curves are proved to have no cusp"
                : "no two inverse solutions of a pose were found in one aspect, and it is not proved that "
                  "there are none";
  }
  return outcome_of({}, control, result);
}

}  // namespace parallel_aspects::ask
