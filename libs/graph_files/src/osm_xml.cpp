#include "roomgraph/graph_files/osm_xml.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "roomgraph/base/Json.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/xml_text.h"
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/geometry/thinned_line.h"
#include "roomgraph/graph_files/OsmOrigin.h"
#include "roomgraph/rooms/reason_names.h"
#include "roomgraph/topology/kind_names.h"

namespace roomgraph {
namespace {

/** Keys and values are our own words and numbers, so there is nothing to escape, but in names. */
std::string tag(const char* key, const std::string& value) {
  return std::string("    <tag k=\"") + key + "\" v=\"" + value + "\"/>\n";
}

std::string element(const char* kind, std::int64_t id) {
  return std::string("  <") + kind + " id=\"" + std::to_string(id) +
         "\" action=\"modify\" visible=\"true\"";
}

const char* kindName(const Area& area) { return area.isRoom() ? "room" : "corridor"; }

/** Whether `p` lies between `a` and `b`, to 1 micrometre. */
bool isOnTheWay(Point a, Point p, Point b) {
  return std::abs(cross(p - a, b - p)) <= 1e-6 * distance(a, b) && dot(p - a, b - p) > 0;
}

/** The place on the map that has the root: (0, 0), unless the Earth is not flat from there on. */
Point rootOf(const AreaGraph& graph) {
  Box box;
  double farthest = 0;
  for (const Area& area : graph.areas)
    for (const Point corner : area.polygon.outer)
      box.include(corner), farthest = std::max(farthest, norm(corner));
  if (!(farthest > OsmOrigin::kFlat)) return {};
  const Point middle = 0.5 * (box.low + box.high);
  return {std::round(middle.x), std::round(middle.y)};
}

class OsmWriter {
 public:
  OsmWriter(const AreaGraph& graph, const OsmXmlOptions& options)
      : graph_(graph), options_(options), origin_(0, 0, rootOf(graph)) {
    for (std::size_t p = 0; p < graph.passages.size(); ++p) {
      const Passage& passage = graph.passages[p];
      if (!passage.b) continue;
      passages_.push_back(p);
      passageEnds_.insert(passage.from);
      passageEnds_.insert(passage.to);
    }
  }

  std::string run() {
    for (std::size_t a = 0; a < graph_.areas.size(); ++a) addArea(a);
    for (const std::size_t p : passages_) addPassage(p);
    if (!graph_.areas.empty()) addFloor();
    for (std::size_t a = 0; a < graph_.areas.size(); ++a)
      if (!graph_.areas[a].polygon.holes.empty()) addHoles(a);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<osm version=\"0.6\" generator=\"roomgraph\" upload=\"never\">\n" +
           element("node", kRoot) + " lat=\"0.000000000\" lon=\"0.000000000\">\n" +
           tag("name", "root") + rootTags() + "  </node>\n" + nodes_ + ways_ + relations_ +
           "</osm>\n";
  }

 private:
  static constexpr std::int64_t kRoot = -1;

  /** Where on the map it lies, for whoever carries the file to another one. */
  std::string rootTags() const {
    const Point root = origin_.root();
    if (root == Point()) return "";
    return tag(OsmOrigin::kRootX, formatted("%.0f", root.x)) +
           tag(OsmOrigin::kRootY, formatted("%.0f", root.y));
  }

  std::string areaName(AreaId area) const {
    if (!options_.names.empty()) return xmlText(options_.names[area.index()]);
    return std::string(kindName(graph_.areas[area.index()])) + "_" + std::to_string(area.index());
  }

  /** How other things refer to it: areas are the first ways. */
  std::string reference(AreaId area) const {
    return options_.hasNumbers ? std::to_string(-1 - std::int64_t(area.index())) : areaName(area);
  }

  std::string parent() const {
    const std::size_t before = graph_.areas.size() + passages_.size();
    return options_.hasNumbers ? std::to_string(-1 - std::int64_t(before)) : "floor_0";
  }

  void addNode(Point p) {
    const auto [known, isNew] = nodeIds_.emplace(p, kRoot - 1 - std::int64_t(nodeIds_.size()));
    if (isNew)
      nodes_ += element("node", known->second) + " lat=\"" + origin_.latitudeText(p) + "\" lon=\"" +
                origin_.longitudeText(p) + "\"/>\n";
    ways_ += "    <nd ref=\"" + std::to_string(known->second) + "\"/>\n";
  }

