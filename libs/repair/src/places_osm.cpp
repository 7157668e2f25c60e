#include <expat.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <set>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/Json.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/read_document.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/xml_text.h"
#include "roomgraph/graph_files/OsmOrigin.h"
#include "roomgraph/repair/places_formats.h"

// Expat 2.9 has these functions with 64 bits, too, and warns of them; Expat 2.5 has no others.
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace roomgraph {
namespace {

constexpr double kMostLatitude = 85;  // beyond, maps of the Earth have no east and west [degrees]
constexpr const char* kSaveInJosm = "save it in JOSM as .osm";

using Attributes = std::vector<std::pair<std::string, std::string>>;

/** Bytes of the text. */
struct Span {
  std::size_t begin = 0, end = 0;
};

/** An element of the text: a node or way. */
struct Element {
  bool isNode = false;
  std::size_t line = 0;
  Attributes attributes;
  Span start;           ///< the tag that opens it
  std::size_t end = 0;  ///< where the tag that closes it begins; that of `start` if there is none
  std::vector<std::string> nodes;  ///< of a way
  Attributes tags;
  std::vector<Span> states;  ///< of tags that will be written anew

  static std::string valueOf(const Attributes& of, const char* name) {
    for (const auto& [key, value] : of)
      if (key == name) return value;
    return "";
  }
  std::string attribute(const char* name) const { return valueOf(attributes, name); }
  std::string tag(const char* name) const { return valueOf(tags, name); }
};

bool isState(const std::string& key) {
  return key == "state" || key == "error_m" || key == "reason";
}

/** Finds the nodes and ways, and where in the text they stand. */
class OsmParser {
 public:
  OsmParser(const std::string& text, const std::string& file)
      : parser_(XML_ParserCreate("UTF-8"), XML_ParserFree) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), onStart, onEnd);
    if (XML_Parse(parser_.get(), text.data(), int(text.size()), 1) != XML_STATUS_OK)
      refuse(file,
             formatted("is not well-formed XML in UTF-8 from line %lu on",
                       (unsigned long)XML_GetCurrentLineNumber(parser_.get())),
             kSaveInJosm);
    if (root_ != "osm") refuse(file, "is not OpenStreetMap's XML", kSaveInJosm);
  }

  std::vector<Element> elements;

 private:
  static void onStart(void* self, const XML_Char* name, const XML_Char** attributes) {
    static_cast<OsmParser*>(self)->start(name, attributes);
  }
  static void onEnd(void* self, const XML_Char* name) { static_cast<OsmParser*>(self)->end(name); }

  Span here() const {
    const std::size_t index = std::size_t(XML_GetCurrentByteIndex(parser_.get()));
    return {index, index + std::size_t(XML_GetCurrentByteCount(parser_.get()))};
  }

  void start(const std::string& name, const XML_Char** attributes) {
    Element element;
    for (; *attributes; attributes += 2)
      element.attributes.emplace_back(attributes[0], attributes[1]);
    if (root_.empty()) root_ = name;
    element.start = here();
    if (inside_ > 0) {
      if (++inside_ > 2) return;
      if (name == "nd") elements.back().nodes.push_back(element.attribute("ref"));
      if (name == "tag") {
        elements.back().tags.emplace_back(element.attribute("k"), element.attribute("v"));
        tag_ = element.start;
      }
    } else if (name == "node" || name == "way") {
      element.isNode = name == "node";
      element.line = std::size_t(XML_GetCurrentLineNumber(parser_.get()));
      elements.push_back(std::move(element));
      inside_ = 1;
    }
  }

  void end(const std::string& name) {
    const Span span = here();
    if (inside_ == 0) return;
    Element& element = elements.back();
    if (--inside_ == 0)  // of an element that is closed at once, there is nothing left here
      element.end = span.begin > element.start.begin ? span.begin : element.start.end;
    else if (inside_ == 1 && name == "tag" && isState(element.tags.back().first))
      element.states.push_back({tag_.begin, std::max(tag_.end, span.end)});
  }

  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::string root_;
  int inside_ = 0;  // so many open elements, of which the first is a node or way
  Span tag_;
};

double degrees(const Element& node, const char* name, const std::string& file) {
  const std::string text = node.attribute(name);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(std::abs(value) <= 180))
    refuse(file, formatted("the node in line %zu has no '%s' in degrees", node.line, name),
           kSaveInJosm);
  return value;
}

/** The pieces of a text that others take the place of. */
class Edits {
 public:
  void replace(Span span, const std::string& text) {
    edits_.emplace(span.begin, std::make_pair(span.end, text));
  }

  std::string applied(const std::string& text) const {
    std::string result;
    std::size_t index = 0;
    for (const auto& [begin, edit] : edits_) {
      result += text.substr(index, begin - index) + edit.second;
      index = edit.first;
    }
    return result + text.substr(index);
  }

 private:
  std::multimap<std::size_t, std::pair<std::size_t, std::string>> edits_;
};

/** A file of osmAG: what it holds, and which of it belongs to which thing. */
class OsmFile {
 public:
  OsmFile(std::string text, const std::string& file)
      : text_(std::move(text)), name_(fileName(file)), elements_(OsmParser(text_, file).elements) {
    const Element* root = findIf(elements_, isRoot);
    if (!root) refuse(file, "has no node tagged name=root, the origin of the map", kSaveInJosm);
    const double latitude = degrees(*root, "lat", file);
    if (std::abs(latitude) > kMostLatitude)
      refuse(file, formatted("has its root at a latitude of %g degrees", latitude),
             "put the root where the map lies");
    const auto metres = [&, far = kFarthestOrigin](const char* key) {
      return std::max(-far, std::min(far, std::atof(root->tag(key).c_str())));
    };
    origin_ = OsmOrigin(latitude, degrees(*root, "lon", file),
                        {metres(OsmOrigin::kRootX), metres(OsmOrigin::kRootY)});
    for (const Element& element : elements_)
      if (element.isNode && !isRoot(element)) addNode(element, file);
    for (const Element& element : elements_)
      if (element.nodes.size() > 2 && element.nodes.front() == element.nodes.back())
        for (const std::size_t place : placesOf(element)) places_[place].isCorner = true;
  }

