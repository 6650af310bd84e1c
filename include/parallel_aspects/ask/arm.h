// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_ARM_H
#define PARALLEL_ASPECTS_ASK_ARM_H

#include "parallel_aspects/arms/serial_arm.h"
#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Questions about serial arms. Their aspects are the components of {det J > 0} and {det J < 0} in the space
// of the joint values, within limits.
namespace parallel_aspects::ask {

class ArmFacts;  // what is computed once, in the sources

/// A serial arm that questions are asked of. For one thread at a time.
class ArmSession {
 public:
  /// The arm is not null. Throws `InvalidDescription` where det J vanishes everywhere.
  explicit ArmSession(std::shared_ptr<const SerialArm> arm);
  ~ArmSession();
  ArmSession(const ArmSession&) = delete;
  ArmSession& operator=(const ArmSession&) = delete;

  const SerialArm& arm() const noexcept { return *arm_; }  ///< whom questions are about
  ArmFacts& facts() noexcept { return *facts_; }           ///< what is known of it

 private:
  std::shared_ptr<const SerialArm> arm_;
  std::unique_ptr<ArmFacts> facts_;
};

/// A proved yes or no, or neither.
enum class Proved { yes, no, unknown };
/// "yes", "no" or "unknown".
inline const char* name(Proved answer) {
  return answer == Proved::yes ? "yes" : answer == Proved::no ? "no" : "unknown";
}

/// Values of all joints by their names [rad or m].
NamedValues named_joints(const SerialArm& arm, const Eigen::VectorXd& q);

/// What is recognised of an arm. It has no fields.
struct ArmDescribeQuestion {};
/// The question has no fields.
template <class Visit>
void describe(Visit& /*visit*/, ArmDescribeQuestion& /*question*/) {}

/// A factor of det J.
struct DescribedFactor {
  std::vector<std::string> joints;  ///< that it depends on
  std::string text;                 ///< as a formula
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, const DescribedFactor& factor) {
  visit({"joints", "", "that it depends on"}, factor.joints);
  visit({"formula", "", "with its largest coefficient scaled to 1, six digits"}, factor.text);
}

/// A joint.
struct DescribedArmJoint {
  std::string name;           ///< in the URDF
  std::string kind;           ///< "revolute" or "prismatic"
  std::string unit;           ///< "rad" or "m"
  JointLimits limits;         ///< [rad or m]
  bool turns_freely = false;  ///< all the way round, so that limits bound no aspect
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, const DescribedArmJoint& joint) {
  visit({"name", "", "of the URDF"}, joint.name);
  visit({"kind", "", "`revolute` or `prismatic`"}, joint.kind);
  visit({"unit", "", "`rad` or `m`"}, joint.unit);
  visit({"limits", "rad or m", "`lower` and `upper`; null for none"}, joint.limits);
  visit({"wraps", "", "whether it turns all the way round, so that limits bound no aspect"},
        joint.turns_freely);
}

/// What is recognised.
struct ArmDescribed {
  std::string mechanism;                  ///< its name
  std::string task;                       ///< what the operational point is to do
  std::string base_link;                  ///< in whose frame poses are
  std::string tip_link;                   ///< whose origin the operational point is
  std::string method;                     ///< how inverse solutions are found
  std::vector<std::string> coordinates;   ///< of the task
  std::vector<DescribedArmJoint> joints;  ///< from the base on
  std::vector<DescribedFactor> factors;   ///< of det J: their product, times a constant, is det J
  std::vector<std::string> notes;         ///< what was taken as exact where the description misses it
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, const ArmDescribed& answer) {
  visit({"mechanism", "", "its name"}, answer.mechanism);
  visit({"kind", "", "`serial arm`"}, std::string("serial arm"));
  visit({"task", "", "what the operational point is to do"}, answer.task);
  visit({"coordinates", "", "of the task"}, answer.coordinates);
  visit({"base_frame", "", "link of the URDF, in whose frame poses are"}, answer.base_link);
  visit({"operational_point", "", "link of the URDF"}, answer.tip_link);
  visit({"joints", "", "from the base on"}, answer.joints);
  visit({"factors", "", "of det J, exactly: their product, times a constant, is det J"}, answer.factors);
  visit({"inverse_method", "", "how `ik` solves it"}, answer.method);
  visit({"notes", "", "what was taken as exact where the description misses it; messages"}, answer.notes);
}
/// Describes the arm.
Outcome<ArmDescribed> answer(ArmSession& session, const ArmDescribeQuestion& question,
                             const Control& control = {});

/// The aspects of an arm.
struct ArmMapQuestion {
  std::optional<double> resolution{};  ///< longest edge of an undecided box [rad, or share of a range]
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, ArmMapQuestion& question) {
  visit({"resolution", "R", "Longest edge of an undecided box of the base map [rad]"}, question.resolution);
}

/// One of them.
struct ArmAspect {
  int id = 0;                     ///< 1 and up
  int sign = 0;                   ///< of det J
  std::vector<int> factor_signs;  ///< in the order of the factors
  double measure = 0.0;           ///< best estimate of its volume [product of rad and m]
  double measure_lower = 0.0;     ///< proved: from the inside boxes
  double measure_upper = 0.0;     ///< proved: with the undecided boxes
  Eigen::VectorXd deepest;        ///< joint values in it: of joints that do not count, 0
  NamedValues witness;            ///< the same by names
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, const ArmAspect& aspect) {
  visit({"id", "", "1 and up"}, aspect.id);
  visit({"determinant_sign", "", "of det J, 1 or -1"}, aspect.sign);
  visit({"factor_signs", "", "of the factors of det J, in the order of `describe`"}, aspect.factor_signs);
  visit({"measure", "", "best estimate of its volume, over `mapped_joints`"}, aspect.measure);
  visit({"measure_lower", "", "proved: from the inside boxes"}, aspect.measure_lower);
  visit({"measure_upper", "", "proved: with the undecided boxes"}, aspect.measure_upper);
  visit({"joints", "rad or m", "values of all joints that are proved to be in it"}, aspect.witness);
}

/// All.
struct ArmMapAnswer {
  std::string mechanism;                     ///< its name
  std::string unit;                          ///< of measures
  std::vector<std::string> mapped_joints;    ///< those that det J depends on
  std::vector<ArmAspect> aspects;            ///< those that are found
  std::size_t proved_count = 0;              ///< lower bound of their number, proved
  std::optional<std::size_t> count_at_most;  ///< upper bound, proved; nothing where there is none
  double measure = 0.0;                      ///< of all joint values within limits
  std::size_t boxes = 0;                     ///< of the maps of all groups of factors
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, const ArmMapAnswer& answer) {
  visit({"mechanism", "", "its name"}, answer.mechanism);
  visit({"mapped_joints", "", "those that det J depends on"}, answer.mapped_joints);
  visit({"unit", "", "of measures"}, answer.unit);
  visit({"aspects", "", "as follows; with the number of components proved connected"}, answer.aspects);
  visit({"proved_count", "", "lower bound of the number of aspects, proved"}, answer.proved_count);
  visit({"count_at_most", "", "upper bound, proved; null where there is none"}, answer.count_at_most);
  visit({"measure", "", "of all joint values within limits"}, answer.measure);
  visit({"boxes", "", "of the maps of all groups of factors"}, answer.boxes);
}
/// Computes the map.
Outcome<ArmMapAnswer> answer(ArmSession& session, const ArmMapQuestion& question,
                             const Control& control = {});

/// Where joint values are.
struct ArmLocateQuestion {
  std::vector<double> joints{};  ///< of all joints [rad or m]
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, ArmLocateQuestion& question) {
  visit({"joints", "\"q1 q2\"", "Values of all joints, from the base on [rad or m]"}, question.joints);
}

/// Joint values, and what is proved of them.
struct ArmPlace {
  NamedValues joints;             ///< by names [rad or m]
  Eigen::VectorXd q;              ///< the same in their order
  Eigen::VectorXd pose;           ///< coordinates of the task [m or rad]
  NamedValues coordinates;        ///< of the operational point
  double determinant = 0.0;       ///< det J there
  int sign = 0;                   ///< proved; 0 where it is not
  std::vector<int> factor_signs;  ///< likewise; empty where one is not
  bool within_limits = true;      ///< whether the joint values are
  std::optional<int> aspect;      ///< id, where it is known
  std::optional<bool> is_proved;  ///< of inverse solutions: that there is exactly one
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, const ArmPlace& place) {
  visit({"joints", "rad or m", "by names"}, place.joints);
  visit({"pose", "m or rad", "coordinates of the operational point"}, place.coordinates);
  visit({"det_j", "", "det J there"}, place.determinant);
  visit({"determinant_sign", "", "of det J, proved; 0 where it is not"}, place.sign);
  visit({"factor_signs", "", "of its factors, proved; empty where one is not"}, place.factor_signs);
  visit({"within_limits", "", "whether the joint values are"}, place.within_limits);
  visit({"aspect", "", "id of the one that holds them; null where it is not known, or no map is asked"},
        place.aspect);
  visit({"proved", "", "of inverse solutions: whether it is proved that there is exactly one; else null"},
        place.is_proved);
}
/// Where they are, with the map where det J depends on three joints at most in each group of its factors.
Outcome<ArmPlace> answer(ArmSession& session, const ArmLocateQuestion& question, const Control& control = {});

/// Where the operational point is at joint values.
struct ArmDirectQuestion {
  std::vector<double> joints{};  ///< of all joints [rad or m]
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, ArmDirectQuestion& question) {
  visit({"joints", "\"q1 q2\"", "Values of all joints, from the base on [rad or m]"}, question.joints);
}
/// Without a map.
Outcome<ArmPlace> answer(ArmSession& session, const ArmDirectQuestion& question, const Control& control = {});

/// Which joint values a pose has.
struct ArmInverseQuestion {
  std::vector<double> pose{};  ///< coordinates of the task
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, ArmInverseQuestion& question) {
  visit({"pose", "\"x y z roll pitch yaw\"", "Coordinates of the task, as `describe` lists them [m and rad]"},
        question.pose);
}
/// All that are found.
struct ArmInverseAnswer {
  std::vector<ArmPlace> solutions;  ///< without a map
  bool complete = false;            ///< whether there are no others
  std::string reason;               ///< why that is so, or why it is not known
  std::string method;               ///< how they are found
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, const ArmInverseAnswer& answer) {
  visit({"method", "", "how they are found"}, answer.method);
  visit({"complete", "", "whether there are no others"}, answer.complete);
  visit({"reason", "", "why that is so, or why it is not known"}, answer.reason);
  visit({"solutions", "", "as of `locate`, without a map"}, answer.solutions);
}
/// Solves it.
Outcome<ArmInverseAnswer> answer(ArmSession& session, const ArmInverseQuestion& question,
                                 const Control& control = {});

/// Whether two sets of joint values are in one aspect.
struct ArmConnectQuestion {
  std::vector<double> from_joints{};  ///< where the path begins, of all joints [rad or m]
  std::vector<double> to_joints{};    ///< where it ends, likewise
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, ArmConnectQuestion& question) {
  visit(
      {"from_joints", "\"q1 q2\"", "Of a serial arm: where the path begins, values of all joints [rad or m]"},
      question.from_joints);
  visit({"to_joints", "\"q1 q2\"", "Likewise where it ends"}, question.to_joints);
}
/// Whether they are, and how.
struct ArmConnectAnswer {
  Proved same_aspect = Proved::unknown;  ///< whether one aspect holds both
  std::string reason;                    ///< why; a message
  std::vector<NamedValues> path;  ///< joint values whose segments are proved; empty where none is known
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, const ArmConnectAnswer& answer) {
  visit({"same_aspect", "", "`yes`, `no` or `unknown`, proved"}, answer.same_aspect);
  visit({"reason", "", "why, a message"}, answer.reason);
  visit({"path", "rad or m", "joint values; the segments between them are proved free of singularities"},
        answer.path);
}
/// Proves it.
Outcome<ArmConnectAnswer> answer(ArmSession& session, const ArmConnectQuestion& question,
                                 const Control& control = {});

/// Whether an arm is cuspidal: can change its inverse solution within one aspect.
struct ArmUniquenessQuestion {};
/// The question has no fields.
template <class Visit>
void describe(Visit& /*visit*/, ArmUniquenessQuestion& /*question*/) {}
/// A cusp of an arm of three joints.
struct DescribedCusp {
  double rho = 0.0;    ///< distance from the first axis [m]
  double z = 0.0;      ///< height along it, from the origin of the base link [m]
  NamedValues joints;  ///< there, without the first [rad]
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, const DescribedCusp& cusp) {
  visit({"rho", "m", "distance from the first axis"}, cusp.rho);
  visit({"z", "m", "height along it, from the origin of the base link"}, cusp.z);
  visit({"joints", "rad", "joint values there, without the first"}, cusp.joints);
}
/// Whether it is, and why.
struct ArmUniquenessAnswer {
  Proved cuspidal = Proved::unknown;   ///< whether it can change its inverse solution within an aspect
  std::string reason;                  ///< why; a message
  std::vector<NamedValues> solutions;  ///< two of one pose in one aspect, where it is cuspidal
  std::optional<std::vector<DescribedCusp>> cusps;  ///< of three turning joints and a position
  bool cusps_complete = false;                      ///< whether it is proved that there are no others
};
/// Its fields.
template <class Visit>
void describe(Visit& visit, const ArmUniquenessAnswer& answer) {
  visit({"cuspidal", "", "`yes`, `no` or `unknown`, proved"}, answer.cuspidal);
  visit({"reason", "", "why, a message"}, answer.reason);
  visit({"solutions", "rad or m", "two of one pose that one aspect holds; empty unless cuspidal"},
        answer.solutions);
  visit({"cusps", "", "of three turning joints whose task is a position; null for others"}, answer.cusps);
  visit({"cusps_complete", "", "whether it is proved that there are no other cusps"}, answer.cusps_complete);
}
/// Answers with a proof where one is found.
Outcome<ArmUniquenessAnswer> answer(ArmSession& session, const ArmUniquenessQuestion& question,
                                    const Control& control = {});

}  // namespace parallel_aspects::ask

#endif  // PARALLEL_ASPECTS_ASK_ARM_H
