// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_SHAPES_OGRE_SHAPES_H
#define PARALLEL_ASPECTS_RVIZ_SHAPES_OGRE_SHAPES_H

#include <Eigen/Geometry>

#include <OgreColourValue.h>
#include <OgreMaterial.h>
#include <OgreMovableObject.h>
#include <OgreQuaternion.h>
#include <OgreRenderQueue.h>
#include <OgreSceneNode.h>
#include <OgreVector3.h>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <rviz/ogre_helpers/billboard_line.h>
#include <rviz/ogre_helpers/movable_text.h>
#include <string>
#include <vector>

namespace parallel_aspects {

template <class Vector>
Ogre::Vector3 ogre_vector(const Vector& vector) {
  return {static_cast<float>(vector.x()), static_cast<float>(vector.y()), static_cast<float>(vector.z())};
}

inline Ogre::Quaternion ogre_rotation(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaternionf q(rotation.cast<float>());
  return {q.w(), q.x(), q.y(), q.z()};
}

/// Of 0xRRGGBB.
inline Ogre::ColourValue ogre_color(std::uint32_t color) {
  const auto channel = [color](unsigned shift) {
    return static_cast<float>(color >> shift & 0xFFU) / 255.0F;
  };
  return Ogre::ColourValue(channel(16), channel(8), channel(0), 1.0F);
}

/// What is drawn after aspects and robots, so that they do not hide it.
inline constexpr Ogre::uint8 after_the_rest = Ogre::RENDER_QUEUE_8;

/// Call it when the line has its segments.
inline void show_through(rviz::BillboardLine& line) {
  line.getMaterial()->setDepthCheckEnabled(false);
  Ogre::SceneNode& chains = *line.getSceneNode();
  for (unsigned short i = 0; i < chains.numAttachedObjects(); ++i)
    chains.getAttachedObject(i)->setRenderQueueGroup(after_the_rest);
}

/// A line of segments, two points each. `width` [m].
template <class Points>
void set_segments(const Points& ends, double width, rviz::BillboardLine& line) {
  line.clear();
  line.setMaxPointsPerLine(2);
  line.setNumLines(static_cast<std::uint32_t>(ends.size() / 2));
  line.setLineWidth(static_cast<float>(width));
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (i > 0 && i % 2 == 0) line.newLine();
    line.addPoint(ogre_vector(ends[i]));
  }
}

/// Words that face the viewer, over all else, in a node of their own.
class HaloedText {
 public:
  /// `haloed`: with a halo that parts them from what is behind them, about `at`; else with their foot there.
  HaloedText(const std::string& words, std::uint32_t color, const Ogre::Vector3& at, float height,
             bool haloed, Ogre::SceneNode* parent);
  ~HaloedText();
  HaloedText(const HaloedText&) = delete;
  HaloedText& operator=(const HaloedText&) = delete;

  Ogre::SceneNode* node() const noexcept { return node_; }
  void set_height(float height);
  void set_words(const std::string& words);

  /// As the viewer sees it; of words without a halo.
  void raise(float height);

 private:
  void add_copy(const std::string& words, std::uint32_t color, bool is_halo, float height);

  bool haloed_;
  Ogre::SceneNode* node_;
  std::vector<std::unique_ptr<rviz::MovableText>> copies_;  // the words last, on those that are their halo
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_SHAPES_OGRE_SHAPES_H
