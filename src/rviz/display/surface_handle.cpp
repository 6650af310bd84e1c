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

// What is no button of the mouse for us goes to the view, as beside the surface.
void pass_on(rviz::ViewportMouseEvent& event) {
  if (event.panel != nullptr && event.panel->getViewController() != nullptr)
    event.panel->getViewController()->handleMouseEvent(event);
}

/// Hears clicks; what is dragged is the view.
class Listener : public rviz::InteractiveObject {
 public:
  Listener(int aspect, const SurfaceMouse& mouse, Qt::CursorShape cursor)
      : mouse_(mouse), aspect_(aspect), cursor_(cursor) {}

  bool isInteractive() override { return true; }
  void enableInteraction(bool) override {}
  const QCursor& getCursor() const override { return cursor_; }

  void handleMouseEvent(rviz::ViewportMouseEvent& event) override {
    if (event.leftDown()) {
      is_held_ = true;
      has_moved_ = false;
      x_ = event.x;
      y_ = event.y;
    }
    has_moved_ = has_moved_ || std::abs(event.x - x_) > still || std::abs(event.y - y_) > still;
    act(event);
    if (!is_held_ || !event.leftUp()) return;
    is_held_ = false;
    if (!has_moved_) mouse_.clicked(aspect_);
  }

 protected:
  virtual void act(rviz::ViewportMouseEvent& event) { pass_on(event); }

  bool is_dragged(rviz::ViewportMouseEvent& event) const {
    return is_held_ && has_moved_ && event.type == QEvent::MouseMove && event.left();
  }
  bool is_held() const { return is_held_; }
  int y_at_press() const { return y_; }

  const SurfaceMouse& mouse_;

 private:
  const int aspect_;
  const QCursor cursor_;
  bool is_held_ = false, has_moved_ = false;
  int x_ = 0, y_ = 0;
};

/// Drags a face of a section across itself.
class SectionListener : public Listener {
 public:
  SectionListener(int aspect, const SurfaceMouse& mouse) : Listener(aspect, mouse, Qt::SizeVerCursor) {}

 protected:
  void act(rviz::ViewportMouseEvent& event) override {
    if (event.leftDown()) return take(event);
    if (is_dragged(event)) return drag(event);
    if (!is_held()) pass_on(event);
  }

 private:
  void take(const rviz::ViewportMouseEvent& event) {
    along_ = mouse_.across();
    start_ = 0.0F;
    by_ray_ = nearest_on_line(ray_of(event), along_, start_);
    mouse_.taken();
  }

  void drag(const rviz::ViewportMouseEvent& event) {
    float now = 0.0F;
    if (by_ray_ && nearest_on_line(ray_of(event), along_, now)) return mouse_.dragged(now - start_);
    const Ogre::Camera& camera = *event.viewport->getCamera();
    const float height = camera.getProjectionType() == Ogre::PT_ORTHOGRAPHIC
                             ? camera.getOrthoWindowHeight()
                             : camera.getDerivedPosition().length();
    mouse_.dragged(static_cast<float>(y_at_press() - event.y) * height /
                   static_cast<float>(std::max(1, event.viewport->getActualHeight())));
  }

  bool by_ray_ = false;
  float start_ = 0.0F;
  Ogre::Vector3 along_ = Ogre::Vector3::UNIT_Z;
};

}  // namespace

SurfaceListeners::SurfaceListeners(SurfaceMouse mouse) : mouse_(std::move(mouse)) {}

SurfaceListeners::~SurfaceListeners() = default;

boost::shared_ptr<rviz::InteractiveObject> SurfaceListeners::of(int aspect, bool is_section) {
  auto& listener = listeners_[{aspect, is_section}];
  if (!listener && is_section) listener = boost::make_shared<SectionListener>(aspect, mouse_);
  if (!listener) listener = boost::make_shared<Listener>(aspect, mouse_, Qt::PointingHandCursor);
  return listener;
}

struct SurfaceHandle::Parts {
  boost::shared_ptr<rviz::SelectionHandler> handler;
};

SurfaceHandle::SurfaceHandle(const boost::shared_ptr<rviz::InteractiveObject>& listener,
                             Ogre::SceneNode* node, rviz::DisplayContext* context)
    : parts_(std::make_unique<Parts>()) {
  parts_->handler = boost::make_shared<rviz::SelectionHandler>(context);
  parts_->handler->addTrackedObjects(node);
  parts_->handler->setInteractiveObject(listener);
}

SurfaceHandle::~SurfaceHandle() = default;
SurfaceHandle::SurfaceHandle(SurfaceHandle&&) noexcept = default;
SurfaceHandle& SurfaceHandle::operator=(SurfaceHandle&&) noexcept = default;

}  // namespace parallel_aspects
