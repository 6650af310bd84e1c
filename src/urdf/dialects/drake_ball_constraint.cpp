// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/xml_values.h"
#include "urdf/dialects/closure_dialects.h"

namespace parallel_aspects::dialects {
namespace {

using tinyxml2::XMLElement;

std::optional<LinkFrame> end_of(const LoopSource& source, const XMLElement& constraint, const char* body,
                                const char* point, Problems& problems) {
  const std::string where = source.files.urdf + " has a <drake:ball_constraint> that";
  const auto link =
      described_link(source, attribute(constraint.FirstChildElement(body), "name"), where, problems);
  const auto frame = frame_of(attribute(constraint.FirstChildElement(point), "value"), "");
  if (!frame)
    problems.push_back(where + " has a " + point + " that is not three finite numbers; write three.");
  if (!link || !frame) return std::nullopt;
  return LinkFrame{*link, *frame};
}

}  // namespace

DescribedLoops drake_ball_constraint(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  for (const auto* constraint = source.robot.FirstChildElement("drake:ball_constraint");
       constraint != nullptr; constraint = constraint->NextSiblingElement("drake:ball_constraint")) {
    const auto one =
        end_of(source, *constraint, "drake:ball_constraint_body_A", "drake:ball_constraint_p_AP", problems);
    const auto other =
        end_of(source, *constraint, "drake:ball_constraint_body_B", "drake:ball_constraint_p_BQ", problems);
    if (!one || !other) continue;
    const std::string name = source.tree.links[one->link] + " - " + source.tree.links[other->link];
    loops.closures.push_back({name, {*one, *other}, ClosureType::point});
  }
  return loops;
}

}  // namespace parallel_aspects::dialects
