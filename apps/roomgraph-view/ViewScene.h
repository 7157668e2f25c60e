#pragma once
#include <string>
#include <vector>

#include "ViewState.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"

namespace roomgraph {

/** What a layer is called: one that holds the walls of a run as that run is. */
std::string nameOfLayer(const std::string& layer);

/** A view in 3D. Its objects are made once; update() moves and hides them. */
class ViewScene {
 public:
  /** `view` must live as long as this. */
  explicit ViewScene(const View& view);

  void update(const ViewState& state);
  /** Writes into the picture what readState says of it. */
  void write(const ViewState& state);
  /** Draws the graph anew after extractAgain(). */
  void drawGraphAgain();

  MrptScene::Ptr scene() const { return scene_; }
  /** What can be switched on and off, from below to above. */
  const std::vector<std::string>& layers() const { return layers_; }
  /** Round all that there is, as the screen has it [m]. */
  Box box() const { return box_; }
  /** The same round what is to be seen of a fault [m]. */
  Box boxAt(const Fault& fault) const;

 private:
  void addComparison();
  void addPaths();
  void addLayer(const std::string& name, const viz::CSetOfObjects::Ptr& objects);
  bool isAtFault(const ViewState& state) const;
  void updateFrame(const ViewState& state);
  void updateFault(const ViewState& state);
  void updateStage(const ViewState& state);
  void updateMarks(const ViewState& state);
  void hideLayers(const ViewState& state);
  void hideRuns(const ViewState& state);
  void hideGraph(const ViewState& state);

  const View& view_;
  MrptScene::Ptr scene_;
  std::vector<std::string> layers_;
  viz::CSetOfObjects::Ptr frame_, fault_, stage_, marks_;
  std::optional<std::size_t> shownFault_, shownStage_;
  Box box_;
};

/** What is near enough and far enough to be drawn from this far away [m]; layers that lie close to
 *  each other are not told apart where the range is too wide. */
void clipFor(double away, MrptScene& scene);

/** Makes the camera of the scene look straight down at all of the box [m] of the scene turned by
 *  `turn` [rad] about its origin, in a picture that is `aspect` times as wide as high. Returns how
 *  far away it is then [m]. */
double lookDown(MrptScene& scene, const Box& box, double turn, double aspect);

}  // namespace roomgraph
