// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/panel.h>

namespace parallel_aspects {

/// Table of aspects, distances and buttons for one aspect_node.
class AspectsPanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit AspectsPanel(QWidget* parent = nullptr);
};

}  // namespace parallel_aspects
