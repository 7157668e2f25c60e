#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/grid/GridFrame.h"
#include "roomgraph/repair/CarriedPlace.h"

namespace roomgraph {

/** What somebody has marked on a map: a goal, a lane, a zone. */
struct Thing {
  std::string name;
  std::vector<std::size_t> places;    ///< what it is made of, in MarkedFile::places
  std::vector<std::size_t> around{};  ///< more of these, which give its shape but are no part of it
};

/** A thing on another map: as sure as the least sure of its places. */
struct CarriedThing {
  CarryState state = CarryState::carried;
  std::optional<double> error;  ///< of the place that may be farthest off [m]; none if not known
  std::string reason;           ///< of any state but carried, one line
  /** new map <- place, of each of its places, then of those around it; one of which nothing is
   *  known lies to the nearest known one as it lay. */
  std::vector<Transform2D> poses;
};

/** A file as it is written. */
struct NamedBytes {
  std::string name;  ///< without a folder
  std::string bytes;
};

/** A file of things that were marked on a map. */
struct MarkedFile {
  const char* kind = "place";  ///< what its things are called, one of them
  std::vector<Place> places;   ///< each once, however many things it belongs to
  std::vector<Thing> things;
  std::vector<std::string> files{};  ///< names of what write() gives, in its order
  /** The same file with its things on another map, which has this frame; all else stays. The
   *  files that belong to it come with it. */
  std::function<std::vector<NamedBytes>(const std::vector<CarriedThing>&, const GridFrame&)> write;
};

/** Reads what somebody has marked on a map. The content tells the format: a table, GeoJSON, a
 *  site.json, osmAG, or a mask of nav2.
 *  @throws DataError with one line where it is none, or damaged. */
MarkedFile readMarked(const std::string& file);

/** Whether this is the content of a file whose things have been carried: they have a state. */
[[nodiscard]] bool isCarried(const std::string& text);

}  // namespace roomgraph
