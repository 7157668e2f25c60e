#include "start_poses.h"

#include <deque>
#include <optional>
#include <utility>

namespace roomgraph {
namespace {

using Found = std::vector<std::optional<Transform2D>>;

/** Runs that are brought into one frame, one after the other. */
class Placing {
 public:
  Placing(const std::vector<RunSubmaps>& runs, const std::vector<RunMatches>& matches)
      : runs_(runs), matches_(matches), poses_(runs.size()), isPlaced_(runs.size()) {
    for (std::size_t r = 0; r < runs.size(); ++r)
      for (const Submap& submap : runs[r].submaps) poses_[r].push_back(submap.pose);
  }

  SubmapPoses placed(std::size_t pivot) {
    isPlaced_[pivot] = true;
    while (const auto next = mostFound()) {
      poses_[*next] = spread(runs_[*next], foundIn(*next, pivot));
      isPlaced_[*next] = true;
    }
    return std::move(poses_);
  }

 private:
  /** The run of which most was found in those that are placed, of equal ones the first. */
  std::optional<std::size_t> mostFound() const {
    std::vector<std::size_t> counts(runs_.size());
    for (const RunMatches& pair : matches_)
      if (isPlaced_[pair.in] != isPlaced_[pair.of])
        counts[isPlaced_[pair.in] ? pair.of : pair.in] += pair.matches.size();
    std::optional<std::size_t> most;
    for (std::size_t r = 0; r < counts.size(); ++r)
      if (counts[r] > 0 && (!most || counts[r] > counts[*most])) most = r;
    return most;
  }

  /** Where the submaps of a run were found: in the pivot, else in another run that is placed. */
  Found foundIn(std::size_t run, std::size_t pivot) const {
    Found found(runs_[run].submaps.size());
    for (const bool isPivot : {true, false})
      for (const RunMatches& pair : matches_) {
        if (pair.of == run && isPlaced_[pair.in] && (pair.in == pivot) == isPivot)
          for (const SubmapMatch& match : pair.matches)
            if (!found[match.submap]) found[match.submap] = poses_[pair.in][match.in] * match.pose;
        if (pair.in == run && isPlaced_[pair.of] && (pair.of == pivot) == isPivot)
          for (const SubmapMatch& match : pair.matches)
            if (!found[match.in])
              found[match.in] = poses_[pair.of][match.submap] * match.pose.inverse();
      }
    return found;
  }

  /** Lets what was not found keep its pose to the nearest submap that was, along the links. */
  static std::vector<Transform2D> spread(const RunSubmaps& run, const Found& found) {
    std::vector<std::vector<std::uint32_t>> beside(run.submaps.size());
    for (const SubmapLink& link : run.links)
      beside[link.from].push_back(link.to), beside[link.to].push_back(link.from);
    std::vector<Transform2D> carry(run.submaps.size());  // site <- run
    std::vector<bool> isKnown(run.submaps.size());
    std::deque<std::uint32_t> front;
    for (std::uint32_t k = 0; k < found.size(); ++k)
      if (found[k]) {
        carry[k] = *found[k] * run.submaps[k].pose.inverse();
        isKnown[k] = true;
        front.push_back(k);
      }
    const Transform2D any = front.empty() ? Transform2D{} : carry[front.front()];
    for (; !front.empty(); front.pop_front())
      for (const std::uint32_t next : beside[front.front()])
        if (!isKnown[next]) {
          carry[next] = carry[front.front()];
          isKnown[next] = true;
          front.push_back(next);
        }
    std::vector<Transform2D> poses;
    for (std::size_t k = 0; k < run.submaps.size(); ++k)
      poses.push_back((isKnown[k] ? carry[k] : any) * run.submaps[k].pose);
    return poses;
  }

  const std::vector<RunSubmaps>& runs_;
  const std::vector<RunMatches>& matches_;
  SubmapPoses poses_;
  std::vector<bool> isPlaced_;
};

}  // namespace

SubmapPoses startPoses(const std::vector<RunSubmaps>& runs, const std::vector<RunMatches>& matches,
                       std::size_t pivot) {
  return Placing(runs, matches).placed(pivot);
}

}  // namespace roomgraph