  MarkedFile marked() const {
    MarkedFile result;
    result.kind = "way", result.files = {name_};
    result.places = places_;
    for (const Element* element : things())
      result.things.push_back({nameOfElement(*element), placesOf(*element)});
    return result;
  }

  NamedBytes written(const std::vector<CarriedThing>& carried) const {
    std::map<std::string, Point> there;
    const std::vector<const Element*> things = this->things();
    for (std::size_t i = 0; i < things.size(); ++i) {
      const std::vector<std::string> nodes = nodesOf(*things[i]);
      for (std::size_t k = 0; k < nodes.size(); ++k) there[nodes[k]] = carried[i].poses[k].shift();
    }
    Edits edits;
    for (const auto& [id, place] : there) moveNode(*nodes_.at(id).first, place, edits);
    for (std::size_t i = 0; i < things.size(); ++i) setState(*things[i], carried[i], edits);
    return {name_, edits.applied(text_)};
  }

 private:
  static bool isRoot(const Element& element) {
    const auto tag = std::make_pair(std::string("name"), std::string("root"));
    return element.isNode && contains(element.tags, tag);
  }

  void addNode(const Element& node, const std::string& file) {
    const Point place = origin_.placeAt(degrees(node, "lat", file), degrees(node, "lon", file));
    if (distance(place, origin_.root()) > OsmOrigin::kFlat)
      refuse(file, formatted("the node in line %zu is more than 100 km from its root", node.line),
             "put the root where the map lies");
    if (!nodes_.emplace(node.attribute("id"), std::make_pair(&node, places_.size())).second)
      refuse(file,
             formatted("has a second node %s in line %zu", node.attribute("id").c_str(), node.line),
             "give each an id of its own");
    places_.push_back({node.attribute("id"), {place.x, place.y, 0}});
  }

  static std::string nameOfElement(const Element& element) {
    const std::string name = element.tag("name");
    return name.empty() ? element.attribute("id") : name;
  }

  /** Those of its nodes that are known, but not the root. */
  std::vector<std::string> nodesOf(const Element& element) const {
    std::vector<std::string> nodes;
    for (const std::string& id :
         element.isNode ? std::vector<std::string>{element.attribute("id")} : element.nodes)
      if (nodes_.count(id)) nodes.push_back(id);
    return nodes;
  }

  std::vector<std::size_t> placesOf(const Element& element) const {
    return mapped(nodesOf(element), [&](const std::string& id) { return nodes_.at(id).second; });
  }

  /** Ways, and nodes that are something by themselves. */
  std::vector<const Element*> things() const {
    std::set<std::string> corners;
    for (const Element& element : elements_)
      corners.insert(element.nodes.begin(), element.nodes.end());
    std::vector<const Element*> things;
    for (const Element& element : elements_) {
      const bool isCorner =
          element.isNode && element.tags.empty() && corners.count(element.attribute("id"));
      if (!isCorner && !isRoot(element)) things.push_back(&element);
    }
    return things;
  }

  bool isClosedAtOnce(const Element& element) const { return text_[element.start.end - 2] == '/'; }

  void moveNode(const Element& node, Point place, Edits& edits) const {
    std::string tag = "<node";
    for (const auto& [key, value] : node.attributes)
      tag += " " + key + "=\"" +
             (key == "lat"   ? origin_.latitudeText(place)
              : key == "lon" ? origin_.longitudeText(place)
                             : xmlText(value)) +
             "\"";
    edits.replace(node.start, tag + (isClosedAtOnce(node) ? "/>" : ">"));
  }

  void setState(const Element& element, const CarriedThing& carried, Edits& edits) const {
    if (isClosedAtOnce(element)) return;
    for (Span span : element.states) {
      while (span.begin > 0 && std::isspace(static_cast<unsigned char>(text_[span.begin - 1])))
        --span.begin;
      edits.replace(span, "");
    }
    const auto tag = [](const char* key, const std::string& value) {
      return "  <tag k=\"" + std::string(key) + "\" v=\"" + xmlText(value) + "\"/>\n  ";
    };
    std::string tags = tag("state", nameOf(carried.state));
    if (carried.error) tags += tag("error_m", Json(rounded(*carried.error)).dump());
    if (!carried.reason.empty()) tags += tag("reason", carried.reason);
    edits.replace({element.end, element.end}, tags);
  }

  std::string text_, name_;
  std::vector<Element> elements_;
  OsmOrigin origin_;
  std::map<std::string, std::pair<const Element*, std::size_t>> nodes_;  // by id; its place
  std::vector<Place> places_;
};

}  // namespace

bool looksLikeXml(const std::string& text) { return firstLetter(text) == '<'; }

MarkedFile osmPlaces(const std::string& text, const std::string& file) {
  const auto osm = std::make_shared<const OsmFile>(text, file);
  MarkedFile marked = osm->marked();
  marked.write = [osm](const std::vector<CarriedThing>& carried, const GridFrame&) {
    return std::vector<NamedBytes>{osm->written(carried)};
  };
  return marked;
}

}  // namespace roomgraph
