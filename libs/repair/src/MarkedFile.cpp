#include "roomgraph/repair/MarkedFile.h"

#include "roomgraph/base/checked_file.h"
#include "roomgraph/images/read_image.h"
#include "roomgraph/repair/places_formats.h"

namespace roomgraph {
namespace {

struct MarkedFormat {
  bool (*looksLike)(const std::string& text);
  MarkedFile (*read)(const std::string& text, const std::string& file);
};

/** The first that a text looks like is read. */
constexpr MarkedFormat kFormats[] = {
    {looksLikeSite, sitePlaces},
    {looksLikeGeojson, geojsonPlaces},
    {looksLikeXml, osmPlaces},
    {looksLikeMask, maskPlaces},
    {[](const std::string&) { return true; }, csvPlaces},
};

}  // namespace

MarkedFile readMarked(const std::string& file) {
  const std::string text = readFile(file);
  if (isImage(viewOf(text))) refuse(file, "is a picture", "name the yaml that tells where it lies");
  for (const MarkedFormat& format : kFormats)
    if (format.looksLike(text)) return format.read(text, file);
  return {};
}

bool isCarried(const std::string& text) {
  const auto holds = [](const std::string& whole, const std::string& part) {
    return whole.find(part) != std::string::npos;
  };
  for (const CarryState state :
       {CarryState::carried, CarryState::unsure, CarryState::gone, CarryState::unseen}) {
    const std::string name = std::string("\"") + nameOf(state) + "\"";
    for (const char* member : {"\"state\":", "\"state\": ", "k=\"state\" v="})
      if (holds(text, member + name)) return true;
  }
  const std::string columns = text.substr(0, text.find('\n'));
  return holds(columns, "state") && holds(columns, "error_m") && holds(columns, "reason");
}

}  // namespace roomgraph
