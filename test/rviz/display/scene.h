// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_RVIZ_SCENE_H
#define PARALLEL_ASPECTS_TEST_RVIZ_SCENE_H

#include "ros/node/process.h"

#include <Eigen/Core>

#include <OgreCamera.h>
#include <OgreViewport.h>
#include <QApplication>
#include <functional>
#include <memory>
#include <rviz/display.h>
#include <rviz/render_panel.h>
#include <rviz/tool_manager.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>
#include <string>

namespace parallel_aspects::test {

/// The scene of rviz in a window of this process, with a mouse that X itself moves.
class Scene {
 public:
  Scene(int width, int height) : panel_(new rviz::RenderPanel) {
    panel_->setWindowFlags(Qt::FramelessWindowHint);
    panel_->resize(width, height);
    panel_->move(0, 0);
    panel_->show();
    manager_ = std::make_unique<rviz::VisualizationManager>(panel_.get());
    panel_->initialize(manager_->getSceneManager(), manager_.get());
    manager_->initialize();
    manager_->startUpdate();
    rviz::ToolManager& tools = *manager_->getToolManager();
    tools.setCurrentTool(tools.addTool("rviz/Interact"));
  }
  ~Scene() { manager_.reset(); }  // before its window
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  rviz::VisualizationManager& manager() { return *manager_; }
  rviz::ViewController& view(const QString& type) {
    manager_->getViewManager()->setCurrentViewControllerType(type);
    return *manager_->getViewManager()->getCurrent();
  }

  /// Whether it becomes true before the deadline, while the window lives.
  static bool until(const std::function<bool()>& condition) {
    return eventually([&] {
      QApplication::processEvents();
      return condition();
    });
  }

  /// What a status line of a display says; empty where there is no such line.
  static std::string status(rviz::Display& display, const QString& line) {
    for (int i = 0; i < display.numChildren(); ++i)
      if (rviz::Property* const list = display.childAt(i); list->getNameStd().find(':') != std::string::npos)
        for (int j = 0; j < list->numChildren(); ++j)
          if (list->childAt(j)->getName() == line)
            return list->childAt(j)->getValue().toString().toStdString();
    return {};
  }

  /// Where a point of the fixed frame is on the screen [px].
  QPoint pixel(const Eigen::Vector3d& point) const {
    const Ogre::Camera& camera = *panel_->getCamera();
    const Ogre::Vector4 seen = camera.getProjectionMatrix() *
                               (camera.getViewMatrix(true) *
                                Ogre::Vector4(static_cast<float>(point.x()), static_cast<float>(point.y()),
                                              static_cast<float>(point.z()), 1.0F));
    return panel_->mapToGlobal(QPoint(static_cast<int>(0.5 * (1.0 + seen.x / seen.w) * panel_->width()),
                                      static_cast<int>(0.5 * (1.0 - seen.y / seen.w) * panel_->height())));
  }

  /// Gives the mouse and the scene as many frames as they need to find each other.
  void move_mouse(const QPoint& to) {
    xdotool({"mousemove", std::to_string(to.x()), std::to_string(to.y())});
    draw(3);
  }
  void press_mouse() { xdotool({"mousedown", "1"}); }
  void release_mouse() { xdotool({"mouseup", "1"}); }
  void click(const QPoint& at) {
    move_mouse(at + QPoint(2, 2));
    move_mouse(at);
    press_mouse();
    draw(1);
    release_mouse();
    draw(1);
  }
  void drag(const QPoint& from, const QPoint& to, int steps) {
    move_mouse(from + QPoint(2, 2));
    move_mouse(from);
    press_mouse();
    for (int i = 1; i <= steps; ++i) move_mouse(from + (to - from) * i / steps);
    release_mouse();
    draw(1);
  }

  /// Waits for so many frames more.
  void draw(std::uint64_t frames) {
    const std::uint64_t end = manager_->getFrameCount() + frames;
    manager_->queueRender();
    EXPECT_TRUE(until([&] {
      if (manager_->getFrameCount() >= end) return true;
      manager_->queueRender();
      return false;
    }));
  }

 private:
  static void xdotool(const std::vector<std::string>& words) {
    Process process("xdotool", "", words);
    EXPECT_TRUE(until([&] { return process.has_ended(); })) << words.front();
  }

  std::unique_ptr<rviz::RenderPanel> panel_;
  std::unique_ptr<rviz::VisualizationManager> manager_;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_RVIZ_SCENE_H
