// SPDX-License-Identifier: BSD-3-Clause
// Reads SDF with sdformat, which resolves includes, frames and poses. A library of its own, loaded where it
// is needed.
#include "urdf/reading/robot_graph.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sdf/sdf.hh>
#include <set>

namespace parallel_aspects::sdformat {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr std::size_t max_problems = 5;

// What sdformat takes for no limit.
constexpr double no_limit = 1e15;

Isometry3d isometry(const ignition::math::Pose3d& pose) {
  return Eigen::Translation3d(pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z()) *
         Eigen::Quaterniond(pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z()).normalized();
}

const char* word(sdf::JointType type) {
  switch (type) {
    case sdf::JointType::BALL:
      return "ball";
    case sdf::JointType::CONTINUOUS:
      return "continuous";
    case sdf::JointType::FIXED:
      return "fixed";
    case sdf::JointType::GEARBOX:
      return "gearbox";
    case sdf::JointType::PRISMATIC:
      return "prismatic";
    case sdf::JointType::REVOLUTE:
      return "revolute";
    case sdf::JointType::REVOLUTE2:
      return "revolute2";
    case sdf::JointType::SCREW:
      return "screw";
    case sdf::JointType::UNIVERSAL:
      return "universal";
    case sdf::JointType::INVALID:
      break;
  }
  return "unknown";
}

std::optional<GraphJointKind> kind_of(sdf::JointType type) {
  switch (type) {
    case sdf::JointType::BALL:
      return GraphJointKind::ball;
    case sdf::JointType::CONTINUOUS:
    case sdf::JointType::REVOLUTE:
      return GraphJointKind::revolute;
    case sdf::JointType::FIXED:
      return GraphJointKind::fixed;
    case sdf::JointType::PRISMATIC:
      return GraphJointKind::prismatic;
    case sdf::JointType::REVOLUTE2:
    case sdf::JointType::UNIVERSAL:
      return GraphJointKind::universal;
    case sdf::JointType::GEARBOX:
    case sdf::JointType::SCREW:
    case sdf::JointType::INVALID:
      break;
  }
  return std::nullopt;
}

std::size_t axis_count(GraphJointKind kind) {
  switch (kind) {
    case GraphJointKind::revolute:
    case GraphJointKind::prismatic:
      return 1;
    case GraphJointKind::universal:
      return 2;
    case GraphJointKind::ball:
    case GraphJointKind::fixed:
      break;
  }
  return 0;
}

double limit_or_none(double value) {
  return std::abs(value) < no_limit ? value : std::copysign(std::numeric_limits<double>::infinity(), value);
}

// A model inside another has its names behind that of the model.
class GraphBuilder {
 public:
  GraphBuilder(const std::string& file, RobotGraph& graph) : file_(file), graph_(graph) {}

  void build(const sdf::Model& model, const Isometry3d& in_world) {
    graph_.name = model.Name();
    graph_.closures_described_by = "the SDF";
    graph_.bodies = {"world"};
    taken_.insert("world");
    poses_ = {Isometry3d::Identity()};
    add_links(model, "", in_world);
    add_joints(model, "");
    add_frames(model, "");
  }

 private:
  void problem(const std::string& text) { graph_.problems.push_back(file_ + " " + text); }

  bool is_good(const sdf::Errors& errors, const std::string& element) {
    if (!errors.empty())
      problem("has " + element + ", which sdformat cannot place: " + errors.front().Message() +
              "; correct it there.");
    return errors.empty();
  }

  // Short where that is the name of one thing only.
  static std::string new_name(const std::string& name, const std::string& scope,
                              std::set<std::string>& taken) {
    std::string result = name;
    if (!taken.insert(result).second) {
      std::string prefix = scope;
      for (std::size_t k; (k = prefix.find("::")) != std::string::npos;) prefix.replace(k, 2, "_");
      result = prefix + name;
      for (int k = 2; !taken.insert(result).second; ++k) result = prefix + name + "_" + std::to_string(k);
    }
    return result;
  }

