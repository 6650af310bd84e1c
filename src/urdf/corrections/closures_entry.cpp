// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/closures_entry.h"

#include "urdf/corrections/edit.h"
#include "urdf/description/xml_values.h"

#include <array>
#include <cstddef>
#include <string>

namespace parallel_aspects {
namespace {

// What of a frame its closure sees.
LinkFrame as_seen(LinkFrame frame, ClosureType type) {
  const bool any_axis = type == ClosureType::universal || type == ClosureType::fixed;
  const bool is_upright = (frame.in_link.linear().col(2) - Eigen::Vector3d::UnitZ()).norm() < 1e-9;
  if (type == ClosureType::point || (!any_axis && is_upright)) frame.in_link.linear().setIdentity();
  return frame;
}

std::string written(const Tree& tree, const LinkFrame& frame, const SourceNames& files) {
  const std::string& link = tree.links[frame.link];
  if (frame.in_link.isApprox(Eigen::Isometry3d::Identity())) return link;
  if (files.as_options)
    return placed_name(link, frame.in_link.translation(), roll_pitch_yaw(frame.in_link.linear()));
  return "{link: " + link + ", xyz: " + as_list(frame.in_link.translation()) +
         ", rpy: " + as_list(roll_pitch_yaw(frame.in_link.linear())) + "}";
}

}  // namespace

Note closures_entry(const Tree& tree, const std::vector<Closure>& closures, const SourceNames& files) {
  std::vector<std::string> list;
  for (const Closure& closure : closures) {
    std::array<std::string, 2> ends;
    for (const std::size_t end : {0, 1})
      ends[end] = written(tree, as_seen(closure.frames[end], closure.type), files);
    list.push_back(files.as_options ? ends[0] + "=" + ends[1]
                                    : "{frames: [" + ends[0] + ", " + ends[1] +
                                          "], type: " + std::string(name(closure.type)) + "}");
  }
  if (files.as_options) return files.entry("closures", list);
  return Note(Note::Piece::Kind::closures, list) + " under mechanism in " + files.config;
}

}  // namespace parallel_aspects
