// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DIALECTS_CLOSURE_DIALECTS_H
#define PARALLEL_ASPECTS_URDF_DIALECTS_CLOSURE_DIALECTS_H

#include "parallel_aspects/model/problems.h"
#include "urdf/description/closure.h"
#include "urdf/description/messages.h"
#include "urdf/description/tree.h"

#include <tinyxml2.h>
#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parallel_aspects {

/// What a description may say its closures in.
struct LoopSource {
  const tinyxml2::XMLElement& robot;  ///< the URDF
  const YAML::Node& config;           ///< the whole YAML file
  const Tree& tree;
  const SourceNames& files;
};

/// Closures, and actuated joints where the dialect has a way to say them.
struct DescribedLoops {
  std::vector<Closure> closures;
  std::vector<std::string> actuated_joints;
  std::string_view actuated_joints_key = "name_mot";  ///< of the YAML, where these are listed
};

/// One way in which people write closures: how to read it. What is wrong is added to `problems`.
struct ClosureDialect {
  std::string_view name;  ///< for messages
  DescribedLoops (*read)(const LoopSource& source, Problems& problems);
};

/// All dialects, the commonest first.
const std::vector<ClosureDialect>& closure_dialects();

/// The first dialect that finds a closure, with the name of that dialect; empty where none does. Closures
/// between links that are fixed to one another are left out, and fixed ones become welds.
struct FoundLoops {
  std::string_view dialect;
  DescribedLoops loops;
};
FoundLoops find_described_loops(const LoopSource& source, Problems& problems);

/// Joints that a URDF says are actuated, in the order of the file, and where it says so.
struct DescribedActuation {
  std::string_view element;  ///< for messages, after an indefinite article
  std::vector<std::string> joints;
};

/// The joints that the `<actuator>` of an MJCF drives, or with a command interface in `<ros2_control>`; where
/// there are none, those with a
/// `<transmission>` that does more than report their state.
DescribedActuation described_actuation(const LoopSource& source);

/// The link of that name; nothing, and a message in `problems` that says where it is named, when there is
/// none.
std::optional<std::size_t> described_link(const LoopSource& source, const std::string& name,
                                          const std::string& where, Problems& problems);

/// The type of a closure by the names that URDF, SDF and others give it: revolute, continuous, hinge, ball,
/// spherical, point, universal, fixed, weld, each also with `_joint`; nothing for any other.
std::optional<ClosureType> described_type(std::string name) noexcept;

/// Where all links are while all joints are zero, in the frame of the root.
Poses poses_at_zero(const Tree& tree);

/// Two frames that coincide in `poses`, those at zero, `child` being given; as simulators make a joint.
Closure closed_at_zero(const Poses& poses, const std::string& name, std::size_t parent,
                       const LinkFrame& child, ClosureType type);

namespace dialects {

/// `<gazebo><joint type="revolute|fixed|ball|universal"><parent/><child/><pose/><axis/></joint></gazebo>`:
/// the joint of SDF, which holds together what coincides at zero. Its pose is in the frame of the child, its
/// axis in that of the joint, unless `relative_to`, `expressed_in` or `use_parent_model_frame` say otherwise.
DescribedLoops gazebo_joint(const LoopSource& source, Problems& problems);

/// Links `closing_X_1` and `closing_X_2`, or `closing_X_A` and `closing_X_B`; of no stated type.
DescribedLoops closing_frames(const LoopSource& source, Problems& problems);

/// The file of Gepetto's toolbox_parallel_robots, its keys at the top level of the YAML: `closed_loop` with
/// pairs of link or joint names, `type` with 3d or 6d, and `name_mot` with the names of the actuated joints
/// or a part of them.
DescribedLoops gepetto_file(const LoopSource& source, Problems& problems);

/// `<constraint type="spherical_joint"><parent/><parent_origin/><parent_axis/><child/>...`: urdfdom pull
/// request 264.
DescribedLoops constraint_element(const LoopSource& source, Problems& problems);

/// The DetachableJoint plugin of Gazebo: a parent and a child link, which are welded where they are at zero.
/// Plugins that hold another model are passed over.
DescribedLoops detachable_joint(const LoopSource& source, Problems& problems);

/// `<loop_joint><link1 link xyz rpy/><link2 link xyz rpy/></loop_joint>`, with a type (Isaac Sim) or an
/// `<axis>` (early Drake); or with `<parent link/><parent_origin xyz/>`, the same of the child, and an axis
/// in the parent link.
DescribedLoops loop_joint(const LoopSource& source, Problems& problems);

/// `<drake:ball_constraint>` with two bodies and a point in each.
DescribedLoops drake_ball_constraint(const LoopSource& source, Problems& problems);

/// `<connect>` and `<weld>` in the `<equality>` of an MJCF, in the elements of `urdf_text`.
DescribedLoops equality(const LoopSource& source, Problems& problems);

/// Joints of SDF whose child has another parent, in the elements of `urdf_text`.
DescribedLoops sdf_joint(const LoopSource& source, Problems& problems);

/// loop_closures.yaml of sw2robot, its keys at the top level of the YAML: `closures` with `link_a`, `link_b`,
/// and the `point` and `axis` of a hinge in the frame of the root link while all joints are zero;
/// `independent` joints are actuated, or all but the `dependent` ones.
DescribedLoops loop_closures_file(const LoopSource& source, Problems& problems);

}  // namespace dialects
}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIALECTS_CLOSURE_DIALECTS_H
