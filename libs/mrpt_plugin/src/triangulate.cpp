#include "triangulate.h"

#include <GL/glu.h>

#include <deque>
#include <memory>
#include <new>

namespace roomgraph {
namespace {

/** What GLU's tessellator is given and gives back. */
struct Tessellation {
  std::deque<std::array<GLdouble, 3>> corners;  // a deque: GLU keeps pointers to them
  std::vector<Point> out;                       // three for each triangle
};

const GLdouble* keepCorner(Tessellation& work, const GLdouble xyz[3]) {
  work.corners.push_back({xyz[0], xyz[1], xyz[2]});
  return work.corners.back().data();
}

void onVertex(void* corner, void* work) {
  const auto* xyz = static_cast<const GLdouble*>(corner);
  static_cast<Tessellation*>(work)->out.push_back({xyz[0], xyz[1]});
}

// Where rings touch GLU makes one corner of several.
void onCombine(GLdouble xyz[3], void* [4], GLfloat[4], void** corner, void* work) {
  *corner = const_cast<GLdouble*>(keepCorner(*static_cast<Tessellation*>(work), xyz));
}

// That it is set makes GLU give single triangles, no strips or fans.
void onEdgeFlag(GLboolean, void*) {}

using Callback = void (*)();

void setUp(GLUtesselator* glu) {
  gluTessNormal(glu, 0, 0, 1);
  gluTessProperty(glu, GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_POSITIVE);
  gluTessCallback(glu, GLU_TESS_VERTEX_DATA, reinterpret_cast<Callback>(onVertex));
  gluTessCallback(glu, GLU_TESS_COMBINE_DATA, reinterpret_cast<Callback>(onCombine));
  gluTessCallback(glu, GLU_TESS_EDGE_FLAG_DATA, reinterpret_cast<Callback>(onEdgeFlag));
}

void addRing(GLUtesselator* glu, const Ring& ring, Tessellation& work) {
  gluTessBeginContour(glu);
  for (const Point p : ring) {
    const GLdouble xyz[3] = {p.x, p.y, 0};
    auto* corner = const_cast<GLdouble*>(keepCorner(work, xyz));
    gluTessVertex(glu, corner, corner);
  }
  gluTessEndContour(glu);
}

}  // namespace

std::vector<Triangle> triangulate(const Polygon& polygon) {
  const std::unique_ptr<GLUtesselator, void (*)(GLUtesselator*)> glu(gluNewTess(), gluDeleteTess);
  if (!glu) throw std::bad_alloc();
  setUp(glu.get());
  Tessellation work;
  gluTessBeginPolygon(glu.get(), &work);
  forEachRing(polygon, [&](const Ring& ring) { addRing(glu.get(), ring, work); });
  gluTessEndPolygon(glu.get());
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i + 2 < work.out.size(); i += 3)
    triangles.push_back({work.out[i], work.out[i + 1], work.out[i + 2]});
  return triangles;
}

}  // namespace roomgraph
