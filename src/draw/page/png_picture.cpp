// SPDX-License-Identifier: BSD-3-Clause
#include "draw/page/page_elements.h"

#include <cairo.h>
#include <memory>
#include <stdexcept>

namespace parallel_aspects {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)>;
using Context = std::unique_ptr<cairo_t, void (*)(cairo_t*)>;

void require(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("cairo could not draw the picture: ") +
                             cairo_status_to_string(status));
}

Surface make_surface(int width, int height) {
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy);
  require(cairo_surface_status(surface.get()));
  return surface;
}

cairo_status_t append(void* text, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(text)->append(data, data + length);
  return CAIRO_STATUS_SUCCESS;
}

class Painter {
 public:
  explicit Painter(cairo_surface_t* surface) : context_(cairo_create(surface), cairo_destroy) {}

  cairo_t* context() const { return context_.get(); }

  void operator()(const PageArea& area) const {
    trace(area.loops, true);
    choose(area.color);
    cairo_fill(context());
  }

  void operator()(const PageCurves& curves) const {
    const double dashes[] = {4.0, 3.0};
    trace(curves.lines, false);
    choose(curves.color);
    cairo_set_line_width(context(), curves.width);
    cairo_set_line_join(context(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(context(), CAIRO_LINE_CAP_ROUND);
    cairo_set_dash(context(), dashes, curves.dashed ? 2 : 0, 0.0);
    cairo_stroke(context());
  }

  void operator()(const PageText& text) const {
    cairo_select_font_face(context(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           text.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context(), text.size);
    cairo_text_extents_t extents;
    cairo_text_extents(context(), text.text.c_str(), &extents);
    const double before = text.anchor == TextAnchor::start    ? 0.0
                          : text.anchor == TextAnchor::middle ? 0.5 * extents.x_advance
                                                              : extents.x_advance;
    cairo_move_to(context(), text.at.x() - before, text.at.y());
    cairo_text_path(context(), text.text.c_str());
    if (text.halo) {
      choose(*text.halo);
      cairo_set_line_width(context(), 3.0);
      cairo_set_dash(context(), nullptr, 0, 0.0);
      cairo_stroke_preserve(context());
    }
    choose(text.color);
    cairo_fill(context());
  }

  void operator()(const PageImage& image) const {
    const std::size_t height = image.points.size() / image.width;
    const Surface points = make_surface(static_cast<int>(image.width), static_cast<int>(height));
    cairo_surface_flush(points.get());
    unsigned char* data = cairo_image_surface_get_data(points.get());
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(points.get()));
    for (std::size_t row = 0; row < height; ++row)
      for (std::size_t column = 0; column < image.width; ++column)
        reinterpret_cast<Rgb*>(data + row * stride)[column] = image.points[row * image.width + column];
    cairo_surface_mark_dirty(points.get());
    cairo_save(context());
    cairo_translate(context(), image.corner.x(), image.corner.y());
    cairo_scale(context(), image.size.x() / static_cast<double>(image.width),
                image.size.y() / static_cast<double>(height));
    cairo_set_source_surface(context(), points.get(), 0.0, 0.0);
    cairo_paint(context());
    cairo_restore(context());
  }

 private:
  void choose(Rgb color) const {
    cairo_set_source_rgb(context(), (color >> 16U & 0xFFU) / 255.0, (color >> 8U & 0xFFU) / 255.0,
                         (color & 0xFFU) / 255.0);
  }

  void trace(const std::vector<PageLine>& lines, bool closed) const {
    cairo_new_path(context());
    for (const PageLine& line : lines) {
      if (line.empty()) continue;
      cairo_move_to(context(), line.front().x(), line.front().y());
      for (const PagePoint& point : line) cairo_line_to(context(), point.x(), point.y());
      if (closed || (line.size() > 2 && line.front() == line.back())) cairo_close_path(context());
    }
  }

  Context context_;
};

}  // namespace

std::string as_png(const PagePicture& picture, double scale) {
  const Surface surface =
      make_surface(static_cast<int>(scale * picture.width), static_cast<int>(scale * picture.height));
  const Painter painter(surface.get());
  cairo_scale(painter.context(), scale, scale);
  cairo_set_source_rgb(painter.context(), 1.0, 1.0, 1.0);
  cairo_paint(painter.context());
  for (const PageElement& element : picture.elements) std::visit(painter, element);
  require(cairo_status(painter.context()));
  std::string text;
  require(cairo_surface_write_to_png_stream(surface.get(), append, &text));
  return text;
}

}  // namespace parallel_aspects
