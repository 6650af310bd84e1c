// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/drawn_picture.h"

#include "rviz/display/ogre_types.h"

#include <OgreMaterial.h>
#include <OgreRenderQueue.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <algorithm>
#include <rviz/display_context.h>

namespace parallel_aspects {
namespace {

// Over the size of the robot.
constexpr double line_width = 0.004, outline_width = 0.008;

constexpr double selected_height = 1.6;  // over that of ids that are not

// Over the height of words: of the halo that parts them from aspects of any colour, and from the background.
constexpr float halo_width = 0.07F;
constexpr std::uint32_t halo_color = 0xFAFAF8;
// After robot, handle and the way to the singularity, which else hide the words.
constexpr Ogre::uint8 halo_queue = Ogre::RENDER_QUEUE_9, words_queue = Ogre::RENDER_QUEUE_9 + 1;

constexpr float own_light = 0.45F;  // of a body: share of its colour that no shadow takes

void set_color(rviz::Object& object, std::uint32_t color, float opacity) {
  const Ogre::ColourValue value = ogre_color(color);
  object.setColor(value.r, value.g, value.b, opacity);
}

// The words in their place, and each copy below them to a side of its own.
void set_height(const std::vector<std::unique_ptr<rviz::MovableText>>& copies, float height) {
  for (std::size_t i = 0; i < copies.size(); ++i) {
    copies[i]->setCharacterHeight(height);
    if (i + 1 == copies.size()) continue;
    const float across = i % 2 == 0 ? -1.0F : 1.0F, up = i / 2 == 0 ? -1.0F : 1.0F;
    copies[i]->setLocalTranslation(halo_width * height * Ogre::Vector3(across, up, 0.0F));
  }
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
  for (const Label& meaning : picture.meanings)
    add_text(meaning, standing_, legend_height * picture.size, true);
  if (!picture.legend.text.empty()) add_text(picture.legend, standing_, legend_height * picture.size, true);
  set_look(look);
}

DrawnPicture::~DrawnPicture() {
  handles_.clear();
  meshes_.clear();
  lines_.clear();
  for (Text& text : texts_) {
    for (const auto& copy : text.copies) copy->detachFromParent();
    text.node->removeAndDestroyAllChildren();
    scene_->destroySceneNode(text.node);
  }
  texts_.clear();
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
  lines_.push_back(std::move(line));
}

void DrawnPicture::add_text(const Label& label, Ogre::SceneNode* parent, double height, bool is_legend) {
  Text text{{}, parent->createChildSceneNode(ogre_vector(label.at)), label.aspect, height, is_legend};
  for (int side = 0; side < 4 && !is_legend; ++side) add_copy(label, halo_color, halo_queue, text);
  add_copy(label, label.color, words_queue, text);
  set_height(text.copies, static_cast<float>(height));
  if (label.raised > 0.0)  // legends have no halo, whose copies have places of their own
    text.copies.back()->setLocalTranslation(
        Ogre::Vector3(0.0F, static_cast<float>(label.raised * height), 0.0F));
  if (label.aspect != 0) handles_.emplace_back(listeners_.of(label.aspect, false), text.node, context_);
  texts_.push_back(std::move(text));
}

// In a node of its own, as words have no name, and Ogre takes each name once in a node.
void DrawnPicture::add_copy(const Label& label, std::uint32_t color, Ogre::uint8 queue, Text& text) {
  auto copy = std::make_unique<rviz::MovableText>(label.text, "Liberation Sans",
                                                  static_cast<float>(text.height), ogre_color(color));
  copy->setTextAlignment(rviz::MovableText::H_CENTER,
                         text.is_legend ? rviz::MovableText::V_ABOVE : rviz::MovableText::V_CENTER);
  copy->showOnTop(true);
  copy->setRenderQueueGroup(queue);
  text.node->createChildSceneNode()->attachObject(copy.get());
  text.copies.push_back(std::move(copy));
}

void DrawnPicture::set_look(const Look& look) {
  for (const Mesh& mesh : meshes_) {
    const double opacity = mesh.is_opaque                ? 1.0
                           : mesh.aspect == look.present ? look.present_opacity
                                                         : look.opacity;
    set_color(*mesh.shape, mesh.color, static_cast<float>(opacity));
    light(*mesh.shape, mesh.color, static_cast<float>(opacity), mesh.is_flat);
  }
  for (const Text& text : texts_) {
    text.node->setVisible(text.is_legend ? look.legend : look.ids);
    const bool is_selected = text.aspect != 0 && text.aspect == look.selected;
    set_height(text.copies, static_cast<float>((is_selected ? selected_height : 1.0) * text.height));
  }
}

void DrawnPicture::set_head(const std::string& head) {
  if (head == head_) return;
  head_ = head;
  if (!texts_.empty() && texts_.back().is_legend)
    texts_.back().copies.back()->setCaption(head);  // added last
}

void DrawnPicture::set_placement(const Ogre::Vector3& placement) { moving_->setPosition(placement); }

}  // namespace parallel_aspects
