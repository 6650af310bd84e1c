// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/drawn_picture.h"

#include "draw/scene/robot_lines.h"

#include "rviz/shapes/ogre_shapes.h"
#include <OgreMaterial.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <algorithm>
#include <rviz/display_context.h>
#include <sstream>

namespace parallel_aspects {
namespace {

// Over the size of the robot.
constexpr double line_width = 0.004, outline_width = 0.008;

constexpr double selected_height = 1.6;  // over that of ids that are not

constexpr float own_light = 0.45F;  // of a body: share of its colour that no shadow takes

void set_color(rviz::Object& object, std::uint32_t color, float opacity) {
  const Ogre::ColourValue value = ogre_color(color);
  object.setColor(value.r, value.g, value.b, opacity);
}

// What is flat has its colour from wherever it is seen, so that it is that of the legend and of the table;
// bodies have shadows, in which the colour still shows.
void light(rviz::MeshShape& shape, std::uint32_t color, float opacity, bool is_flat) {
  const Ogre::ColourValue full = ogre_color(color);
  const float own = is_flat ? 1.0F : own_light;
  const Ogre::MaterialPtr material = shape.getMaterial();
  material->setSelfIllumination(own * full);
  material->setAmbient(Ogre::ColourValue::Black);
  Ogre::ColourValue lit = (1.0F - own) * full;
  lit.a = opacity;
  material->setDiffuse(lit);
}

}  // namespace

DrawnPicture::DrawnPicture(const SurfacePicture& picture, const Look& look, rviz::DisplayContext* context,
                           Ogre::SceneNode* parent, SurfaceListeners& listeners)
    : context_(context),
      scene_(context->getSceneManager()),
      listeners_(listeners),
      standing_(parent->createChildSceneNode()),
      moving_(standing_->createChildSceneNode()) {
  add(picture.moving, moving_, picture.size, picture.is_cut);
  add(picture.standing, standing_, picture.size, false);
  for (const Label& meaning : picture.meanings) add_text(meaning, standing_, picture.legend_size, true);
  legend_ = picture.legend;
  legend_size_ = picture.legend_size;
  set_look(look);
  set_head(legend_.text);
}

DrawnPicture::~DrawnPicture() {
  handles_.clear();
  meshes_.clear();
  lines_.clear();
  texts_.clear();
  head_.clear();
  scene_->destroySceneNode(moving_);
  scene_->destroySceneNode(standing_);
}

void DrawnPicture::add(const PicturePart& part, Ogre::SceneNode* node, double size, bool is_cut) {
  for (const ColoredMesh& mesh : part.meshes) add(mesh, node, is_cut);
  for (const ColoredLines& lines : part.lines) add(lines, node, size);
  for (const Label& label : part.labels) add_text(label, node, id_height * label.share * size, false);
}

void DrawnPicture::add(const ColoredMesh& mesh, Ogre::SceneNode* node, bool is_cut) {
  if (mesh.triangles.empty()) return;
  auto shape = std::make_unique<rviz::MeshShape>(scene_, node);
  shape->estimateVertexCount(mesh.points.size());
  shape->beginTriangles();
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    shape->addVertex(ogre_vector(mesh.points[i]), ogre_vector(mesh.normals[i]));
  for (const auto& triangle : mesh.triangles) shape->addTriangle(triangle[0], triangle[1], triangle[2]);
  shape->endTriangles();
  handles_.emplace_back(listeners_.of(mesh.aspect, is_cut && mesh.is_flat), shape->getRootNode(), context_);
  meshes_.push_back({std::move(shape), mesh.aspect, mesh.color, mesh.is_flat, is_cut});
}

void DrawnPicture::add(const ColoredLines& lines, Ogre::SceneNode* node, double size) {
  if (lines.ends.empty()) return;
  auto line = std::make_unique<rviz::BillboardLine>(scene_, node);
  set_color(*line, lines.color, 1.0F);
  set_segments(lines.ends, (lines.is_outline ? outline_width : line_width) * size, *line);
  if (lines.is_leader) show_through(*line);
  lines_.push_back(std::move(line));
}

void DrawnPicture::add_text(const Label& label, Ogre::SceneNode* parent, double height, bool is_legend) {
  auto words = std::make_unique<HaloedText>(label.text, label.color, ogre_vector(label.at),
                                            static_cast<float>(height), !is_legend, parent);
  if (label.raised > 0.0) words->raise(static_cast<float>(label.raised * height));
  if (label.aspect != 0) handles_.emplace_back(listeners_.of(label.aspect, false), words->node(), context_);
  texts_.push_back({std::move(words), label.aspect, height, is_legend});
}

void DrawnPicture::set_look(const Look& look) {
  for (const Mesh& mesh : meshes_) {
    const double opacity = mesh.is_opaque                ? 1.0
                           : mesh.aspect == look.present ? look.present_opacity
                                                         : look.opacity;
    set_color(*mesh.shape, mesh.color, static_cast<float>(opacity));
    light(*mesh.shape, mesh.color, static_cast<float>(opacity), mesh.is_flat);
  }
  shows_legend_ = look.legend;
  for (const auto& line : head_) line->node()->setVisible(look.legend);
  for (const Text& text : texts_) {
    text.words->node()->setVisible(text.is_legend ? look.legend : look.ids);
    const bool is_selected = text.aspect != 0 && text.aspect == look.selected;
    text.words->set_height(static_cast<float>((is_selected ? selected_height : 1.0) * text.height));
  }
}

// A text for each line, as the lines of one are not centred.
void DrawnPicture::set_head(const std::string& head) {
  if (head == head_words_ || legend_.text.empty()) return;
  head_words_ = head;
  std::istringstream stream(head);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  if (lines.size() != head_.size()) {
    head_.clear();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      head_.push_back(std::make_unique<HaloedText>(lines[i], legend_.color, ogre_vector(legend_.at),
                                                   static_cast<float>(legend_size_), false, standing_));
      const double above = legend_pitch * static_cast<double>(lines.size() - 1 - i);
      head_.back()->raise(static_cast<float>((legend_.raised + above) * legend_size_));
      head_.back()->node()->setVisible(shows_legend_);
    }
  }
  for (std::size_t i = 0; i < lines.size(); ++i) head_[i]->set_words(lines[i]);
}

void DrawnPicture::set_placement(const Ogre::Vector3& placement) { moving_->setPosition(placement); }

}  // namespace parallel_aspects
