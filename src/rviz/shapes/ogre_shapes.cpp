// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/shapes/ogre_shapes.h"

#include <OgreRenderQueue.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

namespace parallel_aspects {
namespace {

// Over the height of words: of the halo that parts them from aspects of any colour, and from the background.
constexpr float halo_width = 0.07F;
constexpr std::uint32_t halo_color = 0xFAFAF8;
// After robot, handle and the way to the singularity, which else hide the words.
constexpr Ogre::uint8 halo_queue = Ogre::RENDER_QUEUE_9, words_queue = Ogre::RENDER_QUEUE_9 + 1;

}  // namespace

HaloedText::HaloedText(const std::string& words, std::uint32_t color, const Ogre::Vector3& at, float height,
                       bool haloed, Ogre::SceneNode* parent)
    : haloed_(haloed), node_(parent->createChildSceneNode(at)) {
  for (int side = 0; side < 4 && haloed; ++side) add_copy(words, halo_color, true, height);
  add_copy(words, color, false, height);
  set_height(height);
}

HaloedText::~HaloedText() {
  for (const auto& copy : copies_) copy->detachFromParent();
  node_->removeAndDestroyAllChildren();
  node_->getCreator()->destroySceneNode(node_);
}

// In a node of its own, as words have no name, and Ogre takes each name once in a node.
void HaloedText::add_copy(const std::string& words, std::uint32_t color, bool is_halo, float height) {
  auto copy = std::make_unique<rviz::MovableText>(words, "Liberation Sans", height, ogre_color(color));
  copy->setTextAlignment(rviz::MovableText::H_CENTER,
                         haloed_ ? rviz::MovableText::V_CENTER : rviz::MovableText::V_ABOVE);
  copy->showOnTop(true);
  copy->setRenderQueueGroup(is_halo ? halo_queue : words_queue);
  node_->createChildSceneNode()->attachObject(copy.get());
  copies_.push_back(std::move(copy));
}

// The words in their place, and each copy below them to a side of its own.
void HaloedText::set_height(float height) {
  for (std::size_t i = 0; i < copies_.size(); ++i) {
    copies_[i]->setCharacterHeight(height);
    if (i + 1 == copies_.size()) continue;
    const float across = i % 2 == 0 ? -1.0F : 1.0F, up = i / 2 == 0 ? -1.0F : 1.0F;
    copies_[i]->setLocalTranslation(halo_width * height * Ogre::Vector3(across, up, 0.0F));
  }
}

void HaloedText::set_words(const std::string& words) {
  for (const auto& copy : copies_) copy->setCaption(words);
}

void HaloedText::raise(float height) {
  copies_.back()->setLocalTranslation(Ogre::Vector3(0.0F, height, 0.0F));
}

}  // namespace parallel_aspects
