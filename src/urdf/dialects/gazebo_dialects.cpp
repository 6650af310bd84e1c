// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/xml_values.h"
#include "urdf/dialects/closure_dialects.h"

namespace parallel_aspects::dialects {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using tinyxml2::XMLElement;

// Position and fixed-axis angles in one text, as SDF writes a pose.
std::optional<Isometry3d> pose_of(const XMLElement& joint) {
  const auto values = numbers(child_text(joint, "pose"));
  if (values && values->empty()) return Isometry3d::Identity();
  if (!values || values->size() != 6) return std::nullopt;
  const auto& v = *values;
  return Eigen::Translation3d(v[0], v[1], v[2]) * Eigen::AngleAxisd(v[5], Vector3d::UnitZ()) *
         Eigen::AngleAxisd(v[4], Vector3d::UnitY()) * Eigen::AngleAxisd(v[3], Vector3d::UnitX());
}

// The two words that SDF has had for a joint of two axes.
std::optional<ClosureType> type_of(const XMLElement& joint) {
  const std::string type = attribute(&joint, "type");
  return type == "revolute2" ? ClosureType::universal : described_type(type);
}

// One joint of SDF. Everything that it names is where it is at zero.
class JointReader {
 public:
  JointReader(const LoopSource& source, const XMLElement& joint, const Poses& poses, Problems& problems)
      : source_(source),
        joint_(joint),
        poses_(poses),
        problems_(problems),
        where_(source.files.urdf + " has a <gazebo> joint '" + attribute(&joint, "name") + "' that"),
        earlier_problems_(problems.size()) {}

  void read(std::vector<Closure>& closures) {
    const auto parent = parent_link();
    const auto child = described_link(source_, child_text(joint_, "child"), where_, problems_);
    const auto type = type_of(joint_);
    if (!type)
      problem("has the type '" + attribute(&joint_, "type") +
              "', which cannot close a loop; use revolute, ball, universal or fixed.");
    if (!parent || !child) return;
    const Isometry3d frame = joint_frame(*child);
    const Vector3d axis = axis_in(frame, "axis"), second = axis_in(frame, "axis2");
    if (problems_.size() > earlier_problems_) return;
    closures.push_back(closure(*parent, *child, *type, frame, axis, second));
  }

 private:
  void problem(const std::string& text) { problems_.push_back(where_ + " " + text); }

  // The world stands for the root link where there is no link of that name.
  std::optional<std::size_t> parent_link() {
    const std::string name = child_text(joint_, "parent");
    if (name == "world" && !source_.tree.link_named(name)) return 0;
    return described_link(source_, name, where_, problems_);
  }

  // In the frame of the root link.
  Isometry3d frame_named(const std::string& name, const Isometry3d& otherwise) {
    if (name.empty()) return otherwise;
    if (name == "__model__" || name == "world") {
      is_beside_child_ = true;
      return Isometry3d::Identity();
    }
    const auto link = described_link(source_, name, where_, problems_);
    is_beside_child_ = is_beside_child_ || name != child_text(joint_, "child");
    return link ? poses_[*link] : otherwise;
  }

  Isometry3d joint_frame(std::size_t child) {
    const auto* element = joint_.FirstChildElement("pose");
    std::string reference = attribute(element, "relative_to");
    if (reference.empty()) reference = attribute(element, "frame");
    const auto pose = pose_of(joint_);
    if (!pose)
      problem("has a pose that is not a list of finite numbers; give six, or leave it out for zeros.");
    return frame_named(reference, poses_[child]) * pose.value_or(Isometry3d::Identity());
  }

  // In the joint frame, unless it says otherwise.
  Vector3d axis_in(const Isometry3d& frame, const char* name) {
    const auto* axis = joint_.FirstChildElement(name);
    if (axis == nullptr) return Vector3d::UnitZ();
    const auto direction = vector_or(child_text(*axis, "xyz"), Vector3d::UnitZ());
    if (!direction || direction->norm() < 1e-9) {
      problem("has an <" + std::string(name) +
              "> that is not three finite numbers, or zero; give the direction of the joint.");
      return Vector3d::UnitZ();
    }
    const std::string of_model = child_text(*axis, "use_parent_model_frame");
    std::string reference = attribute(axis->FirstChildElement("xyz"), "expressed_in");
    if (of_model == "1" || of_model == "true") reference = "__model__";
    return frame.linear().transpose() * (frame_named(reference, frame).linear() * *direction);
  }

