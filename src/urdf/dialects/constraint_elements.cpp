// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/xml_values.h"
#include "urdf/dialects/closure_dialects.h"

namespace parallel_aspects::dialects {
namespace {

using tinyxml2::XMLElement;

// The frame of one side: z along its axis, or x along it where it is the second axis of a universal joint.
std::optional<LinkFrame> side(const LoopSource& source, const XMLElement& constraint, const std::string& name,
                              bool second_axis, const std::string& where, Problems& problems) {
  const auto link =
      described_link(source, attribute(constraint.FirstChildElement(name.c_str()), "link"), where, problems);
  const auto* origin = constraint.FirstChildElement((name + "_origin").c_str());
  const auto frame = frame_of(attribute(origin, "xyz"), attribute(origin, "rpy"));
  const auto* stated = constraint.FirstChildElement((name + "_axis").c_str());
  const auto axis = vector_or(attribute(stated, "xyz"), Eigen::Vector3d::UnitZ());
  if (!frame || !axis || axis->norm() < 1e-9)
    problems.push_back(where + " has a " + name + "_origin or " + name +
                       "_axis that is not three finite numbers, or zero; write three, separated by blanks.");
  if (!link || !frame || !axis || axis->norm() < 1e-9) return std::nullopt;
  LinkFrame result{*link, *frame};
  result.in_link.rotate(axes_with_z(*axis));
  if (second_axis) result.in_link.rotate(axes_with_z(Eigen::Vector3d::UnitX()).transpose());
  return result;
}

}  // namespace

DescribedLoops constraint_element(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  for (const auto* constraint = source.robot.FirstChildElement("constraint"); constraint != nullptr;
       constraint = constraint->NextSiblingElement("constraint")) {
    const std::string name = attribute(constraint, "name");
    const std::string where = source.files.urdf + " has a <constraint> '" + name + "' that";
    const auto type = described_type(attribute(constraint, "type"));
    if (!type)
      problems.push_back(
          where + " has the type '" + attribute(constraint, "type") +
          "', which cannot close a loop; use spherical_joint, revolute_joint, universal_joint or "
          "fixed_joint.");
    const auto parent = side(source, *constraint, "parent", false, where, problems);
    const auto child = side(source, *constraint, "child", type == ClosureType::universal, where, problems);
    if (parent && child && type) loops.closures.push_back({name, {*parent, *child}, *type});
  }
  return loops;
}

namespace {

using tinyxml2::XMLElement;

std::optional<LinkFrame> end_of(const LoopSource& source, const XMLElement& constraint, const char* body,
                                const char* point, Problems& problems) {
  const std::string where = source.files.urdf + " has a <drake:ball_constraint> that";
  const auto link =
      described_link(source, attribute(constraint.FirstChildElement(body), "name"), where, problems);
  const auto frame = frame_of(attribute(constraint.FirstChildElement(point), "value"), "");
  if (!frame)
    problems.push_back(where + " has a " + point + " that is not three finite numbers; write three.");
  if (!link || !frame) return std::nullopt;
  return LinkFrame{*link, *frame};
}

}  // namespace

DescribedLoops drake_ball_constraint(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  for (const auto* constraint = source.robot.FirstChildElement("drake:ball_constraint");
       constraint != nullptr; constraint = constraint->NextSiblingElement("drake:ball_constraint")) {
    const auto one =
        end_of(source, *constraint, "drake:ball_constraint_body_A", "drake:ball_constraint_p_AP", problems);
    const auto other =
        end_of(source, *constraint, "drake:ball_constraint_body_B", "drake:ball_constraint_p_BQ", problems);
    if (!one || !other) continue;
    const std::string name = source.tree.links[one->link] + " - " + source.tree.links[other->link];
    loops.closures.push_back({name, {*one, *other}, ClosureType::point});
  }
  return loops;
}

namespace {

using Eigen::Vector3d;
using tinyxml2::XMLElement;

constexpr double no_direction = 1e-9;

class LoopJointReader {
 public:
  LoopJointReader(const LoopSource& source, const XMLElement& joint, const Poses& poses, Problems& problems)
      : source_(source),
        joint_(joint),
        poses_(poses),
        problems_(problems),
        where_(source.files.urdf + " has a <loop_joint> '" + attribute(&joint, "name") + "' that") {}

  void read(std::vector<Closure>& closures) {
    const bool by_parent = joint_.FirstChildElement("parent") != nullptr;
    auto one = by_parent ? end_of("parent") : end_of(joint_.FirstChildElement("link1"));
    auto other = by_parent ? end_of("child") : end_of(second_link());
    const auto type = closure_type();
    const auto axis = vector_or(attribute(joint_.FirstChildElement("axis"), "xyz"), Vector3d::UnitZ());
    const bool good_axis = axis && axis->norm() > no_direction;
    if (!type || !good_axis)
      problems_.push_back(
          where_ +
          " has a type or an axis that cannot close a loop; use spherical, revolute, universal or "
          "fixed, and an axis of three numbers.");
    if (!one || !other || !type || !good_axis) return;
    if (*type == ClosureType::revolute) turn_to(*axis, by_parent, *one, *other);
    closures.push_back({attribute(&joint_, "name"), {*one, *other}, *type});
  }

