// SPDX-License-Identifier: BSD-3-Clause

#include "model/message_text.h"
#include "urdf/description/xml_values.h"
#include "urdf/reading/robot_graph.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace parallel_aspects {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using tinyxml2::XMLElement;

constexpr double orthogonal = 1e-6;

// A URDF has no joint with one limit.
constexpr double no_limit = 1e6;

// No zero with a sign.
std::string exact(double value) { return number_text(value + 0.0, exact_digits); }

std::string vector_text(const Vector3d& v) { return exact(v.x()) + " " + exact(v.y()) + " " + exact(v.z()); }

class GraphWriter {
 public:
  GraphWriter(RobotGraph& graph, const std::string& file)
      : graph_(graph), file_(file), tree_(spanning_tree(graph)) {}

  std::string write() {
    robot_ = document_.NewElement("robot");
    document_.InsertEndChild(robot_);
    robot_->SetAttribute("name", graph_.name.empty() ? "robot" : graph_.name.c_str());
    note_what_is_left_out();
    for (const std::string& body : graph_.bodies) links_.insert(body);
    for (const GraphJoint& joint : graph_.joints) joints_.insert(joint.name);
    for (std::size_t body = 0; body < graph_.bodies.size(); ++body)
      if (tree_.is_connected[body]) add_link(graph_.bodies[body]);
    for (std::size_t joint = 0; joint < graph_.joints.size(); ++joint) write(joint);
    for (const GraphFrame& frame : graph_.frames) write(frame);
    for (const std::string& note : graph_.notes)
      robot_->InsertNewChildElement("reader_note")->SetAttribute("text", note.c_str());
    tinyxml2::XMLPrinter printer;
    document_.Print(&printer);
    return printer.CStr();
  }

 private:
  void problem(const std::string& text) { graph_.problems.push_back(file_ + " " + text); }

  void add_link(const std::string& name) {
    robot_->InsertNewChildElement("link")->SetAttribute("name", name.c_str());
  }

  // Most often the world with nothing on it.
  void note_what_is_left_out() {
    std::string names;
    std::size_t count = 0;
    for (std::size_t body = 1; body < graph_.bodies.size(); ++body) {
      if (tree_.is_connected[body]) continue;
      names += (count++ == 0 ? "'" : ", '") + graph_.bodies[body] + "'";
    }
    if (tree_.base != 0)
      graph_.notes.push_back("fixes no moving part to the world; '" + graph_.bodies[tree_.base] +
                             "' is taken as the base.");
    if (count > 0)
      graph_.notes.push_back("has bodies that nothing connects to the base, which are left out: " + names +
                             ".");
  }

  void write(std::size_t index) {
    const GraphJoint& joint = graph_.joints[index];
    switch (tree_.roles[index]) {
      case SpanningTree::Role::tree:
      case SpanningTree::Role::reversed:
        write_tree_joint(joint, tree_.roles[index] == SpanningTree::Role::reversed);
        break;
      case SpanningTree::Role::closure:
        write_closure(joint);
        break;
      case SpanningTree::Role::left_out:
        break;
    }
  }

  XMLElement* add_joint(const std::string& name, const char* type, const std::string& parent,
                        const std::string& child, const Isometry3d& origin) {
    XMLElement* joint = robot_->InsertNewChildElement("joint");
    joint->SetAttribute("name", name.c_str());
    joint->SetAttribute("type", type);
    joint->InsertNewChildElement("parent")->SetAttribute("link", parent.c_str());
    joint->InsertNewChildElement("child")->SetAttribute("link", child.c_str());
    set_frame(joint->InsertNewChildElement("origin"), origin);
    return joint;
  }

  static void set_frame(XMLElement* element, const Isometry3d& frame) {
    element->SetAttribute("xyz", vector_text(frame.translation()).c_str());
    element->SetAttribute("rpy", vector_text(roll_pitch_yaw(frame.linear())).c_str());
  }

  // The first link is turned as the child is; between several axes are links of their own, and where the
  // joint is beside the child's origin one more.
  void write_tree_joint(const GraphJoint& joint, bool reversed) {
    const DirectedJoint along = directed(joint, reversed);
    const bool in_origin = ends_in_origin(along);
    const Isometry3d turned(along.to.linear().transpose()),
        shift(Eigen::Translation3d(-along.to.translation()));
    std::string link = graph_.bodies[along.parent];
    Isometry3d origin = along.from * turned * (in_origin ? shift : Isometry3d::Identity());
    const std::string& child = graph_.bodies[along.child];
    const std::size_t count = along.steps.size();
    for (std::size_t k = 0; k < count; ++k) {
      const bool is_last = k + 1 == count;
      const std::string next = is_last && in_origin ? child : new_name(joint.name + "_frame", links_);
      if (next != child) add_link(next);
      const std::string name = step_name(joint, reversed ? count - 1 - k : k, count);
      write_step(joint, k, count, add_step(joint, along.steps[k], name, link, next, origin));
      link = next;
      origin.setIdentity();
    }
    if (count == 0)
      add_joint(joint.name, "fixed", link, child, origin);
    else if (!in_origin)
      add_joint(new_name(joint.name + "_to_origin", joints_), "fixed", link, child, shift);
  }

