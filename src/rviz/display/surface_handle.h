// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_SURFACE_HANDLE_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_SURFACE_HANDLE_H

#include <boost/shared_ptr.hpp>

#include <OgreVector3.h>
#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace Ogre {
class SceneNode;
}

namespace rviz {
class DisplayContext;
class InteractiveObject;
}  // namespace rviz

namespace parallel_aspects {

/// What the mouse does to surfaces, under rviz's tool *Interact*.
struct SurfaceMouse {
  std::function<void(int aspect)> clicked;
  std::function<void()> taken;            ///< a drag of the section begins
  std::function<void(double)> dragged;    ///< so far across its faces since then [m]
  std::function<Ogre::Vector3()> across;  ///< of unit length, in the fixed frame
};

/// Who hears of the mouse on surfaces. Outlives the pictures, so that a drag goes on while what is dragged is
/// drawn anew.
class SurfaceListeners {
 public:
  explicit SurfaceListeners(SurfaceMouse mouse);
  ~SurfaceListeners();
  SurfaceListeners(const SurfaceListeners&) = delete;
  SurfaceListeners& operator=(const SurfaceListeners&) = delete;

  /// Of an aspect. Faces of a section are dragged; beside them a drag turns the view, as where nothing is.
  boost::shared_ptr<rviz::InteractiveObject> of(int aspect, bool is_section);

 private:
  const SurfaceMouse mouse_;
  std::map<std::pair<int, bool>, boost::shared_ptr<rviz::InteractiveObject>> listeners_;
};

/// Makes the mouse take a shape, for as long as it lives.
class SurfaceHandle {
 public:
  SurfaceHandle(const boost::shared_ptr<rviz::InteractiveObject>& listener, Ogre::SceneNode* node,
                rviz::DisplayContext* context);
  ~SurfaceHandle();
  SurfaceHandle(SurfaceHandle&&) noexcept;
  SurfaceHandle& operator=(SurfaceHandle&&) noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_SURFACE_HANDLE_H
