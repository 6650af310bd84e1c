// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/link/node_ping.h"

namespace parallel_aspects {
namespace {

constexpr std::chrono::milliseconds between_pings(1000);

}  // namespace

NodePing::NodePing(const std::string& node) {
  worker_.post([this, service = node + "/list_aspects"] {
    do answers_ = ros::service::exists(service, false);
    while (worker_.sleep(between_pings));
  });
}

}  // namespace parallel_aspects
