// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel/aspects_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <pluginlib/class_list_macros.hpp>

namespace parallel_aspects {

AspectsPanel::AspectsPanel(QWidget* parent) : rviz::Panel(parent) {
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(new QLabel("Waits for a node."));
}

}  // namespace parallel_aspects

PLUGINLIB_EXPORT_CLASS(parallel_aspects::AspectsPanel, rviz::Panel)