 private:
  // The manual of Isaac Sim writes link1 twice.
  const XMLElement* second_link() const {
    const auto* second = joint_.FirstChildElement("link2");
    const auto* first = joint_.FirstChildElement("link1");
    return second != nullptr || first == nullptr ? second : first->NextSiblingElement("link1");
  }

  std::optional<LinkFrame> end_of(const XMLElement* end) { return frame_in(attribute(end, "link"), end); }

  // <parent link/> and <parent_origin xyz rpy/>, or the same of the child.
  std::optional<LinkFrame> end_of(const std::string& side) {
    return frame_in(attribute(joint_.FirstChildElement(side.c_str()), "link"),
                    joint_.FirstChildElement((side + "_origin").c_str()));
  }

  std::optional<LinkFrame> frame_in(const std::string& name, const XMLElement* origin) {
    const auto link = described_link(source_, name, where_, problems_);
    const auto frame = frame_of(attribute(origin, "xyz"), attribute(origin, "rpy"));
    if (!frame)
      problems_.push_back(
          where_ + " has an xyz or rpy that is not three finite numbers; write three, separated by blanks.");
    if (!link || !frame) return std::nullopt;
    return LinkFrame{*link, *frame};
  }

  // Stated; or revolute, if there is an axis; else not stated.
  std::optional<ClosureType> closure_type() const {
    const std::string type = attribute(&joint_, "type");
    if (!type.empty()) return described_type(type);
    return joint_.FirstChildElement("axis") != nullptr ? ClosureType::revolute : ClosureType::automatic;
  }

  // The axis is given in both frames, or in the parent link and as it lies at zero in the child.
  void turn_to(const Vector3d& axis, bool in_parent, LinkFrame& one, LinkFrame& other) const {
    if (!in_parent) {
      for (LinkFrame* end : {&one, &other}) end->in_link.rotate(axes_with_z(axis));
      return;
    }
    one.in_link.linear() = axes_with_z(axis);
    other.in_link.linear() =
        axes_with_z(poses_[other.link].linear().transpose() * (poses_[one.link].linear() * axis));
  }

  const LoopSource& source_;
  const XMLElement& joint_;
  const Poses& poses_;
  Problems& problems_;
  std::string where_;
};

}  // namespace

DescribedLoops loop_joint(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  const Poses poses = poses_at_zero(source.tree);
  for (const auto* joint = source.robot.FirstChildElement("loop_joint"); joint != nullptr;
       joint = joint->NextSiblingElement("loop_joint"))
    LoopJointReader(source, *joint, poses, problems).read(loops.closures);
  return loops;
}

namespace {

std::optional<LinkFrame> end_of(const LoopSource& source, const XMLElement* end, Problems& problems) {
  const auto link =
      described_link(source, attribute(end, "link"), source.files.urdf + " has a closure that", problems);
  const auto frame = frame_of(attribute(end, "xyz"), attribute(end, "rpy"));
  if (!link || !frame) return std::nullopt;
  return LinkFrame{*link, *frame};
}

// The <loop_closure> elements that were written for this dialect.
DescribedLoops closures_in(const LoopSource& source, const std::string& dialect, Problems& problems) {
  DescribedLoops loops;
  for (const auto* closure = source.robot.FirstChildElement("loop_closure"); closure != nullptr;
       closure = closure->NextSiblingElement("loop_closure")) {
    if (attribute(closure, "in") != dialect) continue;
    const auto* first = closure->FirstChildElement("end");
    const auto* second = first != nullptr ? first->NextSiblingElement("end") : nullptr;
    const auto one = end_of(source, first, problems), other = end_of(source, second, problems);
    const auto type = described_type(attribute(closure, "type"));
    if (!type || !one || !other)  // not as `urdf_text` writes them
      problems.push_back(source.files.urdf + " has a <loop_closure> '" + attribute(closure, "name") +
                         "' without a type or two ends; use <loop_joint> in its place.");
    if (!type || !one || !other) continue;
    loops.closures.push_back({attribute(closure, "name"), {*one, *other}, *type});
  }
  return loops;
}

}  // namespace

DescribedLoops equality(const LoopSource& source, Problems& problems) {
  return closures_in(source, "<equality>", problems);
}

DescribedLoops sdf_joint(const LoopSource& source, Problems& problems) {
  return closures_in(source, "the SDF", problems);
}

}  // namespace parallel_aspects::dialects
