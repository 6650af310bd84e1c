// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_SURFACE_HANDLE_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_SURFACE_HANDLE_H

#include <OgreVector3.h>
#include <functional>
#include <memory>

namespace Ogre {
class SceneNode;
}

namespace rviz {
class DisplayContext;
class Shape;
}  // namespace rviz

namespace parallel_aspects {

/// What the mouse does to a face of a section, under rviz's tool *Interact*.
struct SurfaceMouse {
  std::function<void(int aspect)> clicked;
  std::function<void()> taken;            ///< a drag begins
  std::function<void(double)> dragged;    ///< so far across the face since then [m]
  std::function<Ogre::Vector3()> across;  ///< of unit length, in the fixed frame
};

/// Makes the mouse take a shape, for as long as it lives.
class SurfaceHandle {
 public:
  SurfaceHandle(int aspect, Ogre::SceneNode* node, const SurfaceMouse& mouse, rviz::DisplayContext* context);
  ~SurfaceHandle();
  SurfaceHandle(SurfaceHandle&&) noexcept;
  SurfaceHandle& operator=(SurfaceHandle&&) noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_SURFACE_HANDLE_H
