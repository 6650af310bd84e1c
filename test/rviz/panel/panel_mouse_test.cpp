// SPDX-License-Identifier: BSD-3-Clause
//
// The panel beside a running node, used by mouse and keyboard on a screen in memory. What is checked are the
// messages that go out and what the panel says.
#include "model/message_text.h"
#include "rviz/panel/painted_widgets.h"
#include "rviz/panel/panel_on_screen.h"
#include "rviz/panel/screen.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/AssemblyCandidates.h>
#include <parallel_aspects/GetSingularityDistance.h>
#include <parallel_aspects/Status.h>

#include <nlohmann/json.hpp>

#include <QCheckBox>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QTreeWidget>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nav_msgs/Path.h>
#include <std_msgs/Int8MultiArray.h>
#include <std_msgs/UInt32.h>
#include <std_msgs/UInt32MultiArray.h>
#include <trajectory_msgs/JointTrajectory.h>

namespace parallel_aspects {
namespace {

using test::PanelOnScreen;
using test::Recorder;

const Pose above = test::pose_at(4.5, 8.0);
const std::vector<int> its_signs{1, -1};

/// The five-bar there.
class StandingRobot : public test::StandingRobot {
 public:
  StandingRobot(const std::string& space, const Pose& pose, const std::vector<int>& signs)
      : test::StandingRobot(space, *test::five_bar_mechanism()->manipulator(), pose, signs) {}
};

// What the command prints.
nlohmann::json command_says(const std::string& arguments) {
  setenv("PARALLEL_ASPECTS_SHARE", PARALLEL_ASPECTS_SOURCE_DIR, 1);
  FILE* const pipe = popen((std::string(PARALLEL_ASPECTS_COMMAND) + " " + arguments).c_str(), "r");
  std::string text;
  for (int letter = std::fgetc(pipe); letter != EOF; letter = std::fgetc(pipe))
    text += static_cast<char>(letter);
  pclose(pipe);
  return nlohmann::json::parse(text, nullptr, false);
}

class PanelMouse : public PanelOnScreen {
 protected:
  QTreeWidget& tree() { return find<QTreeWidget>("aspects"); }

