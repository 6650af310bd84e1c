// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/drawn_picture.h"

#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

namespace parallel_aspects {
namespace {

// Over the size of the robot.
constexpr double id_height = 0.045, legend_height = 0.028, line_width = 0.004, outline_width = 0.008;

float channel(std::uint32_t color, unsigned shift) {
  return static_cast<float>(color >> shift & 0xFFU) / 255.0F;
}

Ogre::ColourValue ogre_color(std::uint32_t color) {
  return Ogre::ColourValue(channel(color, 16), channel(color, 8), channel(color, 0), 1.0F);
}

Ogre::Vector3 ogre_vector(const Eigen::Vector3f& vector) { return {vector.x(), vector.y(), vector.z()}; }

}  // namespace

DrawnPicture::DrawnPicture(const SurfacePicture& picture, const Look& look, Ogre::SceneManager* scene,
                           Ogre::SceneNode* parent)
    : scene_(scene), root_(parent->createChildSceneNode()), is_cut_(picture.is_cut) {
  for (const ColoredMesh& mesh : picture.meshes) add(mesh);
  for (const ColoredLines& lines : picture.lines) add(lines, picture.size);
  for (const Label& label : picture.labels) add_text(label, id_height * picture.size, false);
  if (!picture.meshes.empty()) add_text(picture.legend, legend_height * picture.size, true);
  set_look(look);
}

DrawnPicture::~DrawnPicture() {
  meshes_.clear();
  lines_.clear();
  for (Text& text : texts_) {
    text.node->detachAllObjects();
    scene_->destroySceneNode(text.node);
  }
  texts_.clear();
  scene_->destroySceneNode(root_);
}

void DrawnPicture::add(const ColoredMesh& mesh) {
  if (mesh.triangles.empty()) return;
  auto shape = std::make_unique<rviz::MeshShape>(scene_, root_);
  shape->estimateVertexCount(mesh.points.size());
  shape->beginTriangles();
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    shape->addVertex(ogre_vector(mesh.points[i]), ogre_vector(mesh.normals[i]));
  for (const auto& triangle : mesh.triangles) shape->addTriangle(triangle[0], triangle[1], triangle[2]);
  shape->endTriangles();
  meshes_.push_back({std::move(shape), mesh.aspect, mesh.color});
}

void DrawnPicture::add(const ColoredLines& lines, double size) {
  auto line = std::make_unique<rviz::BillboardLine>(scene_, root_);
  line->setMaxPointsPerLine(2);
  line->setNumLines(static_cast<std::uint32_t>(lines.ends.size() / 2));
  line->setLineWidth(static_cast<float>((lines.is_outline ? outline_width : line_width) * size));
  line->setColor(channel(lines.color, 16), channel(lines.color, 8), channel(lines.color, 0), 1.0F);
  for (std::size_t i = 0; i + 1 < lines.ends.size(); i += 2) {
    if (i > 0) line->newLine();
    line->addPoint(ogre_vector(lines.ends[i]));
    line->addPoint(ogre_vector(lines.ends[i + 1]));
  }
  lines_.push_back(std::move(line));
}

void DrawnPicture::add_text(const Label& label, double height, bool is_legend) {
  auto text = std::make_unique<rviz::MovableText>(label.text, "Liberation Sans", static_cast<float>(height),
                                                  ogre_color(label.color));
  text->setTextAlignment(rviz::MovableText::H_CENTER,
                         is_legend ? rviz::MovableText::V_ABOVE : rviz::MovableText::V_CENTER);
  text->showOnTop(true);
  Ogre::SceneNode* const node = root_->createChildSceneNode(ogre_vector(label.at));
  node->attachObject(text.get());
  texts_.push_back({std::move(text), node, is_legend});
}

void DrawnPicture::set_look(const Look& look) {
  for (const Mesh& mesh : meshes_) {
    const double opacity = is_cut_ ? 1.0 : mesh.aspect == look.present ? look.present_opacity : look.opacity;
    mesh.shape->setColor(channel(mesh.color, 16), channel(mesh.color, 8), channel(mesh.color, 0),
                         static_cast<float>(opacity));
  }
  for (const Text& text : texts_) text.node->setVisible(text.is_legend ? look.legend : look.ids);
}

}  // namespace parallel_aspects
