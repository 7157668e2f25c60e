#include "look_from_above.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/mrpt_plugin/colours.h"

namespace roomgraph {

void lookFromAbove(MrptScene& scene, const Box& box, double turn) {
  const auto view = scene.getViewport();
  view->setCustomBackgroundColor({kBackgroundColour.red / 255.F, kBackgroundColour.green / 255.F,
                                  kBackgroundColour.blue / 255.F});
  scene.enableFollowCamera(true);  // else SceneViewer3D looks from where it likes
  // Even light, so that the colours are those of the legend: the files know no unlit triangles.
  makeEven(view->lightParameters());
  const Point middle = Transform2D{0, 0, -turn}(midpoint(box.low, box.high));
  const Point size = box.high - box.low;
  auto& camera = view->getCamera();
  camera.setPointingAt(float(middle.x), float(middle.y), 0);
  camera.setAzimuthDegrees(float(-90 - turn * 180 / M_PI));  // what is turned has its y up
  camera.setElevationDegrees(70);
  camera.setProjectiveFOVdeg(30);
  // The whole box in a window that is wider than high.
  const double half = std::max(size.y, 0.75 * size.x) / 2;
  camera.setZoomDistance(float(1.1 * half / std::tan(M_PI / 12)));
}

}  // namespace roomgraph
