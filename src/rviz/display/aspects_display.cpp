// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/aspects_display.h"

#include "draw/scene/placed_labels.h"
#include "model/message_text.h"
#include "ros/messages/conversions.h"
#include "rviz/display/picture_thread.h"

#include "rviz/shapes/ogre_shapes.h"
#include <OgreSceneNode.h>
#include <algorithm>
#include <cmath>
#include <pluginlib/class_list_macros.hpp>
#include <rviz/display_context.h>
#include <rviz/display_group.h>
#include <rviz/frame_manager.h>
#include <rviz/properties/bool_property.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/string_property.h>

namespace parallel_aspects {
namespace {

using Level = rviz::StatusProperty;

constexpr float between_sections = 0.2F;  // that follow the robot [s]
constexpr double volume_step = 0.1;       // that the robot turns until its volume is mapped anew [rad]
constexpr float between_looks = 0.1F;     // at what the node says [s]

std::optional<WorkingMode> mode_of(const std::vector<std::int8_t>& signs) {
  return WorkingMode::from_signs({signs.begin(), signs.end()});
}

// By itself rviz reads each description once.
void reload_robot_models(rviz::DisplayContext& context) {
  rviz::DisplayGroup* const root = context.getRootDisplayGroup();
  for (int i = 0; i < root->numDisplays(); ++i) {
    rviz::Display* const display = root->getDisplayAt(i);
    if (display->getClassId() != "rviz/RobotModel" || !display->isEnabled()) continue;
    display->setEnabled(false);
    display->setEnabled(true);
  }
}

QString text(const std::string& words) { return QString::fromStdString(words); }

}  // namespace

AspectsDisplay::AspectsDisplay() : listeners_(section_mouse()) {
  node_ = new rviz::StringProperty("Node", "aspect_node", "Name of the aspect_node whose map is drawn.", this,
                                   SLOT(follow_node()));
  shown_ = new rviz::EnumProperty("Shown", "Present working mode",
                                  "Which aspects are drawn; the present ones follow the robot.", this);
  shown_->addOption("Present working mode", static_cast<int>(Shown::present_mode));
  shown_->addOption("Present aspect", static_cast<int>(Shown::present_aspect));
  shown_->addOption("Chosen", static_cast<int>(Shown::chosen));
  shown_->addOption("All", static_cast<int>(Shown::all));
  chosen_ = new rviz::StringProperty(
      "Chosen", "",
      "Ids and working modes, as '1 4 (+,-)', drawn where Shown is Chosen; where it is "
      "empty, those ticked in the panel.",
      this);
  section_ = new rviz::EnumProperty("Section", "At the robot",
                                    "Cuts surfaces by a plane, so that their inside shows.", this);
  section_->addOption("None", static_cast<int>(Section::none));
  section_->addOption("At the robot", static_cast<int>(Section::at_robot));
  section_->addOption("At offset", static_cast<int>(Section::at_offset));
  axis_ = new rviz::EnumProperty("Axis", "z or phi", "What the section is across.", section_);
  axis_->addOption("x", 0);
  axis_->addOption("y", 1);
  axis_->addOption("z or phi", 2);
  offset_ = new rviz::FloatProperty("Offset", 0.0F, "Value of that coordinate at the section [m or rad].",
                                    section_);
  upper_ = new rviz::BoolProperty("Upper part", false, "Draws what lies above the section.", section_);
  opacity_ = new rviz::FloatProperty("Opacity", 0.45F, "Of the aspects that the robot is not in.", this,
                                     SLOT(change_look()));
  present_opacity_ = new rviz::FloatProperty("Opacity of the present aspect", 0.8F,
                                             "Of the aspect that the robot is in, and of sections.", this,
                                             SLOT(change_look()));
  for (rviz::FloatProperty* const opacity : {opacity_, present_opacity_}) {
    opacity->setMin(0.0F);
    opacity->setMax(1.0F);
  }
  boundaries_ =
      new rviz::BoolProperty("Colour boundaries", true,
                             "Tints surfaces by what the aspect ends at: parallel singularities red, serial "
                             "ones blue, limits grey.",
                             this);
  ids_ = new rviz::BoolProperty("Ids", true, "Writes the ids of the aspects.", this, SLOT(change_look()));
  legend_ = new rviz::BoolProperty("Legend", true, "Says what the colours are.", this, SLOT(change_look()));
  nearest_ = new rviz::BoolProperty("Nearest singularity", true,
                                    "Draws the way to the nearest singularity that was found.", this);
  joint_space_ = new rviz::BoolProperty(
      "Joint space", false,
      "Draws the same aspects in the space of the actuated joints, beside the robot, with the same point.",
      this);
  gallery_ = new rviz::BoolProperty(
      "Gallery", false, "Draws every working mode beside the robot; with Joint space, that of each.", this);
  reload_ = new rviz::BoolProperty("Reload robot models", true,
                                   "Loads the robot models of this window anew where the node has another "
                                   "robot than before.",
                                   this);
  radian_ = new rviz::FloatProperty("Length of a radian", 0.0F,
                                    "How long angles are drawn [m]; 0 for what suits the robot.", this);
  radian_->setMin(0.0F);
}

AspectsDisplay::~AspectsDisplay() { stop(); }

void AspectsDisplay::onInitialize() { setStatus(Level::Warn, "Node", "Not searched yet."); }

void AspectsDisplay::onEnable() { follow_node(); }

void AspectsDisplay::onDisable() { stop(); }

void AspectsDisplay::reset() {
  rviz::Display::reset();
  if (isEnabled()) follow_node();
}

void AspectsDisplay::stop() {
  link_.reset();
  thread_.reset();
  forget_picture();
  robot_.reset();
  map_.reset();
  present_.reset();
  candidates_.clear();
  candidate_ids_.clear();
  asked_.reset();
  asked_at_.reset();
  volume_at_.reset();
  news_ = {};
  maps_ = starts_ = robots_ = 0;
}

void AspectsDisplay::forget_picture() {
  drawn_.reset();
  picture_.reset();
  points_.clear();
  mark_.clear();
  mode_.reset();
  selected_ = 0;
  deleteStatus("Selected");
}

void AspectsDisplay::follow_node() {
  if (!initialized() || !isEnabled()) return;
  stop();
  link_ = std::make_unique<NodeLink>(threaded_nh_, node_->getStdString());
  thread_ = std::make_unique<PictureThread>(threaded_nh_, link_->name());
  setStatus(Level::Warn, "Node", text("Waits for " + link_->name() + "."));
  setStatus(Level::Warn, "Map", "Waits for the node.");
}

void AspectsDisplay::update(float wall_dt, float) {
  if (!link_) return;
  since_look_ += wall_dt;
  since_picture_ += wall_dt;
  if (since_look_ >= between_looks) {
    since_look_ = 0.0F;
    take_news();
    const PictureThread::Result result = thread_->result();
    take_picture(result);
    take_state();
    tell(result);
    ask_for_volume(result);
    ask_for_picture();
  }
  if (robot_) place();
}

void AspectsDisplay::take_news() {
  news_ = link_->news();
  if (!news_.is_there) {
    setStatus(Level::Warn, "Node", text("Waits for " + link_->name() + "."));
  } else {
    setStatus(Level::Ok, "Node", text(link_->name()));
  }
  if (news_.maps != maps_ || news_.starts != starts_) {
    maps_ = news_.maps;
    starts_ = news_.starts;
    thread_->fetch();
  }
}

// Candidates are drawn before there is a map, too.
void AspectsDisplay::take_state() {
  present_.reset();
  candidates_.clear();
  candidate_ids_.clear();
  if (!robot_ || !news_.state) return;
  const Manipulator& robot = robot_->manipulator();
  if (news_.state->status.code == Status::OK) {
    present_ = pose_from_base(robot, news_.state->pose);
    if (const auto mode = mode_of(news_.state->working_mode)) mode_ = mode;
    return;
  }
  const auto& candidates = news_.candidates.candidates;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const SolvedConfiguration& each = candidates[i];
    const auto pose = pose_from_base(robot, each.pose);
    const auto mode = mode_of(each.working_mode);
    if (!pose || !mode) continue;
    candidates_.push_back({*pose, *mode, i});
    const int aspect = map_ ? map_->locate(*pose, *mode) : 0;
    if (aspect != 0) candidate_ids_.insert(aspect);
  }
}

