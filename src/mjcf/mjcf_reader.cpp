// SPDX-License-Identifier: BSD-3-Clause
// Reads MJCF with MuJoCo, which resolves defaults, units and frames. A library of its own, loaded where it is
// needed.
#include "model/linear_algebra.h"
#include "urdf/reading/robot_graph.h"

#include <Eigen/Geometry>
#include <tinyxml2.h>

#include "mjcf/compiled_model.h"
#include "mjcf/kinematic_elements.h"
#include <algorithm>
#include <array>
#include <memory>
#include <mujoco/mujoco.h>
#include <set>

namespace parallel_aspects::mjcf {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// [m]; anchors of the same two bodies nearer than this are one.
constexpr double same_place = 1e-9;

// A <connect> at two places is a hinge; with a third that is no more than this beside its axis, in shares of
// the distance of the first two, it still is one.
constexpr double on_axis = 1e-6;

Isometry3d frame(const mjtNum* position, const mjtNum* quaternion) {
  return Eigen::Translation3d(position[0], position[1], position[2]) *
         Eigen::Quaterniond(quaternion[0], quaternion[1], quaternion[2], quaternion[3]).normalized();
}

Isometry3d shift(const Vector3d& by) { return Isometry3d(Eigen::Translation3d(by)); }

Vector3d vector(const mjtNum* values) { return {values[0], values[1], values[2]}; }

class GraphBuilder {
 public:
  GraphBuilder(const mjModel& model, const KinematicElements& elements, const std::string& file,
               RobotGraph& graph)
      : model_(model), elements_(elements), file_(file), graph_(graph) {}

  void build() {
    graph_.name = model_.names;
    graph_.closures_described_by = "<equality>";
    graph_.notes = elements_.notes;
    find_poses();
    for (int body = 0; body < model_.nbody; ++body) name_body(body);
    for (int joint = 0; joint < model_.njnt; ++joint) joints_.insert(name(model_.name_jntadr, joint));
    for (int body = 1; body < model_.nbody; ++body) add_body(body);
    add_sites();
    add_equalities();
    add_site_equalities();
    take_as_hinges();
    mark_joints();
  }

 private:
  void problem(const std::string& text) { graph_.problems.push_back(file_ + " " + text); }

  const char* name(const int* addresses, int index) const { return model_.names + addresses[index]; }

  // Where bodies are in the world in the configuration of the file.
  void find_poses() {
    const std::unique_ptr<mjData, Free> data(mj_makeData(&model_));
    mj_kinematics(&model_, data.get());
    for (int body = 0; body < model_.nbody; ++body)
      poses_.push_back(frame(data->xpos + 3 * body, data->xquat + 4 * body));
  }

  void name_body(int body) {
    const std::string given = name(model_.name_bodyadr, body);
    graph_.bodies.push_back(new_name(given.empty() ? "body_" + std::to_string(body) : given, links_));
  }

  // Joints of one body move it one after the other, each with what the earlier ones did.
  void add_body(int body) {
    auto parent = static_cast<std::size_t>(model_.body_parentid[body]);
    Isometry3d origin = frame(model_.body_pos + 3 * body, model_.body_quat + 4 * body);
    const int first = model_.body_jntadr[body], count = model_.body_jntnum[body];
    if (count == 0)
      graph_.joints.push_back(
          held(new_name(graph_.bodies[static_cast<std::size_t>(body)] + "_fixed", joints_), parent,
               static_cast<std::size_t>(body), origin));
    for (int k = 0; k < count; ++k) {
      auto child = static_cast<std::size_t>(body);
      if (k + 1 < count) {
        child = graph_.bodies.size();
        graph_.bodies.push_back(new_name(graph_.bodies[static_cast<std::size_t>(body)] + "_part", links_));
      }
      if (model_.jnt_type[first + k] != mjJNT_FREE) add_joint(first + k, parent, child, origin);
      parent = child;
      origin.setIdentity();
    }
  }

  static GraphJoint held(const std::string& name, std::size_t parent, std::size_t child,
                         const Isometry3d& origin) {
    GraphJoint joint;
    joint.name = name;
    joint.element = "body '" + name + "'";
    joint.bodies = {parent, child};
    joint.frames[0] = origin;
    return joint;
  }

