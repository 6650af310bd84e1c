// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_EDIT_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_EDIT_H

#include "urdf/closing/assembly.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/corrections/legs_of_tree.h"
#include "urdf/description/closure.h"
#include "urdf/description/messages.h"
#include "urdf/description/tree.h"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace parallel_aspects {

/// What a description would be recognised as: "T2" and so on; nothing where it is refused.
using Attempt =
    std::function<std::optional<std::string>(const std::shared_ptr<const Tree>&, const ResolvedConfig&)>;

/// A description whose edits are searched for, and what these ask of it.
struct Subject {
  Subject(std::shared_ptr<const Tree> tree, const ResolvedConfig& resolved, const SourceNames& files);

  std::shared_ptr<const Tree> shared_tree;
  const Tree& tree;
  const ResolvedConfig& resolved;
  const SourceNames& files;
  ClosureSystem system;  ///< closures of open type are points
  LoopJoints loops;

  double size() const noexcept { return system.size(); }
  std::size_t platform() const { return body_of(tree, resolved.actuated_joints.platform_link); }
  const std::string& file() const { return file_of_closures(resolved, files); }  ///< of the closures
  bool is_actuated(std::size_t joint) const;                                     ///< of the tree
  std::string joint(std::size_t joint) const;                                    ///< "joint 'a'"
  std::string closure(std::size_t closure) const;                                ///< "closure 'a - b'"
  std::string link(std::size_t link) const;                                      ///< "'a'"
  bool is_closed(std::size_t link) const;  ///< whether a closure holds it
};

/// What is written for an element in the place of what stands there. Joints are indices of the tree's, links
/// and closures likewise.
struct OriginChange {
  std::size_t joint = 0;
  std::optional<Eigen::Vector3d> place, angles;  ///< xyz [m] and rpy [rad]; what is not there stays
};
struct MotionChange {
  std::size_t joint = 0;
  JointMotion motion = JointMotion::fixed;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
};
struct LimitsChange {
  std::size_t joint = 0;
  double lower = 0.0, upper = 0.0;
};
struct ParentChange {
  std::size_t joint = 0, parent = 0;
};
/// A joint and the link of its name, before joint `next` or after it.
struct JointAddition {
  std::size_t next = 0;
  bool is_before = true;
  std::string name;
  JointMotion motion = JointMotion::prismatic;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
};
struct FrameChange {
  std::size_t closure = 0, end = 0;
  LinkFrame frame;
};
struct TypeChange {
  std::size_t closure = 0;
  ClosureType type = ClosureType::point;
};
struct ClosureAddition {
  Closure closure;
};
struct ActuationChange {
  std::vector<std::size_t> variables;
};
struct BaseChange {
  std::size_t link = 0;
};
struct PointChange {
  std::size_t link = 0;
};
using Change =
    std::variant<OriginChange, MotionChange, LimitsChange, ParentChange, JointAddition, FrameChange,
                 TypeChange, ClosureAddition, ActuationChange, BaseChange, PointChange>;

/// A change of one element of a description, or the same one of like elements, that may be what it needs. A
/// guess: whether the element is at fault shows where the edited description is recognised.
struct Edit {
  std::string element;  ///< "joint 'a'", "closure 'a - b'"; edits of one element exclude each other
  Note fault;           ///< "robot.urdf lets joint 'a' turn about (1, 0, 0)"
  std::string remedy;   ///< "write <axis xyz=\"0 0 1\"/> for joint 'a'"
  std::vector<Change> changes;
  bool like_others = false;  ///< whether it makes the element what most others of its kind are
};

using Edits = std::vector<Edit>;

/// With the element and the remedy that these changes have.
Edit edit_of(const Subject& subject, const Note& fault, std::vector<Change> changes,
             bool like_others = false);

/// The description once it is edited.
struct Edited {
  std::shared_ptr<const Tree> tree;
  ResolvedConfig resolved;  ///< with what closures hold at zero placed there
};
Edited edited(const Subject& subject, const Edit& edit);

/// Both, the second of which is one of the description after the first.
Edit together(const Edit& first, const Edit& second);

/// "type: point", or "type=\"ball\"" where the URDF has joints of SDF: how the description says it; and the
/// type alone.
std::string type_text(const ResolvedConfig& resolved, ClosureType type);
std::string type_word(const ResolvedConfig& resolved, ClosureType type);

/// "1 0 0", as an attribute of a URDF has it.
std::string as_attribute(const Eigen::Vector3d& vector);

/// "(1, 0, 0)", for messages.
std::string in_brackets(const Eigen::Vector3d& vector);

/// "[1, 0, 0]", as a YAML has it.
std::string as_list(const Eigen::Vector3d& vector);

/// "closures: [{frames: [a, b], type: point}] under mechanism in robot.yaml", or as an option, which has no
/// types.
Note closures_entry(const Tree& tree, const std::vector<Closure>& closures, const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_EDIT_H
