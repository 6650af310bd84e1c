// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/display.h>

namespace parallel_aspects {

/// The map of one aspect_node, drawn as surfaces.
class AspectsDisplay : public rviz::Display {
  Q_OBJECT

 protected:
  void onInitialize() override;
};

}  // namespace parallel_aspects
