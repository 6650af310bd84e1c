// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/aspects_display.h"

#include "ros/messages/conversions.h"

#include <OgreSceneNode.h>
#include <cmath>
#include <pluginlib/class_list_macros.hpp>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/properties/bool_property.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/string_property.h>
#include <tuple>

namespace parallel_aspects {
namespace {

using Level = rviz::StatusProperty;

constexpr float between_sections = 0.5F;  // that follow the robot [s]
constexpr float between_looks = 0.1F;     // at what the node says [s]
constexpr double point_size = 0.05;       // of the robot's size

Ogre::Vector3 ogre_vector(const Eigen::Vector3d& vector) {
  return {static_cast<float>(vector.x()), static_cast<float>(vector.y()), static_cast<float>(vector.z())};
}

Ogre::Quaternion ogre_rotation(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  return {static_cast<float>(q.w()), static_cast<float>(q.x()), static_cast<float>(q.y()),
          static_cast<float>(q.z())};
}

auto parts(const PictureChoice& choice) {
  return std::make_tuple(choice.shown, choice.chosen, choice.aspect, choice.section, choice.axis,
                         choice.offset, choice.upper, choice.tells_boundaries, choice.radian);
}

std::optional<WorkingMode> mode_of(const AspectState& state) {
  return WorkingMode::from_signs({state.working_mode.begin(), state.working_mode.end()});
}

QString text(const std::string& words) { return QString::fromStdString(words); }

}  // namespace

AspectsDisplay::AspectsDisplay() {
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
  radian_ = new rviz::FloatProperty("Length of a radian", 0.0F,
                                    "How long angles are drawn [m]; 0 for what suits the robot.", this);
  radian_->setMin(0.0F);
}

AspectsDisplay::~AspectsDisplay() { stop(); }

void AspectsDisplay::onInitialize() { setStatus(Level::Warn, "Node", "Not looked for yet."); }

void AspectsDisplay::onEnable() { follow_node(); }

void AspectsDisplay::onDisable() { stop(); }

void AspectsDisplay::reset() {
  rviz::Display::reset();
  if (isEnabled()) follow_node();
}

void AspectsDisplay::stop() {
  link_.reset();
  thread_.reset();
  drawn_.reset();
  point_.reset();
  map_.reset();
  picture_.reset();
  present_.reset();
  mode_.reset();
  asked_.reset();
  asked_at_.reset();
  news_ = {};
  maps_ = 0;
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
    tell(result);
    take_picture(result);
    ask_for_picture();
  }
  if (map_) place();
}

void AspectsDisplay::take_news() {
  news_ = link_->news();
  if (!news_.is_there) {
    setStatus(Level::Warn, "Node", text("Waits for " + link_->name() + "."));
  } else {
    setStatus(Level::Ok, "Node", text(link_->name()));
  }
  if (news_.maps != maps_) {
    maps_ = news_.maps;
    thread_->fetch();
  }
  const bool is_known = map_ && news_.state && news_.state->status.code == Status::OK;
  present_.reset();
  if (!is_known) return;
  present_ = pose_from_base(*map_->map->manipulator(), news_.state->pose);
  if (const auto mode = mode_of(*news_.state)) mode_ = mode;
}

void AspectsDisplay::tell(const PictureThread::Result& result) {
  if (!result.problem.empty()) {
    setStatus(Level::Error, "Map", text(result.problem));
  } else if (!result.map) {
    const std::string said = news_.progress ? news_.progress->message : "";
    setStatus(Level::Warn, "Map", text(said.empty() ? "Waits for the node." : said));
  } else {
    char words[200];
    std::snprintf(words, sizeof words, "%zu aspects, %.1f MB in %.2f s; %zu triangles drawn in %.2f s",
                  result.map->map->aspects().size(), static_cast<double>(result.map->bytes) / 1e6,
                  result.fetch_seconds, result.picture ? result.picture->triangles : 0, result.draw_seconds);
    setStatus(Level::Ok, "Map", words);
  }
  if (!news_.is_there || !news_.state) {
    setStatus(Level::Warn, "Robot", "No state of it has come yet.");
  } else if (news_.state->status.code != Status::OK) {
    setStatus(Level::Warn, "Robot", text(news_.state->status.message));
  } else {
    setStatus(Level::Ok, "Robot", text("In aspect " + std::to_string(news_.state->aspect)));
  }
}