  // "ball_x", "ball_y", "ball_z"; "universal_1", "universal_2".
  std::string step_name(const GraphJoint& joint, std::size_t step, std::size_t count) {
    if (count == 1) return joint.name;
    return new_name(joint.name + "_" + (count == 3 ? std::string(1, "xyz"[step]) : std::to_string(step + 1)),
                    joints_);
  }

  XMLElement* add_step(const GraphJoint& joint, const DirectedStep& step, const std::string& name,
                       const std::string& parent, const std::string& child, const Isometry3d& origin) {
    const bool is_held = step.limits.lower == 0.0 && step.limits.upper == 0.0;
    const char* type = is_held                 ? "fixed"
                       : step.slides           ? "prismatic"
                       : step.limits.limited() ? "revolute"
                                               : "continuous";
    XMLElement* added = add_joint(name, type, parent, child, origin);
    if (is_held) {
      graph_.notes.push_back("gives " + joint.element + " no room between its limits; it is taken as fixed.");
      return added;
    }
    added->InsertNewChildElement("axis")->SetAttribute("xyz", vector_text(step.axis).c_str());
    write_limits(joint, step, added);
    return added;
  }

  static void write_limits(const GraphJoint& joint, const DirectedStep& step, XMLElement* added) {
    const bool has_velocity = std::isfinite(step.limits.velocity);
    if (!step.limits.limited() && !has_velocity && !joint.effort) return;
    XMLElement* limit = added->InsertNewChildElement("limit");
    if (step.limits.limited()) {
      limit->SetAttribute("lower", exact(std::max(step.limits.lower, -no_limit)).c_str());
      limit->SetAttribute("upper", exact(std::min(step.limits.upper, no_limit)).c_str());
    }
    if (has_velocity) limit->SetAttribute("velocity", exact(step.limits.velocity).c_str());
    if (joint.effort) limit->SetAttribute("effort", exact(*joint.effort).c_str());
  }

  void write_step(const GraphJoint& joint, std::size_t k, std::size_t count, XMLElement* added) {
    if (joint.is_actuated && count == 1)
      robot_->InsertNewChildElement("actuated_joint")->SetAttribute("name", joint.name.c_str());
    else if (joint.is_actuated && k == 0)
      problem("actuates " + joint.element + ", which has several axes; actuate a joint of one axis.");
    if (joint.follows_another) added->InsertNewChildElement("mimic");
  }

  // Whether a closure can say it.
  bool can_close(const GraphJoint& joint) {
    if (joint.kind == GraphJointKind::prismatic) {
      problem("closes a loop of slides alone with " + joint.element +
              ", which is not treated; leave it out.");
      return false;
    }
    if (joint.is_actuated) {
      problem("closes a loop of actuated joints alone with " + joint.element +
              ", which is not treated; let passive joints be between actuated ones.");
      return false;
    }
    if (joint.kind == GraphJointKind::universal && std::abs(joint.axes[0].dot(joint.axes[1])) > orthogonal) {
      problem("closes a loop with " + joint.element +
              ", whose two axes are not orthogonal; make them so, or write two revolute joints with a body "
              "between.");
      return false;
    }
    if (joint.limits[0].limited() || joint.limits[1].limited())
      graph_.notes.push_back("states limits for " + joint.element +
                             ", which closes a loop; they are not used.");
    return true;
  }

  void write_closure(const GraphJoint& joint) {
    if (!can_close(joint)) return;
    XMLElement* closure = robot_->InsertNewChildElement("loop_closure");
    closure->SetAttribute("name", joint.name.c_str());
    closure->SetAttribute("in", graph_.closures_described_by.c_str());
    Isometry3d first = joint.frames[0], second = joint.frames[1];
    const char* type = joint.kind == GraphJointKind::ball ? "ball" : "fixed";
    if (joint.kind == GraphJointKind::revolute || joint.kind == GraphJointKind::universal) {
      first.rotate(axes_with_z(joint.axes[0]));
      second.rotate(axes_with_z(joint.axes[0]));
      type = "revolute";
    }
    if (joint.kind == GraphJointKind::universal) {  // z of the first stays orthogonal to x of the second
      second = joint.frames[1];
      second.rotate(axes_with_z(joint.axes[1])).rotate(axes_with_z(Vector3d::UnitX()).transpose());
      type = "universal";
    }
    closure->SetAttribute("type", type);
    write_end(closure, joint.bodies[0], first);
    write_end(closure, joint.bodies[1], second);
  }

  void write_end(XMLElement* closure, std::size_t body, const Isometry3d& frame) {
    XMLElement* end = closure->InsertNewChildElement("end");
    end->SetAttribute("link", graph_.bodies[body].c_str());
    set_frame(end, frame);
  }

  void write(const GraphFrame& frame) {
    if (!tree_.is_connected[frame.body]) return;
    const std::string name = new_name(frame.name, links_);
    add_link(name);
    add_joint(new_name(name + "_frame", joints_), "fixed", graph_.bodies[frame.body], name, frame.in_body);
  }

  RobotGraph& graph_;
  const std::string& file_;
  SpanningTree tree_;
  tinyxml2::XMLDocument document_;
  XMLElement* robot_ = nullptr;
  std::set<std::string> links_, joints_;  // names
};

}  // namespace

std::string urdf_text(RobotGraph& graph, const std::string& file) { return GraphWriter(graph, file).write(); }

}  // namespace parallel_aspects
