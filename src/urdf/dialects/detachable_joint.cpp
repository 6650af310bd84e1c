// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/urdf/closure_dialects.h"
#include "parallel_aspects/urdf/xml_values.h"

namespace parallel_aspects::dialects {

DescribedLoops detachable_joint(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  for (const auto* gazebo = source.robot.FirstChildElement("gazebo"); gazebo != nullptr;
       gazebo = gazebo->NextSiblingElement("gazebo"))
    for (const auto* plugin = gazebo->FirstChildElement("plugin"); plugin != nullptr;
         plugin = plugin->NextSiblingElement("plugin")) {
      if (attribute(plugin, "name").find("DetachableJoint") == std::string::npos) continue;
      const std::string where = source.files.urdf + " has a DetachableJoint plugin that";
      const std::string parent_name = child_text(*plugin, "parent_link"),
                        child_name = child_text(*plugin, "child_link");
      const auto parent = described_link(source, parent_name, where, problems);
      const auto child = described_link(source, child_name, where, problems);
      if (parent && child)
        loops.closures.push_back(closed_at_zero(source.tree, parent_name + " - " + child_name, *parent,
                                                LinkFrame{*child}, ClosureType::automatic));
    }
  return loops;
}

}  // namespace parallel_aspects::dialects
