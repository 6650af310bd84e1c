// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/cones_report.h"

#include <string>

namespace parallel_aspects::tools {
namespace {

/// What the axis is fixed in, and given in the frame of.
std::string holder(const Manipulator& manipulator, const BallJointCone& cone) {
  if (cone.end == LegEnd::platform) return "platform";
  return manipulator.leg(cone.leg).kind().has_crank ? "crank" : "base";
}

constexpr std::size_t max_lines = 24;

/// `joint` is empty for a cone that stands for no joint limit.
void add(const Manipulator& manipulator, const BallJointCone& cone, const std::string& joint,
         Report& report) {
  const std::string leg = manipulator.leg(cone.leg).name, fixed_in = holder(manipulator, cone);
  nlohmann::json object{{"leg", leg},           {"end", name(cone.end)},
                        {"fixed_in", fixed_in}, {"axis", {cone.axis.x(), cone.axis.y(), cone.axis.z()}},
                        {"angle", cone.angle},  {"joint", nullptr}};
  if (!joint.empty()) object["joint"] = joint;
  report.json.push_back(object);
  report.text += "cone: the rod of " + leg + " is at most " + shown(cone.angle) + " rad from (" +
                 shown(cone.axis.x()) + ", " + shown(cone.axis.y()) + ", " + shown(cone.axis.z()) +
                 ") of the " + fixed_in + (joint.empty() ? "" : ", for a limit of " + joint) + "\n";
}

}  // namespace

Report report_cones(const Manipulator& manipulator, bool verbose) {
  Report report{nlohmann::json::array(), ""};
  for (const BallJointCone& cone : manipulator.constraints().cones) add(manipulator, cone, "", report);
  for (const PassiveCone& limit : manipulator.constraints().passive_cones)
    add(manipulator, limit.cone, limit.joint, report);
  if (report.json.size() > max_lines && !verbose)
    report.text = "cones: " + std::to_string(report.json.size()) + " bound the rods; --verbose lists them\n";
  return report;
}

}  // namespace parallel_aspects::tools
