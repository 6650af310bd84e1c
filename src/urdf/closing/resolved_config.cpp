// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/resolved_config.h"

#include "model/message_text.h"
#include "urdf/closing/ends_of_loops.h"
#include "urdf/description/nearest_name.h"

#include <algorithm>

namespace parallel_aspects {
namespace {

// Of a frame from its link, in sums of all origins: far beyond any robot.
constexpr double farthest_frame = 100.0;

bool are_same(const LinkFrame& one, const LinkFrame& other) {
  return one.link == other.link && one.in_link.isApprox(other.in_link);
}

bool are_same(const Closure& one, const Closure& other) {
  const auto &a = one.frames, &b = other.frames;
  return one.type == other.type &&
         ((are_same(a[0], b[0]) && are_same(a[1], b[1])) || (are_same(a[0], b[1]) && are_same(a[1], b[0])));
}

class NameResolver {
 public:
  NameResolver(const LoopSource& source, Problems& problems, Notes& notes)
      : source_(source), tree_(source.tree), files_(source.files), problems_(problems), notes_(notes) {}

  ResolvedConfig resolve(const MechanismConfig& config) {
    check_frames(config);
    if (!config.base_link.empty()) result_.base = link("mechanism.base_link", config.base_link);
    if (!config.operational_point.link.empty())
      result_.actuated_joints.platform_link =
          link("mechanism.operational_point", config.operational_point.link);
    for (std::size_t k = 0; k < config.closures.size(); ++k) add_closure("closures", k, config.closures[k]);
    std::vector<std::string> actuated_joints = config.actuated_joints;
    const bool loops_are_read = config.lists_closures || describe_loops(!config.added_closures.empty());
    for (std::size_t k = 0; k < config.added_closures.size(); ++k)
      add_closure("added_closures", k, config.added_closures[k]);
    if (!config.lists_actuated_joints && loops_are_read) describe_actuated_joints(actuated_joints);
    for (const std::string& joint : actuated_joints) add_actuated_joint(joint, actuated_joints);
    return result_;
  }

 private:
  void problem(const std::string& text) { problems_.push_back(files_.config + " " + text); }

  void check_frames(const MechanismConfig& config) {
    const ConfiguredFrame& point = config.operational_point;
    for (const TreeJoint& joint : tree_.joints)
      if (point.is_link || tree_.links[joint.child] != point.link)
        reach_ += joint.origin.translation().norm();
    check_distance("mechanism.operational_point", point);
    if (!point.name.empty()) frame_names_.push_back(point.name);
    check_closures("mechanism.closures", config.closures);
    check_closures("mechanism.added_closures", config.added_closures);
  }

  void check_closures(const std::string& list, const std::vector<ConfiguredClosure>& closures) {
    for (std::size_t k = 0; k < closures.size(); ++k)
      for (const ConfiguredFrame& frame : closures[k].frames) {
        const std::string key = list + "[" + std::to_string(k) + "].frames";
        check_distance(key, frame);
        if (!frame.name.empty()) check_name(key, frame.name);
      }
  }

  // A frame is somewhere at the robot.
  void check_distance(const std::string& key, const ConfiguredFrame& frame) {
    const double away = frame.in_link.translation().stableNorm();
    if (reach_ > 0.0 && !(away <= farthest_frame * reach_))
      problem("puts a frame of " + key + " " + number_text(away, 3) +
              " m away from its link, while the origins of all joints of " + files_.urdf + " add up to " +
              number_text(reach_, 3) + " m; give its xyz in metres.");
  }

  // One name stands for one frame.
  void check_name(const std::string& key, const std::string& name) {
    if (contains(frame_names_, name))
      problem("calls two frames '" + name + "', the second in " + key + "; give each a name of its own.");
    else if (tree_.link_named(name))
      problem("calls a frame of " + key + " '" + name + "', but " + files_.urdf +
              " has a link of that name; give the frame another name under its key 'name'.");
    frame_names_.push_back(name);
  }

  std::size_t link(const std::string& key, const std::string& name) {
    if (const auto found = tree_.link_named(name)) return *found;
    problem("names link '" + name + "' in " + key + ", but " + files_.urdf + " has no such link" +
            suggestion(name, tree_.links, problems_));
    return 0;
  }

  void add_closure(const std::string& list, std::size_t index, const ConfiguredClosure& configured) {
    const std::string key = "mechanism." + list + "[" + std::to_string(index) + "].frames";
    Closure closure;
    closure.name = configured.frames[0].label() + " - " + configured.frames[1].label();
    closure.type = configured.type;
    for (std::size_t k = 0; k < 2; ++k)
      closure.frames[k] = {link(key, configured.frames[k].link), configured.frames[k].in_link};
    if (configured.frames[0].link == configured.frames[1].link)
      problem("closes link '" + configured.frames[0].link + "' with itself in " + key +
              "; name two different links.");
    result_.closures.push_back(closure);
  }

  // Whether the descriptions of loops and actuated joints could be read.
  bool describe_loops(bool any_added) {
    const std::size_t before = problems_.size();
    const FoundLoops found = find_described_loops(source_, problems_);
    if (problems_.size() > before) return false;
    if (found.loops.closures.empty() && any_added) return true;
    if (found.loops.closures.empty()) {
      if (const auto serial = serial_arm_text(tree_, files_.urdf)) {
        problems_.push_back(*serial);
        return false;
      }
      problem("has no mechanism.closures, and " + files_.urdf +
              " is an open tree without them; list the frames that each loop holds together.");
      return true;
    }
    result_.closures = found.loops.closures;
    result_.closure_dialect = found.dialect;
    notes_.push_back("The closures are those that " + std::string(found.dialect) + " describes, " +
                     std::to_string(result_.closures.size()) + " in all.");
    described_joints_ = found.loops.actuated_joints;
    described_joints_key_ = found.loops.actuated_joints_key;
    return true;
  }

