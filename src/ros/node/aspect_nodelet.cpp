// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/aspect_server.h"

#include <memory>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

namespace parallel_aspects {

/// The same server inside a nodelet manager. A bad description makes the manager refuse to load it.
class AspectNodelet : public nodelet::Nodelet {
  void onInit() override {
    try {
      server_ = std::make_unique<AspectServer>(getNodeHandle(), getPrivateNodeHandle());
    } catch (const InvalidDescription& invalid) {
      for (const std::string& problem : invalid.problems()) NODELET_FATAL_STREAM(problem);
      throw;
    }
  }

  std::unique_ptr<AspectServer> server_;
};

}  // namespace parallel_aspects

PLUGINLIB_EXPORT_CLASS(parallel_aspects::AspectNodelet, nodelet::Nodelet)