  // The link that a robot is described about comes first.
  void add_links(const sdf::Model& model, const std::string& scope, const Isometry3d& in_world) {
    std::vector<const sdf::Link*> links;
    for (std::uint64_t k = 0; k < model.LinkCount(); ++k) links.push_back(model.LinkByIndex(k));
    std::stable_partition(links.begin(), links.end(),
                          [&](const sdf::Link* link) { return link->Name() == model.CanonicalLinkName(); });
    for (const sdf::Link* link : links) {
      ignition::math::Pose3d pose;
      if (!is_good(link->SemanticPose().Resolve(pose, "__model__"), "link '" + scope + link->Name() + "'"))
        continue;
      indices_[scope + link->Name()] = graph_.bodies.size();
      graph_.bodies.push_back(new_name(link->Name(), scope, taken_));
      poses_.push_back(in_world * isometry(pose));
    }
    for (std::uint64_t k = 0; k < model.ModelCount(); ++k) {
      const sdf::Model& nested = *model.ModelByIndex(k);
      ignition::math::Pose3d pose;
      if (is_good(nested.SemanticPose().Resolve(pose, "__model__"), "model '" + scope + nested.Name() + "'"))
        add_links(nested, scope + nested.Name() + "::", in_world * isometry(pose));
    }
  }

  // Those of the models inside come first, so that joints between these close the loops.
  void add_joints(const sdf::Model& model, const std::string& scope) {
    for (std::uint64_t k = 0; k < model.ModelCount(); ++k)
      add_joints(*model.ModelByIndex(k), scope + model.ModelByIndex(k)->Name() + "::");
    for (std::uint64_t k = 0; k < model.JointCount(); ++k) add_joint(*model.JointByIndex(k), scope);
  }

  std::optional<std::size_t> body_named(const std::string& name, const std::string& scope) const {
    if (name == "world") return 0;
    const auto found = indices_.find(scope + name);
    if (found == indices_.end()) return std::nullopt;
    return found->second;
  }

  void add_joint(const sdf::Joint& read, const std::string& scope) {
    GraphJoint joint;
    joint.element = "joint '" + scope + read.Name() + "'";
    const auto kind = kind_of(read.Type());
    if (!kind) {
      problem("gives " + joint.element + " the type '" + word(read.Type()) +
              "'; use revolute, continuous, prismatic, universal, revolute2, ball or fixed.");
      return;
    }
    joint.kind = *kind;
    std::string parent, child;
    ignition::math::Pose3d pose;
    if (!is_good(read.ResolveParentLink(parent), joint.element) ||
        !is_good(read.ResolveChildLink(child), joint.element) ||
        !is_good(read.SemanticPose().Resolve(pose, child), joint.element))
      return;
    const auto one = body_named(parent, scope), other = body_named(child, scope);
    if (!one || !other || *one == *other) {
      problem("joins '" + parent + "' and '" + child + "' by " + joint.element +
              "; name two different links.");
      return;
    }
    joint.name = new_name(read.Name(), scope, taken_joints_);
    joint.bodies = {*one, *other};
    joint.frames[1] = isometry(pose);
    joint.frames[0] = poses_[*one].inverse() * poses_[*other] * joint.frames[1];
    if (read_axes(read, joint)) graph_.joints.push_back(joint);
  }

  bool read_axes(const sdf::Joint& read, GraphJoint& joint) {
    for (std::size_t k = 0; k < axis_count(joint.kind); ++k) {
      const sdf::JointAxis* axis = read.Axis(static_cast<unsigned>(k));
      if (axis == nullptr) {
        problem("gives " + joint.element + " no <axis" + (k == 0 ? "" : "2") + ">; state the direction.");
        return false;
      }
      ignition::math::Vector3d direction;
      if (!is_good(axis->ResolveXyz(direction, read.Name()), joint.element)) return false;
      joint.axes[k] = Vector3d(direction.X(), direction.Y(), direction.Z()).normalized();
      if (read.Type() != sdf::JointType::CONTINUOUS) {
        joint.limits[k].lower = limit_or_none(axis->Lower());
        joint.limits[k].upper = limit_or_none(axis->Upper());
      }
      if (std::isfinite(axis->MaxVelocity()) && axis->MaxVelocity() > 0.0)
        joint.limits[k].velocity = axis->MaxVelocity();
      if (k == 0 && std::isfinite(axis->Effort()) && axis->Effort() >= 0.0) joint.effort = axis->Effort();
      if (joint.limits[k].lower > joint.limits[k].upper) {
        problem("gives " + joint.element + " a lower limit above its upper one; exchange them.");
        return false;
      }
    }
    return true;
  }

