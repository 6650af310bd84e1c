// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/xml_values.h"
#include "urdf/dialects/closure_dialects.h"

namespace parallel_aspects::dialects {
namespace {

using tinyxml2::XMLElement;

std::optional<LinkFrame> end_of(const LoopSource& source, const XMLElement* end, Problems& problems) {
  const auto link =
      described_link(source, attribute(end, "link"), source.files.urdf + " has a closure that", problems);
  const auto frame = frame_of(attribute(end, "xyz"), attribute(end, "rpy"));
  if (!link || !frame) return std::nullopt;
  return LinkFrame{*link, *frame};
}

// The <loop_closure> elements that were written for this dialect.
DescribedLoops closures_in(const LoopSource& source, const std::string& dialect, Problems& problems) {
  DescribedLoops loops;
  for (const auto* closure = source.robot.FirstChildElement("loop_closure"); closure != nullptr;
       closure = closure->NextSiblingElement("loop_closure")) {
    if (attribute(closure, "in") != dialect) continue;
    const auto* first = closure->FirstChildElement("end");
    const auto* second = first != nullptr ? first->NextSiblingElement("end") : nullptr;
    const auto one = end_of(source, first, problems), other = end_of(source, second, problems);
    const auto type = described_type(attribute(closure, "type"));
    if (!type || !one || !other)  // not as `urdf_text` writes them
      problems.push_back(source.files.urdf + " has a <loop_closure> '" + attribute(closure, "name") +
                         "' without a type or two ends; use <loop_joint> in its place.");
    if (!type || !one || !other) continue;
    loops.closures.push_back({attribute(closure, "name"), {*one, *other}, *type});
  }
  return loops;
}

}  // namespace

DescribedLoops equality(const LoopSource& source, Problems& problems) {
  return closures_in(source, "<equality>", problems);
}

DescribedLoops sdf_joint(const LoopSource& source, Problems& problems) {
  return closures_in(source, "the SDF", problems);
}

}  // namespace parallel_aspects::dialects