void AspectsDisplay::tell(const PictureThread::Result& result) {
  const std::string said = news_.progress ? news_.progress->message : "";
  const auto level = !result.problem.empty() ? Level::Error : result.map ? Level::Ok : Level::Warn;
  setStatus(level, "Map", text(words_of(result, said)));
  tell_robot();
}

void AspectsDisplay::tell_robot() {
  const bool follows = shown_->getOptionInt() == static_cast<int>(Shown::present_mode) ||
                       shown_->getOptionInt() == static_cast<int>(Shown::present_aspect);
  if (!news_.is_there || !news_.state) return setStatus(Level::Warn, "Robot", "No state of it has come yet.");
  if (news_.state->status.code == Status::OK)
    return setStatus(Level::Ok, "Robot", text("In aspect " + std::to_string(news_.state->aspect)));
  std::string words = news_.state->status.message;
  if (map_ && follows) words += " " + words_of_unknown(candidate_ids_, mode_.has_value());
  setStatus(Level::Warn, "Robot", text(words));
}

// Six degrees of freedom: what is drawn is mapped here, and again when the robot has turned.
void AspectsDisplay::ask_for_volume(const PictureThread::Result& result) {
  if (!result.has_volumes || !news_.state || news_.state->status.code != Status::OK) return;
  if (thread_->is_mapping()) return;
  const geometry_msgs::Quaternion& q = news_.state->pose.orientation;
  const Eigen::Quaterniond orientation =
      present_ ? present_->orientation : Eigen::Quaterniond(q.w, q.x, q.y, q.z);
  const auto mode = mode_of(news_.state->working_mode);
  if (!mode || !(orientation.norm() > 0.5)) return;
  if (volume_at_ && volume_mode_ == mode &&
      volume_at_->orientation.angularDistance(orientation) <= volume_step)
    return;
  volume_at_.emplace();
  volume_at_->orientation = orientation;
  volume_mode_ = mode;
  thread_->map_volume(orientation, *mode);
}