  void add_frames(const sdf::Model& model, const std::string& scope) {
    for (std::uint64_t k = 0; k < model.FrameCount(); ++k) {
      const sdf::Frame& frame = *model.FrameByIndex(k);
      const std::string element = "frame '" + scope + frame.Name() + "'";
      std::string link;
      ignition::math::Pose3d pose;
      if (!is_good(frame.ResolveAttachedToBody(link), element) ||
          !is_good(frame.SemanticPose().Resolve(pose, link), element))
        continue;
      if (const auto body = body_named(link, scope))
        graph_.frames.push_back({frame.Name(), *body, isometry(pose)});
    }
    for (std::uint64_t k = 0; k < model.ModelCount(); ++k)
      add_frames(*model.ModelByIndex(k), scope + model.ModelByIndex(k)->Name() + "::");
  }

  const std::string& file_;
  RobotGraph& graph_;
  std::set<std::string> taken_, taken_joints_;
  std::map<std::string, std::size_t> indices_;  // of links by their name in the outermost model
  std::vector<Isometry3d> poses_;               // of bodies in the world
};

std::string text_of(const sdf::Error& error) {
  std::string text = error.Message();
  while (!text.empty() && (text.back() == '.' || text.back() == '\n')) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (error.LineNumber()) text += " (line " + std::to_string(*error.LineNumber()) + ")";
  return text;
}

// Graphs cannot be built as a consequence of what another error says.
bool follows_from_others(const sdf::Error& error) {
  return error.Code() == sdf::ErrorCode::POSE_RELATIVE_TO_GRAPH_ERROR ||
         error.Code() == sdf::ErrorCode::FRAME_ATTACHED_TO_GRAPH_ERROR ||
         error.Message().rfind("FrameAttachedToGraph", 0) == 0;
}

const char* remedy(const sdf::Error& error) {
  return error.Code() == sdf::ErrorCode::URI_LOOKUP
             ? "; put that model beside the file, or name its folder in SDF_PATH."
             : "; correct it there.";
}

void add_errors(const sdf::Errors& errors, const std::string& file, Problems& problems) {
  const bool has_cause = !std::all_of(errors.begin(), errors.end(), follows_from_others);
  for (const sdf::Error& error : errors) {
    if (has_cause && follows_from_others(error)) continue;
    const std::string text = file + " is refused by sdformat: " + text_of(error) + remedy(error);
    if (problems.size() < max_problems && std::find(problems.begin(), problems.end(), text) == problems.end())
      problems.push_back(text);
  }
}

bool has_joints(const sdf::Model& model) {
  if (model.JointCount() > 0) return true;
  for (std::uint64_t k = 0; k < model.ModelCount(); ++k)
    if (has_joints(*model.ModelByIndex(k))) return true;
  return false;
}

// The model of the file, or those of its worlds that have joints.
std::vector<const sdf::Model*> robots_in(const sdf::Root& root) {
  if (root.Model() != nullptr) return {root.Model()};
  std::vector<const sdf::Model*> robots;
  for (std::uint64_t w = 0; w < root.WorldCount(); ++w)
    for (std::uint64_t k = 0; k < root.WorldByIndex(w)->ModelCount(); ++k)
      if (has_joints(*root.WorldByIndex(w)->ModelByIndex(k)))
        robots.push_back(root.WorldByIndex(w)->ModelByIndex(k));
  return robots;
}

Isometry3d pose_in_world(const sdf::Model& model) {
  ignition::math::Pose3d pose;
  if (!model.SemanticPose().Resolve(pose).empty()) pose = model.RawPose();
  return isometry(pose);
}

}  // namespace

void read_graph(const std::string& file, RobotGraph& graph) {
  sdf::Console::Instance()->SetQuiet(true);
  sdf::ParserConfig config = sdf::ParserConfig::GlobalConfig();
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  for (const auto& place : {folder, folder.parent_path()}) config.AddURIPath("model://", place.string());
  sdf::Root root;
  add_errors(root.Load(file, config), file, graph.problems);
  if (!graph.problems.empty()) return;
  const std::vector<const sdf::Model*> robots = robots_in(root);
  if (robots.size() == 1) {
    GraphBuilder(file, graph).build(*robots.front(), pose_in_world(*robots.front()));
    return;
  }
  std::string names;
  for (const sdf::Model* robot : robots) names += (names.empty() ? "'" : ", '") + robot->Name() + "'";
  graph.problems.push_back(file + (robots.empty() ? " has no model with joints; give the SDF of a robot."
                                                  : " has several models with joints, " + names +
                                                        "; give a file with one of them."));
}

}  // namespace parallel_aspects::sdformat

extern "C" __attribute__((visibility("default"))) void parallel_aspects_read_robot_graph_1(
    const std::string& file, parallel_aspects::RobotGraph& graph) {
  parallel_aspects::sdformat::read_graph(file, graph);
}