  // In the configuration of the file a joint has the value `ref`.
  void add_joint(int index, std::size_t parent, std::size_t child, const Isometry3d& origin) {
    GraphJoint joint;
    const std::string given = name(model_.name_jntadr, index);
    joint.name = given.empty() ? new_name(graph_.bodies[child] + "_joint", joints_) : given;
    joint.element = "joint '" + joint.name + "'";
    joint.bodies = {parent, child};
    const Vector3d axis = vector(model_.jnt_axis + 3 * index).normalized();
    joint.axes[0] = axis;
    joint.frames[1] = shift(vector(model_.jnt_pos + 3 * index));
    joint.frames[0] = origin * joint.frames[1];
    const double at_file = model_.qpos0[model_.jnt_qposadr[index]];
    switch (model_.jnt_type[index]) {
      case mjJNT_HINGE:
        joint.kind = GraphJointKind::revolute;
        joint.frames[0].rotate(Eigen::AngleAxisd(-at_file, axis));
        break;
      case mjJNT_SLIDE:
        joint.kind = GraphJointKind::prismatic;
        joint.frames[0].translate(-at_file * axis);
        break;
      default:
        joint.kind = GraphJointKind::ball;
    }
    if (model_.jnt_limited[index] != 0 && joint.kind == GraphJointKind::ball)
      graph_.notes.push_back("limits the angle of ball " + joint.element + ", which is not used.");
    else if (model_.jnt_limited[index] != 0)
      joint.limits[0] = {model_.jnt_range[2 * index], model_.jnt_range[2 * index + 1]};
    joint_ids_.push_back(index);
    joint_places_.push_back(graph_.joints.size());
    graph_.joints.push_back(joint);
  }

  void add_sites() {
    for (int site = 0; site < model_.nsite; ++site) {
      const std::string given = name(model_.name_siteadr, site);
      const bool is_taken = links_.count(given) > 0;
      graph_.frames.push_back({new_name(is_taken ? given + "_site" : given, links_),
                               static_cast<std::size_t>(model_.site_bodyid[site]),
                               frame(model_.site_pos + 3 * site, model_.site_quat + 4 * site)});
    }
  }

  GraphJoint constraint(const std::string& given, const std::string& element, std::size_t parent,
                        std::size_t child, bool is_weld) {
    GraphJoint joint;
    joint.kind = is_weld ? GraphJointKind::fixed : GraphJointKind::ball;
    joint.name =
        new_name(given.empty() ? graph_.bodies[parent] + "_" + graph_.bodies[child] : given, joints_);
    joint.element = element + " of '" + graph_.bodies[parent] + "' and '" + graph_.bodies[child] + "'";
    joint.bodies = {parent, child};
    joint.is_constraint = true;
    return joint;
  }

  // The first body has the anchor. That in the second is where the first one is in the file.
  void add_equalities() {
    for (int k = 0; k < model_.neq; ++k) {
      const auto first = static_cast<std::size_t>(model_.eq_obj1id[k]),
                 second = static_cast<std::size_t>(model_.eq_obj2id[k]);
      const std::string element = elements_.equalities[static_cast<std::size_t>(k)];
      const mjtNum* data = model_.eq_data + mjNEQDATA * k;
      const bool is_weld = model_.eq_type[k] == mjEQ_WELD;
      if (model_.eq_active[k] == 0) {
        graph_.notes.push_back("has " + element + ", which is not active and not used.");
        continue;
      }
      GraphJoint joint = constraint(name(model_.name_eqadr, k), element, second, first, is_weld);
      if (is_weld) {
        joint.frames[1] = frame(data + 3, data + 6);
      } else {
        joint.frames[1] = shift(vector(data));
        joint.frames[0] = poses_[second].inverse() * poses_[first] * joint.frames[1];
      }
      add_constraint(joint);
    }
  }

  void add_constraint(const GraphJoint& joint) {
    if (joint.bodies[0] == joint.bodies[1])
      problem("has " + joint.element + ", which are one body; name two different ones.");
    else
      graph_.joints.push_back(joint);
  }

  void add_site_equalities() {
    for (const SiteEquality& equality : elements_.site_equalities) {
      std::array<int, 2> sites{};
      for (std::size_t k = 0; k < 2; ++k) {
        sites[k] = mj_name2id(&model_, mjOBJ_SITE, equality.sites[k].c_str());
        if (sites[k] < 0)
          problem("has " + equality.element + " with the site '" + equality.sites[k] +
                  "', which does not exist; correct its name, or add it.");
      }
      if (sites[0] < 0 || sites[1] < 0) continue;
      GraphJoint joint =
          constraint(equality.name, equality.element, static_cast<std::size_t>(model_.site_bodyid[sites[0]]),
                     static_cast<std::size_t>(model_.site_bodyid[sites[1]]), equality.is_weld);
      for (std::size_t k = 0; k < 2; ++k)
        joint.frames[k] = frame(model_.site_pos + 3 * sites[k], model_.site_quat + 4 * sites[k]);
      add_constraint(joint);
    }
  }

