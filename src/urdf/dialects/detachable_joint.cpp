// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/xml_values.h"
#include "urdf/dialects/closure_dialects.h"

namespace parallel_aspects::dialects {
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
