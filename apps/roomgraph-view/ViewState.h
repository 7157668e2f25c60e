#pragma once
#include <cstddef>
#include <optional>
#include <set>
#include <string>

#include "View.h"

namespace roomgraph {

/** What of a view is shown. */
struct ViewState {
  std::size_t run = 0;              ///< whose way is walked
  std::size_t frame = 0;            ///< key frame of that run
  std::optional<std::size_t> tear;  ///< the break that is looked at, of Comparison::breaks
  bool isPlaying = false;           ///< goes on by itself
  bool isFlickering = false;        ///< the run and the best other one in turn
  bool isFlicked = false;           ///< it is the other one's turn
  bool growsMap = false;            ///< all that was seen up to the key frame
  std::set<std::string> hidden;     ///< layers, by name
};

/** What the user may ask for, by a key or a button. */
enum class Wish {
  nextFrame,
  previousFrame,
  tenOn,
  tenBack,
  firstFrame,
  lastFrame,
  play,
  nextRun,
  nextBreak,
  previousBreak,
  flicker,
  grow,
};

/** Makes a wish true, as far as there is something to show. */
void fulfil(Wish wish, const View& view, ViewState& state);

/** Looks at a break: its run, and the first key frame behind it. */
void lookAtBreak(std::size_t tear, const View& view, ViewState& state);

/** The time that flickering and playing need: called every half second of flickering, every tenth
 *  of playing. Whether anything changed. */
bool playOn(const View& view, ViewState& state);
bool flickOn(ViewState& state);

}  // namespace roomgraph
