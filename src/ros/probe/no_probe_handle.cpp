// SPDX-License-Identifier: BSD-3-Clause
//
// In place of probe_handle.cpp where interactive_markers is not there.
#include "ros/probe/probe_handle.h"

namespace parallel_aspects {

bool has_probe_handle() noexcept { return false; }

class ProbeHandle::Server {};

ProbeHandle::ProbeHandle(const std::string&, const Manipulator&, const geometry_msgs::Pose&, double,
                         HandleEvents) {}

ProbeHandle::~ProbeHandle() = default;

void ProbeHandle::move_to(const geometry_msgs::Pose&) {}

void ProbeHandle::tick(const WorkingMode&, bool) {}

}  // namespace parallel_aspects
