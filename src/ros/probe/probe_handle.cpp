// SPDX-License-Identifier: BSD-3-Clause
#include "ros/probe/probe_handle.h"

#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>
#include <utility>
#include <vector>

namespace parallel_aspects {

using interactive_markers::MenuHandler;
using visualization_msgs::InteractiveMarkerFeedback;
using visualization_msgs::InteractiveMarkerFeedbackConstPtr;

bool has_probe_handle() noexcept { return true; }

/// Its callbacks run in the server's thread.
class ProbeHandle::Server {
 public:
  Server(const std::string& topic, const Manipulator& manipulator, const geometry_msgs::Pose& pose,
         double radius, HandleEvents events)
      : name_("probe"),
        base_frame_(manipulator.base_frame()),
        modes_(working_modes(manipulator)),
        events_(std::move(events)),
        server_(topic, "", true) {
    server_.insert(handle_marker(manipulator, pose, radius),
                   [this](const InteractiveMarkerFeedbackConstPtr& feedback) { hear(*feedback); });
    fill_menu(manipulator);
    menu_.apply(server_, name_);
    server_.applyChanges();
  }

  void move_to(const geometry_msgs::Pose& pose) {
    server_.setPose(name_, pose);
    server_.applyChanges();
  }

  void tick(const WorkingMode& mode, bool others) {
    if (ticked_ == mode && ticked_others_ == others) return;
    ticked_ = mode;
    ticked_others_ = others;
    for (std::size_t i = 0; i < mode_entries_.size(); ++i) set(mode_entries_[i], modes_[i] == mode);
    for (std::size_t j = 0; j < leg_entries_.size(); ++j) set(leg_entries_[j], mode.sign(j) > 0);
    set(others_entry_, others);
    menu_.reApply(server_);
    server_.applyChanges();
  }

 private:
  using Entry = MenuHandler::EntryHandle;
  // More do not fit into a menu that anybody reads: then each leg has an entry.
  static constexpr std::size_t most_modes = 16;

  void set(Entry entry, bool ticked) {
    menu_.setCheckState(entry, ticked ? MenuHandler::CHECKED : MenuHandler::UNCHECKED);
  }

  Entry entry(const std::string& title, const std::function<void()>& action) {
    return menu_.insert(title, [action](const InteractiveMarkerFeedbackConstPtr&) { action(); });
  }

  void fill_menu(const Manipulator& manipulator) {
    const Entry modes = menu_.insert("Working mode");
    if (modes_.size() <= most_modes)
      for (const WorkingMode& mode : modes_)
        mode_entries_.push_back(menu_.insert(
            modes, to_string(mode),
            [this, mode](const InteractiveMarkerFeedbackConstPtr&) { events_.mode_chosen(mode); }));
    else
      for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
        leg_entries_.push_back(
            menu_.insert(modes, manipulator.leg(j).name + " positive",
                         [this, j](const InteractiveMarkerFeedbackConstPtr&) { events_.leg_toggled(j); }));
    for (const Entry each : mode_entries_) set(each, false);
    for (const Entry each : leg_entries_) set(each, true);
    others_entry_ = entry("Show the other working modes", events_.others_toggled);
    set(others_entry_, false);
    entry("Store as start", events_.stored_as_start);
    entry("Store as goal", events_.stored_as_goal);
    entry("Reset to the present pose", events_.reset);
    entry("Hide", events_.hidden);
  }

  void hear(const InteractiveMarkerFeedback& feedback) {
    if (feedback.event_type == InteractiveMarkerFeedback::MOUSE_UP) events_.released();
    if (feedback.event_type != InteractiveMarkerFeedback::POSE_UPDATE) return;
    if (feedback.header.frame_id.empty() || feedback.header.frame_id == base_frame_)
      events_.dragged(feedback.pose);
  }

  const std::string name_, base_frame_;
  const std::vector<WorkingMode> modes_;
  const HandleEvents events_;
  MenuHandler menu_;
  std::vector<Entry> mode_entries_, leg_entries_;
  Entry others_entry_ = 0;
  WorkingMode ticked_;
  bool ticked_others_ = false;
  interactive_markers::InteractiveMarkerServer server_;  // last: its thread ends first
};

ProbeHandle::ProbeHandle(const std::string& topic, const Manipulator& manipulator,
                         const geometry_msgs::Pose& pose, double radius, HandleEvents events)
    : server_(std::make_unique<Server>(topic, manipulator, pose, radius, std::move(events))) {}

ProbeHandle::~ProbeHandle() = default;

void ProbeHandle::move_to(const geometry_msgs::Pose& pose) { server_->move_to(pose); }

void ProbeHandle::tick(const WorkingMode& mode, bool others) { server_->tick(mode, others); }

}  // namespace parallel_aspects
