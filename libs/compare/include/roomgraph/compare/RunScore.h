#pragma once
#include <cstddef>
#include <string>

namespace roomgraph {

/** The least share of the site that a run must have seen to be a map of all of it, of its map that
 *  others must bear out for a word on all of it, and of its walls that they must have. */
constexpr double kNearlyAll = 0.7;
/** A run whose key frames lie off each on its own by so much, RMS, is smeared: it breaks at each of
 *  them [m]. */
constexpr double kSmeared = 0.1;

/** Of what a run and the reference found of each other, the share that the consensus may give up:
 *  more does not stray, one of both is broken. */
constexpr double kMostGivenUp = 0.1;

/** What the walls of one run say against those of the others. */
struct RunScore {
  double share = 0;  ///< of the walls that the others have, too, each weighted by its trust
  double mapError = 0, errorLow = 0, errorHigh = 0;  ///< estimate of the true map error [m]
  double score = 100, low = 100, high = 100;         ///< 0 to 100, falls with the map error
  double trust = 0;        ///< weight of this run in the consensus, the largest of all runs is 1
  double support = 0;      ///< wall points that were compared
  std::size_t others = 0;  ///< runs it was compared with
  /** Shares of what it has drawn: what another run bears out, and what others contradict without
   *  knowing where it belongs. What is neither lies where no other run has been. */
  double confirmed = 1, contradicted = 0;
  double givenUp = 0;  ///< share of the matches with the reference that contradict the rest
  double jitter = 0;   ///< RMS by which its key frames lie off each on its own, in mapError [m]
  /** How long it has drawn what the consensus has 1 m long; 1 where that is less than 0.5 % off, or
   *  does not show. */
  double scale = 1;
  /** The runs fall into two sets of other scales, and which is right does not show. */
  bool isScaleDisputed = false;
  bool isMeaningful = false;  ///< see scoreRuns
  /** Whether an end of its interval is off from its error by more than a factor of 2 and 0.1 m. */
  [[nodiscard]] bool isWide() const {
    return errorHigh > 2 * mapError + 0.1 || mapError > 2 * errorLow + 0.1;
  }
  /** Whether it and the reference fit each other as wholes; true where there is none. */
  [[nodiscard]] bool fitsReference() const { return givenUp <= kMostGivenUp; }
};

/** What speaks against a map as a whole, as a sentence without its subject: that others contradict
 *  some of it, or bear out less than kNearlyAll. What it lacks of what they have counts against it
 *  as well, up to as much as nobody bears out: a part that is drawn in a wrong place is both. Empty
 *  for nothing. `coverage`: 1 where it is not known. */
[[nodiscard]] std::string unconfirmedFault(double confirmed, double contradicted, double coverage);

}  // namespace roomgraph