void AspectsDisplay::take_picture(const PictureThread::Result& result) {
  robot_ = result.robot;
  if (result.robots != robots_) {
    robots_ = result.robots;
    volume_at_.reset();
    if (reload_->getBool()) reload_robot_models(*context_);
  }
  if (result.map != map_) {
    map_ = result.map;
    asked_.reset();
    if (!result.has_volumes || !map_) forget_picture();  // a volume is drawn until the next one is
  }
  if (!map_ || !result.picture || result.picture == picture_) return;
  picture_ = result.picture;
  drawn_ = std::make_unique<DrawnPicture>(*picture_, look(), context_, scene_node_, listeners_);
  context_->queueRender();
}

PictureChoice AspectsDisplay::choice() const {
  PictureChoice choice;
  choice.shown = static_cast<Shown>(shown_->getOptionInt());
  const std::string words = chosen_->getStdString();
  std::string problem;
  if (!words.empty())
    choice.chosen = chosen_aspects(*map_->map, words, problem);
  else if (news_.shown)
    choice.chosen = *news_.shown;
  else
    for (const Aspect& each : map_->map->aspects()) choice.chosen.insert(each.id);
  if (present_ && news_.state) {
    choice.aspect = static_cast<int>(news_.state->aspect);
    if (map_->map->slice() && mode_) choice.aspect = map_->locate(*present_, *mode_);
  }
  if (candidates_.empty() && mode_) choice.modes = {*mode_};
  for (const PresentPoints::Configuration& each : candidates_)
    if (std::find(choice.modes.begin(), choice.modes.end(), each.mode) == choice.modes.end())
      choice.modes.push_back(each.mode);
  choice.candidates = candidate_ids_;
  std::vector<Pose> poses;
  for (const PresentPoints::Configuration& each : candidates_) poses.push_back(each.pose);
  choice.names = candidate_places(robot_->manipulator(), poses, robot_->scene.radius);
  choice.joint_space = joint_space_->getBool();
  choice.gallery = gallery_->getBool();
  choice.robot = robot_->scene.robot;
  choice.reach = robot_->scene.reach;
  choice.seen = seen_height(robot_->scene);
  choice.section = static_cast<Section>(section_->getOptionInt());
  choice.axis = static_cast<std::size_t>(axis_->getOptionInt());
  choice.offset = offset_->getFloat();
  choice.upper = upper_->getBool();
  choice.tells_boundaries = boundaries_->getBool();
  choice.radian = radian_->getFloat();
  return choice;
}

bool AspectsDisplay::differs(const PictureChoice& choice) const {
  if (!asked_ || !is_same(*asked_, choice)) return true;
  if (choice.section != Section::at_robot || !present_) return false;
  if (!asked_at_) return true;
  const TaskSpace space = map_->map->manipulator()->task_space();
  return std::abs(section_value(space, *present_, choice.axis) -
                  section_value(space, *asked_at_, choice.axis)) > section_step(*map_->map, choice.axis);
}

// One at a time, so that a robot that moves fast is not always drawn and never seen.
void AspectsDisplay::ask_for_picture() {
  if (!map_) return;
  const PictureChoice wanted = choice();
  where_ = where_words(wanted, map_->map->manipulator()->task_space());
  std::string problem;
  if (wanted.shown == Shown::chosen) chosen_aspects(*map_->map, chosen_->getStdString(), problem);
  if (problem.empty())
    deleteStatus("Chosen");
  else
    setStatus(Level::Error, "Chosen", text(problem));
  if (!differs(wanted) || (asked_ && thread_->is_drawing())) return;
  if (asked_ && is_same(*asked_, wanted) && since_picture_ < between_sections) return;  // it only moved
  since_picture_ = 0.0F;
  asked_ = wanted;
  asked_at_ = present_;
  thread_->draw(wanted, present_);
}

