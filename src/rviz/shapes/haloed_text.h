// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_SHAPES_HALOED_TEXT_H
#define PARALLEL_ASPECTS_RVIZ_SHAPES_HALOED_TEXT_H

#include <OgreVector3.h>
#include <cstdint>
#include <memory>
#include <rviz/ogre_helpers/movable_text.h>
#include <string>
#include <vector>

namespace parallel_aspects {

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

#endif  // PARALLEL_ASPECTS_RVIZ_SHAPES_HALOED_TEXT_H
