// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_RVIZ_PANEL_ON_SCREEN_H
#define PARALLEL_ASPECTS_TEST_RVIZ_PANEL_ON_SCREEN_H

#include "ros/node/node_client.h"
#include "ros/node/process.h"
#include "rviz/panel/aspects_panel.h"

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "rviz/standing_robot.h"
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTabBar>
#include <QTabWidget>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects::test {

/// The panel on a screen, a node of the five-bar in a namespace of its own, and a mouse and a keyboard that
/// X itself moves.
class PanelOnScreen : public testing::Test {
 protected:
  void SetUp() override {
    space_ = std::string("/") + testing::UnitTest::GetInstance()->current_test_info()->name();
    node_ = space_ + "/aspect_node";
    ros::param::set(space_ + "/robot_description", source_file("urdf/five_bar.urdf"));
    set("mechanism", five_bar_mechanism_parameter());
    set("motion/acceleration", std::vector<double>{10.0, 10.0});
    set("joint_states_timeout", 5.0);  // a busy computer holds messages up
    set("tracking/longest_interval", 5.0);
    panel_ = std::make_unique<AspectsPanel>();
    panel_->resize(420, 780);
    panel_->move(0, 0);
    panel_->show();
    panel_->set_node(QString::fromStdString(node_));
  }
  void TearDown() override {
    if (const char* const folder = std::getenv("PARALLEL_ASPECTS_PICTURES"))
      panel_->grab().save(QString("%1/panel_%2.png").arg(folder, space_.substr(1).c_str()));
  }

  template <typename Value>
  void set(const std::string& key, const Value& value) {
    ros::param::set(node_ + "/" + key, value);
  }
  void start_node() { process_ = std::make_unique<Process>(PARALLEL_ASPECTS_NODE, space_); }

  /// Whether it becomes true before the deadline, while the window lives.
  static bool until(const std::function<bool()>& condition) {
    return eventually([&] {
      QApplication::processEvents();
      return condition();
    });
  }

  template <typename Widget>
  Widget& find(const char* name) {
    auto* const widget = panel_->findChild<Widget*>(name);
    EXPECT_NE(widget, nullptr) << name;
    return *widget;
  }
  std::string text(const char* name) { return find<QLabel>(name).text().toStdString(); }
  bool says(const char* name, const std::string& words) {
    return text(name).find(words) != std::string::npos;
  }
  /// Waits until this label says so.
  void expect_says(const char* name, const std::string& words) {
    EXPECT_TRUE(until([&] { return says(name, words); })) << words << " was expected: " << text(name);
  }

  static void xdotool(const std::vector<std::string>& words) {
    Process process("xdotool", "", words);
    EXPECT_TRUE(until([&] { return process.has_ended(); })) << words.front();
  }
  /// Once it is where it stays: a layout that changes takes a few rounds of events.
  void click(QWidget& widget, const QPoint& at) {
    QPoint point;
    int rounds = 0;
    EXPECT_TRUE(until([&] {
      const QPoint now = widget.mapToGlobal(at);
      rounds = widget.isVisible() && widget.isEnabled() && now == point ? rounds + 1 : 0;
      point = now;
      return rounds >= 5;
    })) << widget.objectName().toStdString();
    xdotool({"mousemove", std::to_string(point.x()), std::to_string(point.y()), "click", "1"});
  }
  void click(QWidget& widget) { click(widget, widget.rect().center()); }
  void press(const std::string& key) {
    xdotool({"windowfocus", std::to_string(panel_->winId())});
    xdotool({"key", key});
  }
  void type(const std::string& words) {
    xdotool({"windowfocus", std::to_string(panel_->winId())});
    xdotool({"type", words});
  }
  void open_tab(int index) {
    QTabBar& tabs = *find<QTabWidget>("tabs").tabBar();
    click(tabs, tabs.tabRect(index).center());
    EXPECT_TRUE(until([&] { return tabs.currentIndex() == index; }));
  }
  /// Opens the list and clicks the entry.
  void choose(QComboBox& box, int index) {
    click(box);
    ASSERT_TRUE(until([&] { return box.view()->isVisible(); }));
    const QRect entry = box.view()->visualRect(box.model()->index(index, 0));
    const QPoint point = box.view()->viewport()->mapToGlobal(entry.center());
    xdotool(
        {"mousemove", std::to_string(point.x()), std::to_string(point.y()), "sleep", "0.3", "click", "1"});
    EXPECT_TRUE(until([&] { return box.currentIndex() == index && !box.view()->isVisible(); }));
  }

  std::string space_, node_;
  std::unique_ptr<AspectsPanel> panel_;
  std::unique_ptr<Process> process_;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_RVIZ_PANEL_ON_SCREEN_H