  // Of the aspect with this id.
  QTreeWidgetItem* row(unsigned id) {
    for (int i = 0; i < tree().topLevelItemCount(); ++i)
      for (int j = 0; j < tree().topLevelItem(i)->childCount(); ++j)
        if (QTreeWidgetItem* const item = tree().topLevelItem(i)->child(j);
            item->data(0, Qt::UserRole).toUInt() == id)
          return item;
    return nullptr;
  }
  bool has_aspects(unsigned count) {
    return until([&] { return row(count) != nullptr && row(count + 1) == nullptr; });
  }
  bool has_present() {
    return until([&] {
      for (unsigned id = 1; row(id) != nullptr; ++id)
        if (row(id)->text(0).contains("\u25C0")) return true;
      return false;
    });
  }
  void follow_robot() {
    set("start/pose", std::vector<double>{4.5, 8.0});
    start_node();
    expect_says("state_title", "NO THRESHOLD");
    ASSERT_TRUE(has_aspects(10));
  }
};

TEST_F(PanelMouse, WaitsForANodeAndOutlivesIt) {
  expect_says("state_text", "Waits for " + node_);
  EXPECT_EQ(text("state_title"), "WAITING");
  start_node();
  expect_says("state_title", "NO JOINT STATES");
  ASSERT_TRUE(has_aspects(10));
  process_->signal(SIGKILL);
  expect_says("state_title", "WAITING");
  start_node();
  expect_says("state_title", "NO JOINT STATES");
  EXPECT_TRUE(has_aspects(10));
}

// Those of two robots, in a window as high as the screen.
TEST_F(PanelMouse, FitsBelowAnother) {
  EXPECT_LT(panel_->minimumSizeHint().height(), 300);
  panel_->resize(420, 400);
  const auto* const area = panel_->findChild<QScrollArea*>();
  ASSERT_NE(area, nullptr);
  ASSERT_TRUE(until([&] { return area->verticalScrollBar()->maximum() > 0; }));
  // The wheel scrolls the panel, and does not choose a tab on the way.
  QTabBar& tabs = *find<QTabWidget>("tabs").tabBar();
  const QPoint over = tabs.mapToGlobal(tabs.rect().center());
  xdotool({"mousemove", std::to_string(over.x()), std::to_string(over.y()), "click", "5"});
  EXPECT_TRUE(until([&] { return area->verticalScrollBar()->value() > 0; }));
  EXPECT_EQ(tabs.currentIndex(), 0);
}

TEST_F(PanelMouse, ClosesAtAnyTime) {
  start_node();
  for (int i = 0; i < 20; ++i) {
    panel_ = std::make_unique<AspectsPanel>();
    panel_->show();
    panel_->set_node(QString::fromStdString(node_));
    for (int j = 0; j < i; ++j) QApplication::processEvents(QEventLoop::AllEvents, 5);
  }
  expect_says("state_title", "NO JOINT STATES");
}

TEST_F(PanelMouse, AClickChoosesACandidate) {
  const StandingRobot robot(space_, above, its_signs);
  const Recorder<AspectState> states(node_ + "/state");
  const Recorder<AssemblyCandidates> candidates(node_ + "/candidates");
  start_node();
  ASSERT_TRUE(until([&] { return candidates.last() && candidates.last()->candidates.size() == 2; }));
  ASSERT_TRUE(until([&] { return panel_->findChild<QPushButton*>("candidate_1") != nullptr; }));
  expect_says("candidate_text", "Click the one");
  EXPECT_EQ(text("state_text"), states.last()->status.message);
  const auto list = candidates.last()->candidates;
  const std::size_t which = std::abs(list[0].pose.position.y - 8.0) < 0.01 ? 0 : 1;
  auto& button = find<QPushButton>(which == 0 ? "candidate_0" : "candidate_1");
  EXPECT_TRUE(button.text().contains("x 4.5, y 8")) << button.text().toStdString();
  EXPECT_NE(text("state_title"), "NO THRESHOLD");
  click(button);
  ASSERT_TRUE(until([&] { return states.last()->status.code == Status::OK; })) << text("last_answer");
  EXPECT_EQ(states.last()->determinant_sign, list[which].determinant_sign);
  EXPECT_NEAR(states.last()->pose.position.y, 8.0, 1e-6);
  expect_says("state_title", "NO THRESHOLD");
  EXPECT_TRUE(until([&] { return panel_->findChild<QPushButton*>("candidate_0") == nullptr; }));
}

TEST_F(PanelMouse, ReadOnlyRefusesWithItsReason) {
  const StandingRobot robot(space_, above, its_signs);
  set("read_only", true);
  start_node();
  ASSERT_TRUE(until([&] { return panel_->findChild<QPushButton*>("candidate_0") != nullptr; }));
  for (const char* name : {"candidate_0", "map_button"}) {
    auto& button = find<QPushButton>(name);
    EXPECT_TRUE(until([&] { return !button.isEnabled(); })) << name;
    EXPECT_TRUE(button.toolTip().contains("read-only")) << button.toolTip().toStdString();
  }
}

// The sizes of the aspects, and what is measured where the robot is.
TEST_F(PanelMouse, SaysWhatTheCommandSays) {
  const StandingRobot robot(space_, above, its_signs);
  follow_robot();
  EXPECT_TRUE(has_present());
  const nlohmann::json map = command_says("map five_bar --json");
  ASSERT_EQ(map["aspects"].size(), 10U);
  for (const nlohmann::json& aspect : map["aspects"]) {
    const QTreeWidgetItem& item = *row(aspect["id"].get<unsigned>());
    EXPECT_EQ(item.text(1).toStdString(), aspect["determinant_sign"].get<int>() > 0 ? "> 0" : "< 0");
    EXPECT_EQ(item.text(2).toStdString(), number_text(aspect["measure"].get<double>(), 3));
    EXPECT_EQ(item.text(3).toStdString(), number_text(aspect["deepest_clearance"].get<double>(), 2));
    EXPECT_TRUE(until([&] { return !item.text(4).isEmpty(); }));
  }
  expect_says("count", std::to_string(map["proved_count"].get<int>()));
  const auto located =
      test::ask<GetSingularityDistance>(node_ + "/get_singularity_distance", Configuration());
  const unsigned present = located.reports.at(0).configuration.aspect;
  EXPECT_TRUE(row(present)->text(0).contains("\u25C0"));
  expect_says("state_text", "Aspect " + std::to_string(present) + ", (+,-)");
}

TEST_F(PanelMouse, ABoxHidesAnAspect) {
  const Recorder<std_msgs::UInt32MultiArray> shown(node_ + "/shown_aspects");
  start_node();
  ASSERT_TRUE(has_aspects(10));
  QTreeWidgetItem& item = *row(3);
  tree().scrollToItem(&item);
  const QRect place = tree().visualItemRect(&item);
  click(*tree().viewport(), QPoint(place.left() + 9, place.center().y()));
  ASSERT_TRUE(until([&] { return shown.last().has_value(); }));
  EXPECT_EQ(shown.last()->data, (std::vector<std::uint32_t>{1, 2, 4, 5, 6, 7, 8, 9, 10}));
  click(*tree().viewport(), QPoint(place.left() + 9, place.center().y()));
  EXPECT_TRUE(until([&] { return shown.last()->data.size() == 10; }));
}

// What the display publishes where somebody clicks a surface.
TEST_F(PanelMouse, AnAspectThatIsClickedInTheDisplayIsSelected) {
  ros::Publisher clicks = ros::NodeHandle().advertise<std_msgs::UInt32>(node_ + "/selected_aspect", 1, true);
  start_node();
  ASSERT_TRUE(has_aspects(10));
  std_msgs::UInt32 click;
  for (const unsigned id : {3U, 8U}) {
    click.data = id;
    clicks.publish(click);
    EXPECT_TRUE(until([&] { return row(id)->isSelected(); })) << id;
    EXPECT_EQ(tree().selectedItems().size(), 1);
  }
}

// From one working mode to another through a gate; then back and forth along the path.
TEST_F(PanelMouse, PlansScrubsAndPublishes) {
  const StandingRobot robot(space_, above, its_signs);
  const Recorder<nav_msgs::Path> paths(node_ + "/planned_path");
  const Recorder<geometry_msgs::Pose> poses(node_ + "/probe/set_pose");
  const Recorder<std_msgs::Int8MultiArray> modes(node_ + "/probe/working_mode");
  const Recorder<trajectory_msgs::JointTrajectory> published("/controller/command");
  follow_robot();
  open_tab(1);
  auto& plan = find<QPushButton>("plan");
  EXPECT_TRUE(until([&] { return !plan.isEnabled() && plan.toolTip().contains("goal"); }));
  const Recorder<AspectState> states(node_ + "/state");
  ASSERT_TRUE(until([&] { return states.last() && states.last()->aspect > 0; }));
  int goal = 1;  // of the list: an aspect of another mode and the same sign
  auto& goals = find<QComboBox>("goal");
  ASSERT_TRUE(until([&] { return goals.count() == 11; }));
  while (row(goals.itemData(goal).toUInt())->text(1) !=
             (states.last()->determinant_sign > 0 ? "> 0" : "< 0") ||
         goals.itemData(goal).toUInt() == states.last()->aspect)
    ++goal;
  choose(goals, goal);
  choose(find<QComboBox>("policy"), 1);
  click(find<QCheckBox>("in_time"), QPoint(8, find<QCheckBox>("in_time").height() / 2));
  click(plan);
  expect_says("answer", "Proved path");
  EXPECT_TRUE(says("answer", "Changes of posture: ")) << text("answer");
  ASSERT_TRUE(until([&] { return paths.last().has_value(); }));
  const auto path = paths.last()->poses;
  auto& slider = find<PathSlider>("slider");
  ASSERT_FALSE(slider.marks().empty());
  ASSERT_TRUE(until([&] { return poses.last().has_value(); }));
  EXPECT_EQ(*poses.last(), path.front().pose);
  click(slider, QPoint(slider.width() / 2, slider.height() / 2));
  EXPECT_TRUE(until([&] { return slider.value() > 400 && slider.value() < 600; })) << slider.value();
  press("End");
  EXPECT_TRUE(until([&] { return *poses.last() == path.back().pose; }));
  EXPECT_NE(modes.last()->data, modes.all().front().data) << "it went through a gate";
  press("Home");
  EXPECT_TRUE(until([&] { return *poses.last() == path.front().pose; }));
  const std::size_t before = poses.all().size();
  click(find<QPushButton>("play"));
  EXPECT_TRUE(until([&] { return *poses.last() == path.back().pose; }));
  EXPECT_GT(poses.all().size(), before + 5);

  auto& publish = find<QPushButton>("publish");
  EXPECT_FALSE(publish.isEnabled()) << "the topic is empty";
  click(find<QLineEdit>("topic"));
  type("/controller/command");
  EXPECT_TRUE(until([&] { return find<QLineEdit>("topic").text() == "/controller/command"; }));
  click(publish);
  expect_says("last_answer", "Published once on /controller/command.");
  ASSERT_TRUE(until([&] { return published.last().has_value(); }));
  EXPECT_GT(published.last()->points.size(), 2U);
  EXPECT_EQ(published.all().size(), 1U);
}

// A map that takes a margin is computed first.
TEST_F(PanelMouse, PlansWithAMargin) {
  const StandingRobot robot(space_, above, its_signs);
  follow_robot();
  open_tab(1);
  auto& goals = find<QComboBox>("goal");
  ASSERT_TRUE(until([&] { return goals.count() == 11; }));
  const Recorder<AspectState> states(node_ + "/state");
  ASSERT_TRUE(until([&] { return states.last() && states.last()->aspect > 0; }));
  choose(goals, goals.findData(states.last()->aspect));
  click(find<QWidget>("margin"), QPoint(20, 10));
  press("ctrl+a");
  type("0.1");
  press("Tab");
  click(find<QPushButton>("plan"));
  expect_says("answer", "Proved path");
  const std::string answer = text("answer");
  EXPECT_GE(std::stod(answer.substr(answer.find("Least index ") + 12)), 0.1) << answer;
}

TEST_F(PanelMouse, CancelsTheFirstMap) {
  set("map/resolution", 0.0001);  // takes a minute: on a busy machine a click is late
  set("map/threads", 1);
  start_node();
  auto& button = find<QPushButton>("map_button");
  ASSERT_TRUE(until([&] { return button.text() == "Cancel" && button.isEnabled(); }));
  int rounds = 0;
  EXPECT_TRUE(until([&] {
    if (rounds++ % 400 == 0 && button.text() == "Cancel") click(button);  // again, where the first was missed
    return says("map_text", "cancelled");
  })) << text("map_text");
  EXPECT_TRUE(until([&] { return button.text() == "Compute map anew"; }));
}

}  // namespace
}  // namespace parallel_aspects

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const parallel_aspects::test::Screen screen;
  if (!screen.is_there()) {
    std::fputs("Xvfb cannot be started.\n", stderr);
    return EXIT_FAILURE;
  }
  QApplication application(argc, argv);
  ros::init(argc, argv, "panel_mouse_test");
  const ros::NodeHandle nh;
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