void AspectsDisplay::take_picture(const PictureThread::Result& result) {
  if (result.map != map_) {
    map_ = result.map;
    drawn_.reset();
    picture_.reset();
    point_.reset();
    asked_.reset();
    mode_.reset();
  }
  if (!map_ || result.picture == picture_) return;
  picture_ = result.picture;
  drawn_.reset();
  if (picture_) drawn_ = std::make_unique<DrawnPicture>(*picture_, look(), scene_manager_, scene_node_);
  context_->queueRender();
}

PictureChoice AspectsDisplay::choice() const {
  PictureChoice choice;
  choice.shown = static_cast<Shown>(shown_->getOptionInt());
  const std::string words = chosen_->getStdString();
  std::string problem;
  if (words.empty() && news_.shown)
    choice.chosen = *news_.shown;
  else
    choice.chosen = chosen_aspects(*map_->map, words, problem);
  choice.mode = mode_;
  if (!mode_ && !map_->map->working_modes().empty()) choice.mode = map_->map->working_modes().front();
  choice.aspect = present_ && news_.state ? static_cast<int>(news_.state->aspect) : 0;
  choice.section = static_cast<Section>(section_->getOptionInt());
  choice.axis = static_cast<std::size_t>(axis_->getOptionInt());
  choice.offset = offset_->getFloat();
  choice.upper = upper_->getBool();
  choice.tells_boundaries = boundaries_->getBool();
  choice.radian = radian_->getFloat();
  return choice;
}

bool AspectsDisplay::differs(const PictureChoice& choice) const {
  if (!asked_ || parts(*asked_) != parts(choice) || asked_->mode != choice.mode) return true;
  if (choice.section != Section::at_robot || !present_) return false;
  if (!asked_at_) return true;
  const TaskSpace space = map_->map->manipulator()->task_space();
  return std::abs(section_value(space, *present_, choice.axis) -
                  section_value(space, *asked_at_, choice.axis)) > section_step(*map_->map, choice.axis);
}

// One at a time, so that a robot that moves fast is not always drawn and never seen.
void AspectsDisplay::ask_for_picture() {
  if (!map_ || (asked_ && thread_->is_drawing())) return;
  const PictureChoice wanted = choice();
  std::string problem;
  if (wanted.shown == Shown::chosen) chosen_aspects(*map_->map, chosen_->getStdString(), problem);
  if (problem.empty())
    deleteStatus("Chosen");
  else
    setStatus(Level::Error, "Chosen", text(problem));
  if (!differs(wanted)) return;
  const bool only_moved = asked_ && parts(*asked_) == parts(wanted) && asked_->mode == wanted.mode;
  if (only_moved && since_picture_ < between_sections) return;
  since_picture_ = 0.0F;
  asked_ = wanted;
  asked_at_ = present_;
  thread_->draw(wanted, present_);
}

// Where the base of the robot is, and in it the picture.
void AspectsDisplay::place() {
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
  if (!context_->getFrameManager()->getTransform(map_->base_frame, ros::Time(), position, orientation)) {
    setStatus(Level::Error, "Frame",
              text("No transform from " + map_->base_frame + " to " + fixed_frame_.toStdString() + "."));
    return;
  }
  deleteStatus("Frame");
  const Manipulator& robot = *map_->map->manipulator();
  const Eigen::Isometry3d& task = robot.task_frame();
  const double radian = picture_ ? picture_->radian : 1.0;
  const Eigen::Vector3d at = task * placement(robot, present_, radian);
  scene_node_->setPosition(position + orientation * ogre_vector(at));
  scene_node_->setOrientation(orientation * ogre_rotation(task.linear()));
  move_present_point();
}

void AspectsDisplay::move_present_point() {
  const TaskSpace space = map_->map->manipulator()->task_space();
  if (!present_ || !picture_) return point_.reset();
  if (!point_) {
    point_ = std::make_unique<rviz::Shape>(rviz::Shape::Sphere, scene_manager_, scene_node_);
    const auto size = static_cast<float>(point_size * picture_->size);
    point_->setScale({size, size, size});
    point_->setColor(0.05F, 0.05F, 0.05F, 1.0F);
  }
  point_->setPosition(ogre_vector(drawn_point(space, *present_, picture_->radian)));
}

Look AspectsDisplay::look() const {
  Look look;
  look.opacity = opacity_->getFloat();
  look.present_opacity = present_opacity_->getFloat();
  look.present = asked_ ? asked_->aspect : 0;
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
