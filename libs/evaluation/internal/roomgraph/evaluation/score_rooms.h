#pragma once
#include <optional>
#include <string>

#include "roomgraph/grid/LabelMap.h"

namespace roomgraph {

// The measures that are published for room segmentation; mcc as Mielle et al. 2018 propose it
// In:   the labels of a segmentation and of the truth
// Out:  RoomScore
// Next: roomScoreText, roomScoreJson

/** What was compared: the regions of one of the two pictures. */
struct ScoredRegions {
  LabelMap::Source source;
  std::size_t count = 0;    ///< regions that count
  std::size_t dropped = 0;  ///< those that are too small
  std::size_t pixels = 0;   ///< of those that count
};

/** S are the regions of the segmentation, G those of the truth, |s| the pixels of one, O[s,g] the
 *  pixels that s and g share. Shares are 0 to 1. None where there is nothing to take a mean of: P
 *  and iouSeg without any s, R and iouTruth without any g, mcc without either. If only the other
 *  side is without regions, they are 0. */
struct RoomScore {
  int width = 0, height = 0;       ///< pixels
  std::size_t largestDropped = 0;  ///< regions of at most so many pixels do not count [px]
  ScoredRegions seg, truth;
  std::size_t pixelsInBoth = 0;          ///< sum of O
  std::size_t pairs = 0;                 ///< matched one to one for mcc
  std::optional<double> precisionMicro;  ///< mean over s of max_g O[s,g] / |s|
  std::optional<double> precisionMacro;  ///< sum over s of max_g O[s,g] / sum over s of |s|
  std::optional<double> recallMicro;     ///< mean over g of max_s O[s,g] / |g|
  std::optional<double> recallMacro;     ///< sum over g of max_s O[s,g] / sum over g of |g|
  std::optional<double> iouSeg;          ///< mean over s of O / |s or g|, g that of largest O
  std::optional<double> iouTruth;        ///< mean over g of O / |s or g|, s that of largest O
  std::optional<double> mcc;             ///< -1 to 1, see scoreRooms()
};

/** Compares two pictures of regions of one map, pixel by pixel. A region is all pixels of one label
 *  other than 0, connected or not. Regions of at most `largestDropped` pixels are dropped:
 *  their pixels count as unlabelled. A region without any common pixel counts as 0 in the means.
 *
 *  mcc is the mean Matthews correlation coefficient of regions paired one to one, over the pixels
 *  that both sides label, and these alone. Pairs are taken greedily by O, largest first; a region
 *  is in one pair at most, and a pair shares pixels. With N the sum of all O,
 *    tp = O[s,g]                         fp = sum over g' of O[s,g'] - tp
 *    tn = N - tp - fp - fn               fn = sum over s' of O[s',g] - tp
 *    mcc of a pair = (tp tn - fp fn) / sqrt((tp + fp) (tp + fn) (tn + fp) (tn + fn))
 *  Where that is 0 / 0, as one of the two covers all N pixels, it is 1 if both do, else 0. Regions
 *  of either side that are in no pair count as 0: the mean is over pairs, other s and other g. (The
 *  program that was published with the paper differs: its tn is N - fp + tp + fn, and regions
 *  without any common pixel do not count.)
 *
 *  Ties of O, here and for the largest partner, go to the pair of the greater intersection over
 *  union, then to that whose first common pixel comes first in the map. So the numbers of labels
 *  mean nothing; exchanging the two maps exchanges P with R and iouSeg with iouTruth and leaves
 *  mcc. Deterministic. Expected O(pixels + p log p) for p pairs that share a pixel.
 *  @throws DataError where the maps differ in size; it names both. */
RoomScore scoreRooms(const LabelMap& seg, const LabelMap& truth, std::size_t largestDropped = 100);

/** One number per line, with its name before it and what it is behind it; "-" where it has no
 *  value. The columns are aligned. */
std::string roomScoreText(const RoomScore& score);

/** The same, with the hashes of the files and the program's version; null where there is no value.
 *  Rounded to 4 decimals, mcc to 6. One member per line. */
std::string roomScoreJson(const RoomScore& score);

}  // namespace roomgraph