  void describe_actuated_joints(std::vector<std::string>& actuated_joints) {
    const bool from_loops = !described_joints_.empty();
    const DescribedActuation described = described_actuation(source_);
    actuated_joints = from_loops ? described_joints_ : described.joints;
    if (actuated_joints.empty()) {
      problem("does not say mechanism.actuated_joints, and " + files_.urdf +
              " has no transmissions; list the actuated joints, one a leg.");
      return;
    }
    const std::string element = "a " + std::string(described.element);
    result_.actuation_origin =
        from_loops ? described_joints_key_ + " selects" : "have " + element + " in " + files_.urdf;
    actuated_joints_named_in_ =
        from_loops ? files_.config + " names joint '" : files_.urdf + " actuates joint '";
    actuated_joints_named_by_ =
        from_loops ? "' in " + described_joints_key_ + ", but " : "' in " + element + ", but ";
    std::vector<std::string> once;
    for (const std::string& joint : actuated_joints)
      if (!contains(once, joint)) once.push_back(joint);
    actuated_joints = once;
  }

  void add_actuated_joint(const std::string& name, const std::vector<std::string>& all) {
    const auto found = tree_.joint_named(name);
    if (!found || !tree_.joints[*found].variable || tree_.joints[*found].mimics) {
      problems_.push_back(actuated_joints_named_in_ + name + actuated_joints_named_by_ + files_.urdf +
                          reason_not_to_actuate(name, found, all));
      return;
    }
    result_.actuated_joints.variables.push_back(*tree_.joints[*found].variable);
  }

  std::string reason_not_to_actuate(const std::string& name, std::optional<std::size_t> found,
                                    const std::vector<std::string>& actuated_joints) const {
    if (found && tree_.joints[*found].mimics)
      return " lets that joint mimic another; actuate the other one, or take out the <mimic>.";
    if (found) return " fixes that joint; give it a type that moves there, or actuate a movable joint.";
    std::vector<std::string> movable;
    for (const std::size_t joint : tree_.movable)
      if (!contains(actuated_joints, tree_.joints[joint].name)) movable.push_back(tree_.joints[joint].name);
    return " has no such joint" + suggestion(name, movable, problems_);
  }

  const LoopSource& source_;
  const Tree& tree_;
  const SourceNames& files_;
  Problems& problems_;
  Notes& notes_;
  std::vector<std::string> described_joints_;  // by the dialect of the closures
  std::string described_joints_key_;
  std::string actuated_joints_named_in_ = files_.config + " names joint '";  // for messages, around the name
  std::string actuated_joints_named_by_ = "' in mechanism.actuated_joints, but ";
  std::vector<std::string> frame_names_;  // that the YAML gives
  double reach_ = 0.0;                    // of all links of the URDF one after the other [m]
  ResolvedConfig result_;
};

}  // namespace

const std::string& file_of_closures(const ResolvedConfig& resolved, const SourceNames& files) {
  const std::string& dialect = resolved.closure_dialect;
  const bool in_config = dialect.empty() || dialect == "closed_loop" || dialect == "loop_closures.yaml";
  return in_config ? files.config : files.urdf;
}

ResolvedConfig resolve_config(const MechanismConfig& config, const LoopSource& source, Problems& problems,
                              Notes& notes) {
  return NameResolver(source, problems, notes).resolve(config);
}

std::optional<Note> leave_out_repeated(ResolvedConfig& resolved, const SourceNames& files) {
  std::vector<Closure> once;
  std::vector<std::string> repeated;
  for (const Closure& closure : resolved.closures) {
    const bool is_known =
        std::any_of(once.begin(), once.end(), [&](const Closure& other) { return are_same(closure, other); });
    if (!is_known)
      once.push_back(closure);
    else if (!contains(repeated, closure.name))
      repeated.push_back(closure.name);
  }
  const bool is_twice = resolved.closures.size() == once.size() + 1;
  resolved.closures = once;
  if (repeated.empty()) return std::nullopt;
  const Note names = listed_names(repeated);
  return file_of_closures(resolved, files) + " lists " +
         (is_twice              ? "closure " + names + " twice, which counts once; leave out one entry."
          : repeated.size() > 1 ? "closures " + names +
                                      " more than once, which count once; leave out all "
                                      "entries of each but one."
                                : "closure " + names +
                                      " more than once, which counts once; leave out all "
                                      "entries but one.");
}

void add_operational_point(ConfiguredFrame& point, const SourceNames& files, Tree& tree, Problems& problems) {
  const auto parent = tree.link_named(point.link);
  if (point.is_link || !parent) return;
  const std::string name = point.name.empty() ? unnamed_operational_point : point.name;
  if (tree.link_named(name))
    problems.push_back(files.config + " calls the frame of mechanism.operational_point '" + name + "', but " +
                       files.urdf +
                       " has a link of that name; give the frame another name under its key 'name'.");
  TreeJoint joint;
  joint.name = name;
  joint.parent = *parent;
  joint.child = tree.links.size();
  joint.origin = point.in_link;
  tree.joint_above.emplace_back(tree.joints.size());
  tree.joints.push_back(joint);
  tree.links.push_back(name);
  point.link = name;
}

}  // namespace parallel_aspects
