// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_DRAWN_PICTURE_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_DRAWN_PICTURE_H

#include "draw/scene/surface_picture.h"
#include "rviz/display/surface_handle.h"

#include "rviz/shapes/ogre_shapes.h"
#include <memory>
#include <rviz/ogre_helpers/billboard_line.h>
#include <rviz/ogre_helpers/mesh_shape.h>
#include <string>
#include <vector>

namespace rviz {
class DisplayContext;
}

namespace parallel_aspects {

/// How a picture looks.
struct Look {
  double opacity = 0.6;          ///< of the aspects that the robot is not in
  double present_opacity = 0.9;  ///< of the one that it is in
  int present = 0;               ///< its id; 0 where it is not known
  int selected = 0;              ///< id of the one that was clicked, whose id is larger; 0 for none
  bool ids = true;               ///< whether ids are written
  bool legend = true;
};

/// A picture as shapes of rviz below one node of its scene. Make and destroy it in rviz's own thread.
class DrawnPicture {
 public:
  DrawnPicture(const SurfacePicture& picture, const Look& look, rviz::DisplayContext* context,
               Ogre::SceneNode* parent, SurfaceListeners& listeners);
  ~DrawnPicture();
  DrawnPicture(const DrawnPicture&) = delete;
  DrawnPicture& operator=(const DrawnPicture&) = delete;

  void set_look(const Look& look);

  /// The lines of the legend above the colours, in place of those before, which may be out of date.
  void set_head(const std::string& head);

  /// Where the moving part stands.
  void set_placement(const Ogre::Vector3& placement);

 private:
  struct Mesh {
    std::unique_ptr<rviz::MeshShape> shape;
    int aspect;
    std::uint32_t color;
    bool is_flat, is_opaque;
  };
  struct Text {
    std::unique_ptr<HaloedText> words;
    int aspect;
    double height;  // while it is not selected [m]
    bool is_legend;
  };

  void add(const PicturePart& part, Ogre::SceneNode* node, double size, bool is_cut);
  void add(const ColoredMesh& mesh, Ogre::SceneNode* node, bool is_cut);
  void add(const ColoredLines& lines, Ogre::SceneNode* node, double size);
  void add_text(const Label& label, Ogre::SceneNode* node, double height, bool is_legend);

  rviz::DisplayContext* context_;
  Ogre::SceneManager* scene_;
  SurfaceListeners& listeners_;
  Ogre::SceneNode *standing_, *moving_;
  std::vector<Mesh> meshes_;
  std::vector<std::unique_ptr<rviz::BillboardLine>> lines_;
  std::vector<Text> texts_;
  std::vector<SurfaceHandle> handles_;
  Label legend_;
  double legend_size_ = 1.0;
  bool shows_legend_ = true;
  std::string head_words_;
  std::vector<std::unique_ptr<HaloedText>> head_;  // the legend's first lines
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_DRAWN_PICTURE_H
