#include "render.h"

#include <cairo-svg.h>

#include <cstring>
#include <map>
#include <memory>

#include "View.h"
#include "draw_frame.h"
#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

// An image is a source- since Cairo 1.18.
constexpr const char* kMarks[] = {"id=\"image", "\"#image",     "id=\"source-",
                                  "\"#source-", "id=\"surface", "\"#surface"};

/** The next mention of such an id and the place of its digits; npos where there is none. */
std::size_t findMention(const std::string& svg, std::size_t from, std::size_t& digits) {
  std::size_t first = std::string::npos;
  for (const std::string mark : kMarks) {
    const std::size_t found = svg.find(mark, from);
    if (found >= first) continue;
    first = found;
    digits = found + mark.size();
  }
  return first;
}

void addSquaresHint(std::string& svg) {
  const std::string tag = "<image ";
  const std::size_t found = svg.find(tag);
  if (found != std::string::npos)
    svg.insert(found + tag.size(), "image-rendering=\"optimizeSpeed\" ");
}

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Cairo = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

Surface own(cairo_surface_t* surface) { return Surface(surface, cairo_surface_destroy); }

/** Pictures are bounded in size, so only memory can run out. */
void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw DataError(std::string("the picture cannot be drawn (") + cairo_status_to_string(status) +
                    "): free some memory");
}

Surface imageSurface(cairo_format_t format, int width, int height) {
  Surface surface = own(cairo_image_surface_create(format, width, height));
  check(cairo_surface_status(surface.get()));
  return surface;
}

Surface backdropSurface(const PaletteImage& image) {
  Surface surface = imageSurface(CAIRO_FORMAT_RGB24, image.width, image.height);
  unsigned char* pixels = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  std::vector<std::uint32_t> words;
  for (const Colour c : image.palette)
    words.push_back(std::uint32_t(c.red) << 16 | std::uint32_t(c.green) << 8 | c.blue);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* row = &image.indices[std::size_t(y) * std::size_t(image.width)];
    unsigned char* out = pixels + std::ptrdiff_t(image.height - 1 - y) * stride;
    for (int x = 0; x < image.width; ++x)
      std::memcpy(out + std::ptrdiff_t(4) * x, &words[row[x]], 4);
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

/** The file's bytes go into an SVG as they are, much smaller and quicker than what cairo writes. */
void attachPng(cairo_surface_t* surface, const PaletteImage& image) {
  auto* png = new std::string(pngBytes(image));
  const auto release = [](void* bytes) { delete static_cast<std::string*>(bytes); };
  const cairo_status_t status = cairo_surface_set_mime_data(
      surface, CAIRO_MIME_TYPE_PNG, reinterpret_cast<const unsigned char*>(png->data()),
      png->size(), release, png);
  if (status != CAIRO_STATUS_SUCCESS) release(png);
  check(status);
}

/** Text comes out alike, wherever on the pixel raster it stands. */
void setFontOptions(cairo_t* cairo) {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cairo, options);
  cairo_font_options_destroy(options);
}

void drawSheet(cairo_surface_t* target, const Scene& scene, const View& view, const Layout& layout,
               cairo_surface_t* backdrop) {
  const Cairo cairo(cairo_create(target), cairo_destroy);
  cairo_t* c = cairo.get();
  setFontOptions(c);
  cairo_set_source_rgb(c, 1, 1, 1);
  cairo_paint(c);
  cairo_save(c);
  cairo_translate(c, layout.map.x, layout.map.y);
  cairo_rectangle(c, 0, 0, view.widthPx(), view.heightPx());
  cairo_clip(c);
  cairo_save(c);
  cairo_scale(c, view.magnify, view.magnify);
  cairo_set_source_surface(c, backdrop, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(c), CAIRO_FILTER_NEAREST);
  cairo_paint(c);
  cairo_restore(c);
  if (scene.layers) scene.layers(Pen(c, view));
  cairo_restore(c);
  drawFrame(c, scene, view, layout);
  check(cairo_status(c));
}

cairo_status_t append(void* text, const unsigned char* data, unsigned int size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string finishedSvg(const std::string& svg) {
  std::string result;
  std::map<std::string, std::size_t> number;
  std::size_t copied = 0, digits = 0;
  while (findMention(svg, copied, digits) != std::string::npos) {
    const std::size_t end = svg.find_first_not_of("0123456789", digits);
    const std::string old = svg.substr(digits, end - digits);
    const std::size_t own = number.emplace(old, number.size() + 1).first->second;
    result.append(svg, copied, digits - copied);
    result += std::to_string(own);
    copied = end;
  }
  result.append(svg, copied);
  addSquaresHint(result);
  return result;
}

std::string renderPng(const Grid& grid, const Scene& scene) {
  const View view = viewOf(grid);
  const Layout layout = layoutOf(scene, view);
  const Surface map = backdropSurface(backdrop(grid, view));
  const Surface sheet = imageSurface(CAIRO_FORMAT_RGB24, layout.width, layout.height);
  drawSheet(sheet.get(), scene, view, layout, map.get());
  cairo_surface_flush(sheet.get());
  return pngBytes(cairo_image_surface_get_data(sheet.get()), layout.width, layout.height,
                  cairo_image_surface_get_stride(sheet.get()));
}

std::string renderSvg(const Grid& grid, const Scene& scene) {
  const View view = viewOf(grid);
  const Layout layout = layoutOf(scene, view);
  const PaletteImage image = backdrop(grid, view);
  const Surface map = backdropSurface(image);
  attachPng(map.get(), image);
  std::string svg;
  {
    const Surface sheet =
        own(cairo_svg_surface_create_for_stream(append, &svg, layout.width, layout.height));
    check(cairo_surface_status(sheet.get()));
    cairo_svg_surface_set_document_unit(sheet.get(), CAIRO_SVG_UNIT_PX);
    drawSheet(sheet.get(), scene, view, layout, map.get());
    cairo_surface_finish(sheet.get());
    check(cairo_surface_status(sheet.get()));
  }
  return finishedSvg(svg);
}

}  // namespace roomgraph