  Closure closure(std::size_t parent, std::size_t child, ClosureType type, const Isometry3d& frame,
                  const Vector3d& axis, const Vector3d& second) const {
    const Isometry3d in_child = poses_[child].inverse() * frame;
    LinkFrame turned{child, in_child};
    turned.in_link.rotate(axes_with_z(axis));
    Closure result = closed_at_zero(poses_, attribute(&joint_, "name"), parent, turned, type);
    if (joint_.FirstChildElement("pose") == nullptr) result.weld = Weld::at_origins;
    // A universal closure keeps z of the first frame orthogonal to x of the second.
    if (type == ClosureType::universal) {
      turned.in_link.linear() =
          in_child.linear() * axes_with_z(second) * axes_with_z(Vector3d::UnitX()).transpose();
      result.at_zero = turned.in_link.inverse() * result.frames[1].in_link;
      result.frames[1] = turned;
    }
    if (is_beside_child_) result.at_zero.reset();
    return result;
  }

  const LoopSource& source_;
  const XMLElement& joint_;
  const Poses& poses_;
  Problems& problems_;
  std::string where_;
  std::size_t earlier_problems_;
  bool is_beside_child_ = false;  // whether the place or the axis is in the frame of anything else
};

}  // namespace

DescribedLoops gazebo_joint(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  const Poses poses = poses_at_zero(source.tree);
  for (const auto* gazebo = source.robot.FirstChildElement("gazebo"); gazebo != nullptr;
       gazebo = gazebo->NextSiblingElement("gazebo"))
    for (const auto* joint = gazebo->FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint"))
      JointReader(source, *joint, poses, problems).read(loops.closures);
  return loops;
}

namespace {

using tinyxml2::XMLElement;

bool is_detachable_joint(const XMLElement& plugin) {
  return attribute(&plugin, "name").find("DetachableJoint") != std::string::npos ||
         attribute(&plugin, "filename").find("detachable-joint-system") != std::string::npos;
}

// Grippers are made to hold other models by the same plugin.
bool holds_another_model(const LoopSource& source, const XMLElement& plugin) {
  const std::string model = child_text(plugin, "child_model");
  return !model.empty() && model != source.tree.name &&
         (child_text(plugin, "child_link") == child_text(plugin, "parent_link") ||
          !source.tree.link_named(child_text(plugin, "child_link")));
}

void read_plugin(const LoopSource& source, const Poses& poses, const XMLElement& plugin,
                 std::vector<Closure>& closures, Problems& problems) {
  const std::string where = source.files.urdf + " has a DetachableJoint plugin that";
  const std::string parent_name = child_text(plugin, "parent_link"),
                    child_name = child_text(plugin, "child_link");
  const auto parent = described_link(source, parent_name, where, problems);
  const auto child = described_link(source, child_name, where, problems);
  if (!parent || !child) return;
  closures.push_back(closed_at_zero(poses, parent_name + " - " + child_name, *parent, LinkFrame{*child},
                                    ClosureType::fixed));
  closures.back().weld = Weld::at_origins;
}

}  // namespace

DescribedLoops detachable_joint(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  const Poses poses = poses_at_zero(source.tree);
  for (const auto* gazebo = source.robot.FirstChildElement("gazebo"); gazebo != nullptr;
       gazebo = gazebo->NextSiblingElement("gazebo"))
    for (const auto* plugin = gazebo->FirstChildElement("plugin"); plugin != nullptr;
         plugin = plugin->NextSiblingElement("plugin"))
      if (is_detachable_joint(*plugin) && !holds_another_model(source, *plugin))
        read_plugin(source, poses, *plugin, loops.closures, problems);
  return loops;
}

}  // namespace parallel_aspects::dialects
