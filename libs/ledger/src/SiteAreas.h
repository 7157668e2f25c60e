#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/grid/GridFrame.h"
#include "roomgraph/relate/Site.h"
#include "roomgraph/rooms/AreaGraph.h"

namespace roomgraph {

/** A room or corridor as one run draws it. */
struct SiteShape {
  Polygon polygon;             ///< [m, site frame]
  std::vector<Point> samples;  ///< of one that is looked for in other runs, see sampled()
  std::size_t size = 0;        ///< how many samples it has, or would have
  Point middle;                ///< centre of mass
  Point drawn;                 ///< where that would lie by the pose of the whole run
  double area = 0;             ///< [m2]
  bool isCorridor = false;
};

/** An opening of an area. */
struct AreaDoor {
  std::size_t to = 0;  ///< the area behind it
  Point from, end;     ///< its two ends [m, site frame]
};

/** The areas of one run, laid down in the site's frame. */
struct RunAreas {
  /** Of a cell; those of an area are firstArea + its index. */
  enum Label : std::uint16_t { unknown, occupied, free, firstArea };

  double weight = 0;                         ///< of what it says
  std::vector<SiteShape> shapes;             ///< by area
  std::vector<std::vector<AreaDoor>> doors;  ///< of each area
  std::vector<std::uint16_t> labels;         ///< per cell of the frame
  std::vector<bool> isWall;  ///< per cell; those that bound areas are labelled as these
  bool isOpenTo(std::size_t a, std::size_t b) const;
};

/** The areas of all runs of a site. */
struct SiteAreas {
  GridFrame frame;  ///< round all areas
  std::vector<RunAreas> runs;
};

/** The shape with samples that are spread evenly over it, on one raster for all shapes. They take
 *  most of the memory of a shape. O(cells of its box). */
SiteShape sampled(SiteShape shape, const GridFrame& frame);

/** Lays down the areas of all runs, each where it really lies by the consensus, without samples.
 *  Weights are the fourth root of the runs' trust, and at least 0.1: good walls do not make good
 *  rooms, so several fair runs have a say against the best. All 1 where no run has any trust.
 *  O(runs * cells of the site). */
SiteAreas siteAreas(const Site& site, const Consensus& consensus, const Trust& trust);

/** The same, with samples, for one run whose areas are in the site's frame and which knows all
 *  there is. */
RunAreas areasIn(const AreaGraph& areas, const GridFrame& frame);

/** A frame round the outlines, with cells of 0.1 m, or larger where there would be too many. */
GridFrame frameRound(const std::vector<const Polygon*>& polygons);

}  // namespace roomgraph
