// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/surface_handle.h"

#include <boost/make_shared.hpp>

#include <OgreCamera.h>
#include <OgreRay.h>
#include <OgreSceneNode.h>
#include <OgreViewport.h>
#include <QCursor>
#include <algorithm>
#include <cmath>
#include <rviz/display_context.h>
#include <rviz/interactive_object.h>
#include <rviz/render_panel.h>
#include <rviz/selection/selection_handler.h>
#include <rviz/view_controller.h>
#include <rviz/viewport_mouse_event.h>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int still = 3;          // a click moves by no more [px]
constexpr float aligned = 0.99F;  // of the cosine of view and face: then the mouse moves it by its height

Ogre::Ray ray_of(const rviz::ViewportMouseEvent& event) {
  return event.viewport->getCamera()->getCameraToViewportRay(
      static_cast<float>(event.x) / static_cast<float>(event.viewport->getActualWidth()),
      static_cast<float>(event.y) / static_cast<float>(event.viewport->getActualHeight()));
}

// How far along a line the point is that is nearest to a ray; nothing where they are nearly parallel.
bool nearest_on_line(const Ogre::Ray& ray, const Ogre::Vector3& along, float& distance) {
  const float cosine = ray.getDirection().dotProduct(along);
  if (std::abs(cosine) > aligned) return false;
  const Ogre::Vector3& from = ray.getOrigin();
  distance =
      (from.dotProduct(along) - cosine * from.dotProduct(ray.getDirection())) / (1.0F - cosine * cosine);
  return true;
}

class Listener : public rviz::InteractiveObject {
 public:
  Listener(int aspect, SurfaceMouse mouse) : aspect_(aspect), mouse_(std::move(mouse)) {}

  bool isInteractive() override { return true; }
  void enableInteraction(bool) override {}
  const QCursor& getCursor() const override { return cursor_; }

  void handleMouseEvent(rviz::ViewportMouseEvent& event) override {
    if (event.leftDown()) return take(event);
    if (is_held_ && event.leftUp()) return release();
    if (is_held_ && event.type == QEvent::MouseMove && event.left()) return drag(event);
    if (event.panel != nullptr && event.panel->getViewController() != nullptr)
      event.panel->getViewController()->handleMouseEvent(event);  // as beside it
  }

 private:
  void take(const rviz::ViewportMouseEvent& event) {
    is_held_ = true;
    has_moved_ = false;
    x_ = event.x;
    y_ = event.y;
    along_ = mouse_.across();
    start_ = 0.0F;
    by_ray_ = nearest_on_line(ray_of(event), along_, start_);
    mouse_.taken();
  }

  void drag(const rviz::ViewportMouseEvent& event) {
    has_moved_ = has_moved_ || std::abs(event.x - x_) > still || std::abs(event.y - y_) > still;
    if (!has_moved_) return;
    float now = 0.0F;
    if (by_ray_ && nearest_on_line(ray_of(event), along_, now)) return mouse_.dragged(now - start_);
    const Ogre::Camera& camera = *event.viewport->getCamera();
    const float height = camera.getProjectionType() == Ogre::PT_ORTHOGRAPHIC
                             ? camera.getOrthoWindowHeight()
                             : camera.getDerivedPosition().length();
    mouse_.dragged(static_cast<float>(y_ - event.y) * height /
                   static_cast<float>(std::max(1, event.viewport->getActualHeight())));
  }

  void release() {
    is_held_ = false;
    if (!has_moved_) mouse_.clicked(aspect_);
  }

  const int aspect_;
  const SurfaceMouse mouse_;
  const QCursor cursor_{Qt::SizeVerCursor};
  bool is_held_ = false, has_moved_ = false, by_ray_ = false;
  int x_ = 0, y_ = 0;
  float start_ = 0.0F;
  Ogre::Vector3 along_ = Ogre::Vector3::UNIT_Z;
};

}  // namespace

struct SurfaceHandle::Parts {
  boost::shared_ptr<Listener> listener;
  boost::shared_ptr<rviz::SelectionHandler> handler;
};

SurfaceHandle::SurfaceHandle(int aspect, Ogre::SceneNode* node, const SurfaceMouse& mouse,
                             rviz::DisplayContext* context)
    : parts_(std::make_unique<Parts>()) {
  parts_->listener = boost::make_shared<Listener>(aspect, mouse);
  parts_->handler = boost::make_shared<rviz::SelectionHandler>(context);
  parts_->handler->addTrackedObjects(node);
  parts_->handler->setInteractiveObject(parts_->listener);
}

SurfaceHandle::~SurfaceHandle() = default;
SurfaceHandle::SurfaceHandle(SurfaceHandle&&) noexcept = default;
SurfaceHandle& SurfaceHandle::operator=(SurfaceHandle&&) noexcept = default;

}  // namespace parallel_aspects