// Where the base of the robot is, and in it the picture.
void AspectsDisplay::place() {
  const Manipulator& robot = robot_->manipulator();
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
  if (!context_->getFrameManager()->getTransform(robot_->base_frame, ros::Time(), position, orientation)) {
    setStatus(Level::Error, "Frame",
              text("No transform from " + robot_->base_frame + " to " + fixed_frame_.toStdString() + "."));
    return;
  }
  deleteStatus("Frame");
  const Eigen::Isometry3d drawn = drawing_frame(robot);
  placement_ = placement(robot, present_, picture_ ? picture_->radian : 1.0);
  scene_node_->setPosition(position + orientation * ogre_vector(drawn.translation()));
  scene_node_->setOrientation(orientation * ogre_rotation(drawn.linear()));
  if (drawn_) drawn_->set_placement(ogre_vector(placement_));
  place_robot();
}

// Its points in the picture, and the way from it to the nearest singularity.
void AspectsDisplay::place_robot() {
  const Manipulator& robot = robot_->manipulator();
  const PresentPoints::Place place{scene_manager_, scene_node_};
  auto shown = candidates_;
  if (present_ && mode_) shown = {{*present_, *mode_}};
  // A window can show a model of the robot, but not of all that it may be.
  points_.show_skeletons(robot, robot_->scene.radius,
                         robot_->has_visuals && present_ ? PresentPoints::Configurations() : shown, place);
  if (!picture_) {
    points_.clear_dots();
    return mark_.clear();
  }
  points_.show(*picture_, robot, placement_, shown, place);
  if (present_ && mode_ && nearest_->getBool())
    mark_.show(*picture_, map_->map->manipulator(), placement_, {*present_, *mode_}, place);
  else
    mark_.clear();
  if (drawn_) drawn_->set_head(where_ + (mark_.words().empty() ? "" : "\n" + mark_.words()));
}

// Faces of a section are dragged across, and stay where they are left; a click on any surface selects.
SurfaceMouse AspectsDisplay::section_mouse() {
  SurfaceMouse mouse;
  mouse.taken = [this] {
    taken_offset_ = offset_->getFloat();
    if (!map_ || static_cast<Section>(section_->getOptionInt()) != Section::at_robot || !asked_at_) return;
    taken_offset_ = section_value(map_->map->manipulator()->task_space(), *asked_at_,
                                  static_cast<std::size_t>(axis_->getOptionInt()));
  };
  mouse.dragged = [this](double distance) {
    if (!map_ || !picture_) return;
    const double unit = section_unit(map_->map->manipulator()->task_space(),
                                     static_cast<std::size_t>(axis_->getOptionInt()), picture_->radian);
    offset_->setFloat(static_cast<float>(taken_offset_ + distance / unit));
    section_->setStdString("At offset");
  };
  mouse.across = [this] {
    Ogre::Vector3 axis(0.0F, 0.0F, 0.0F);
    axis[static_cast<std::size_t>(axis_->getOptionInt())] = 1.0F;
    return scene_node_->getOrientation() * axis;
  };
  mouse.clicked = [this](int aspect) { select(aspect); };
  return mouse;
}

// Says what it is, and marks it in the panel.
void AspectsDisplay::select(int aspect) {
  if (!map_ || aspect < 1 || static_cast<std::size_t>(aspect) > map_->map->aspects().size()) return;
  const Aspect& found = map_->map->aspects()[static_cast<std::size_t>(aspect - 1)];
  setStatus(Level::Ok, "Selected",
            text("Aspect " + std::to_string(aspect) + ", " + branch_text(found.mode, found.determinant_sign) +
                 ", " + number_text(found.measure, 4) + " " + map_->map->unit()));
  selected_ = aspect;
  change_look();
  link_->select(aspect);
}

Look AspectsDisplay::look() const {
  Look look;
  look.opacity = opacity_->getFloat();
  look.present_opacity = present_opacity_->getFloat();
  look.present = asked_ ? asked_->aspect : 0;
  look.selected = selected_;
  look.ids = ids_->getBool();
  look.legend = legend_->getBool();
  return look;
}

void AspectsDisplay::change_look() {
  if (!drawn_) return;
  drawn_->set_look(look());
  context_->queueRender();
}

}  // namespace parallel_aspects

PLUGINLIB_EXPORT_CLASS(parallel_aspects::AspectsDisplay, rviz::Display)