  // Points of two bodies that are held together at several places leave a hinge, or nothing.
  void take_as_hinges() {
    std::vector<GraphJoint> joints;
    for (const GraphJoint& joint : graph_.joints) {
      const auto same = std::find_if(joints.begin(), joints.end(), [&](const GraphJoint& other) {
        return joint.is_constraint && other.is_constraint && joint.kind == GraphJointKind::ball &&
               other.kind != GraphJointKind::fixed &&
               std::is_permutation(joint.bodies.begin(), joint.bodies.end(), other.bodies.begin());
      });
      if (same == joints.end())
        joints.push_back(joint);
      else
        join(*same, joint);
    }
    graph_.joints = std::move(joints);
  }

  void join(GraphJoint& one, const GraphJoint& other) const {
    std::array<Vector3d, 2> away;
    for (std::size_t k = 0; k < 2; ++k)
      away[k] = other.frames[other.bodies[k] == one.bodies[k] ? k : 1 - k].translation() -
                one.frames[k].translation();
    if (away[0].norm() < same_place && away[1].norm() < same_place) return;
    if (one.kind == GraphJointKind::ball) {
      turn_about(away, one);
    } else if ((one.frames[1].linear() * one.axes[0]).cross(away[1]).norm() > on_axis * away[1].norm()) {
      one.kind = GraphJointKind::fixed;
    }
  }

  // At zero the bodies are turned as in the file, where their axes coincide there.
  void turn_about(const std::array<Vector3d, 2>& axes, GraphJoint& joint) const {
    const Eigen::Matrix3d between =
        poses_[joint.bodies[0]].linear().transpose() * poses_[joint.bodies[1]].linear();
    joint.kind = GraphJointKind::revolute;
    joint.axes[0] = axes[1].normalized();
    joint.frames[1].linear().setIdentity();
    joint.frames[0].linear() = between;
    if ((between * axes[1]).cross(axes[0]).norm() > on_axis * axes[0].norm() * axes[1].norm())
      joint.frames[0].linear() = shortest_rotation(axes[1], axes[0]).toRotationMatrix();
  }

  void mark_joints() {
    for (const JointActuator& actuator : elements_.actuators)
      if (GraphJoint* joint = joint_named(actuator.joint, actuator.element + " drives"))
        joint->is_actuated = true;
    for (const std::string& follower : elements_.followers)
      if (GraphJoint* joint = joint_named(follower, "an <equality> names")) joint->follows_another = true;
  }

  GraphJoint* joint_named(const std::string& name, const std::string& by) {
    const int id = mj_name2id(&model_, mjOBJ_JOINT, name.c_str());
    if (id < 0) problem("has no joint '" + name + "', which " + by + "; correct its name, or add it.");
    const auto known = std::find(joint_ids_.begin(), joint_ids_.end(), id);
    if (id < 0 || known == joint_ids_.end()) return nullptr;
    return &graph_.joints[joint_places_[static_cast<std::size_t>(known - joint_ids_.begin())]];
  }

  const mjModel& model_;
  const KinematicElements& elements_;
  const std::string& file_;
  RobotGraph& graph_;
  std::set<std::string> links_, joints_;  // names
  std::vector<Isometry3d> poses_;
  std::vector<int> joint_ids_;             // of MuJoCo
  std::vector<std::size_t> joint_places_;  // of the same in the graph
};

}  // namespace

void read_graph(const std::string& file, RobotGraph& graph) {
  const KinematicElements elements = kinematic_elements(file, graph.problems);
  if (!graph.problems.empty()) return;
  const auto model = compiled(elements, file, graph.problems);
  if (model) GraphBuilder(*model, elements, file, graph).build();
}

}  // namespace parallel_aspects::mjcf

extern "C" __attribute__((visibility("default"))) void parallel_aspects_read_robot_graph_1(
    const std::string& file, parallel_aspects::RobotGraph& graph) {
  parallel_aspects::mjcf::read_graph(file, graph);
}