  /** Returns its id. */
  std::int64_t addWay(const std::vector<Point>& points, const std::string& tags) {
    ways_ += element("way", --lastWay_) + ">\n";
    for (const Point p : points) addNode(p);
    ways_ += tags + "  </way>\n";
    return lastWay_;
  }

  /** Closed; corners on a straight line are left out, but for the ends of passages. */
  std::int64_t addRing(const Ring& ring, const std::string& tags) {
    Ring kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point last = kept.empty() ? ring.back() : kept.back();
      if (passageEnds_.count(ring[i]) || !isOnTheWay(last, ring[i], ring[(i + 1) % ring.size()]))
        kept.push_back(ring[i]);
    }
    return addWay(closed(kept), tags);
  }

  /** With the first corner at the end, too, and as few corners as options_.tolerance allows. */
  Ring closed(Ring ring) const {
    if (ring.empty()) return ring;
    if (options_.tolerance <= 0) {
      ring.push_back(ring.front());
      return ring;
    }
    const auto isEnd = [&](Point p) { return passageEnds_.count(p) > 0; };
    const auto first = std::find_if(ring.begin(), ring.end(), isEnd);
    if (first != ring.end()) std::rotate(ring.begin(), first, ring.end());
    ring.push_back(ring.front());
    Ring thinned{ring.front()};
    for (std::size_t from = 0, to = 1; to < ring.size(); ++to) {
      if (to + 1 < ring.size() && !isEnd(ring[to])) continue;
      const Polyline piece =
          thinnedLine({ring.begin() + std::ptrdiff_t(from), ring.begin() + std::ptrdiff_t(to) + 1},
                      options_.tolerance);
      thinned.insert(thinned.end(), piece.begin() + 1, piece.end());
      from = to;
    }
    return thinned.size() > 3 ? thinned : ring;
  }

  void addFloor() {
    Ring corners;
    for (const Area& area : graph_.areas)
      corners.insert(corners.end(), area.polygon.outer.begin(), area.polygon.outer.end());
    Ring hull = convexHull(std::move(corners));
    hull.push_back(hull.front());
    addWay(hull, tag("height", "0") + tag("indoor", "level") + tag("level", "0") +
                     tag("name", "floor_0") + tag("osmAG:areaType", "structure") +
                     tag("osmAG:type", "area"));
  }

  void addArea(std::size_t a) {
    const Area& area = graph_.areas[a];
    addRing(area.polygon.outer, tag("height", "0") + tag("indoor", kindName(area)) +
                                    tag("level", "0") + tag("name", areaName(AreaId(a))) +
                                    tag("osmAG:areaType", kindName(area)) +
                                    tag("osmAG:parent", parent()) + tag("osmAG:type", "area"));
  }

  void addPassage(std::size_t p) {
    const Passage& passage = graph_.passages[p];
    std::string tags = tag("level", "0") + tag("name", "passage_" + std::to_string(p)) +
                       tag("osmAG:from", reference(passage.a)) +
                       tag("osmAG:to", reference(passage.b)) + tag("osmAG:type", "passage");
    tags += tag("roomgraph:confidence", numberText(rounded(passage.evidence.confidence))) +
            tag("roomgraph:evidence", nameOf(passage.evidence.reason));
    addWay({passage.from, passage.to}, tags + tag("width", numberText(rounded(passage.width))));
  }

  void addHoles(std::size_t a) {
    const auto member = [](std::int64_t way, const char* role) {
      return "    <member type=\"way\" ref=\"" + std::to_string(way) + "\" role=\"" + role +
             "\"/>\n";
    };
    relations_ +=
        element("relation", --lastRelation_) + ">\n" + member(-1 - std::int64_t(a), "outer");
    for (const Ring& hole : graph_.areas[a].polygon.holes)
      relations_ += member(addRing(hole, ""), "inner");
    relations_ += tag("type", "multipolygon") + "  </relation>\n";
  }

  const AreaGraph& graph_;
  const OsmXmlOptions& options_;
  OsmOrigin origin_;
  std::vector<std::size_t> passages_;  // of two areas
  std::set<Point> passageEnds_;
  std::map<Point, std::int64_t> nodeIds_;
  std::int64_t lastWay_ = 0, lastRelation_ = 0;
  std::string nodes_, ways_, relations_;
};

}  // namespace

std::string osmXml(const AreaGraph& graph, const OsmXmlOptions& options) {
  return OsmWriter(graph, options).run();
}

}  // namespace roomgraph
