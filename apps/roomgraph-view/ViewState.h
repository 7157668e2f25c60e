#pragma once
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "View.h"

namespace roomgraph {

/** What the mouse and the arrows are for. */
enum class Mode {
  look,     ///< click: read; arrows: walk
  measure,  ///< click: a corner more of the line that is measured
  nudge,    ///< arrows: move the run
  swipe,    ///< the run is seen left of a line, the other one right of it
};

/** The layer that shows where runs disagree. */
constexpr const char* kDisagreement = "disagreement";

/** What of a view is shown. */
struct ViewState {
  std::size_t run = 0;               ///< whose way is walked
  std::optional<std::size_t> other;  ///< what the run is held against; else the best other one
  std::size_t frame = 0;             ///< place in the path of that run
  std::optional<std::size_t> fault;  ///< that is looked at, of View::faults
  std::optional<std::size_t> stage;  ///< of the extraction, see stageNames(); none for its result
  Mode mode = Mode::look;
  bool isPlaying = false;       ///< goes on by itself
  bool isFlickering = false;    ///< the run and the other one in turn
  bool isFlicked = false;       ///< it is the other one's turn
  bool growsMap = false;        ///< all that was seen up to the key frame, and no map
  bool showsKeys = false;       ///< all keys are listed
  std::optional<double> swipe;  ///< where the line of Mode::swipe is [m, x of the screen]
  Transform2D nudge;            ///< how far the run was moved by hand, site <- site
  std::vector<Point> corners;   ///< of the line that is measured [m]
  std::optional<Point> read;    ///< the place that was clicked last [m]
  std::set<std::string> hidden{kDisagreement};  ///< layers, by name
};

// What the user may ask for, by a key or a button: as much of it is done as there is to show.

/** So many key frames along the path of the run. */
void stepFrames(bool isForward, std::size_t by, const View& view, ViewState& state);
void stepFault(bool isForward, const View& view, ViewState& state);
void stepStage(bool isForward, const View& view, ViewState& state);
void nextRun(const View& view, ViewState& state);
void nextOther(const View& view, ViewState& state);
void play(const View& view, ViewState& state);
void flicker(const View& view, ViewState& state);
/** Into a mode, or out of it. */
void changeMode(Mode mode, const View& view, ViewState& state);
void showOrHide(const std::string& layer, ViewState& state);
/** Ends whatever was begun. */
void leave(ViewState& state);

/** Looks at a fault: its run, and the key frame at which its later time is shown. */
void lookAtFault(std::size_t number, const View& view, ViewState& state);

/** Where in the path of a run this key frame is; the next one that has a scan where it has none. */
std::size_t placeInPath(const View& view, std::size_t run, std::size_t keyFrame);

/** The run that the shown one is held against; none where there is no other. */
std::optional<std::size_t> otherRun(const View& view, const ViewState& state);

/** Moves the run of Mode::nudge by this [m] and turns it by `turn` [rad], about the middle of its
 *  map. */
void nudgeBy(Point shift, double turn, const View& view, ViewState& state);

/** Where a run lies, nudged or not: site <- run. */
Transform2D shownPose(const View& view, const ViewState& state, std::size_t run);

/** Whether there is something that leave() would end. */
bool isBusy(const ViewState& state);

/** The time that flickering and playing need: called every half second of flickering, every tenth
 *  of playing. Whether anything changed. */
bool playOn(const View& view, ViewState& state);
bool flickOn(ViewState& state);

/** How well the run, where it was moved to by hand, lies on the other one. */
struct NudgeFit {
  double overlap = 0;       ///< share of the smaller free space that is free in both
  double found = 0;         ///< share of the walls where the other knows what is there, found again
  double contradicted = 0;  ///< share of them that lies in the other's free space
  double score = 0;         ///< alignmentScore(): of two poses, the higher one is likelier
};

/** None where the map of one of the two is missing. A few ms. */
std::optional<NudgeFit> nudgeFit(const View& view, const ViewState& state);

/** Moves the run from where it is to where its walls fit best near by. */
void fitNudge(const View& view, ViewState& state);

}  // namespace roomgraph
