#include "roomgraph/images/read_labels.h"

#include <algorithm>
#include <new>

#include "decoders.h"
#include "pixels.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/images/read_image.h"

namespace roomgraph {
namespace {

void readPgm(CheckedFile& file, LabelMap& map) {
  const PgmHeader header = readPgmHeader(ByteReader(file.head(), file.name()));
  setSize(map, header, file.name());
  checkPgm(file, header);
  map.label.resize(map.pixelCount());
  decodePgm(file, header, [&](std::size_t row, const std::vector<std::uint32_t>& values) {
    if (*std::max_element(values.begin(), values.end()) > header.brightest)
      refuse(file.name(), "it is damaged: a pixel is above its brightest value",
             "copy or save the picture again");
    std::copy(values.begin(), values.end(),
              map.label.begin() + std::ptrdiff_t(row * values.size()));
  });
}

void readPng(CheckedFile& file, LabelMap& map) {
  const PngHeader header = readPngHeader(ByteReader(file.head(), file.name()));
  setSize(map, header, file.name());
  if (header.isColour && header.bitsPerChannel > 8)
    refuse(file.name(), "has colours of 16 bits per channel",
           "save it with 8 bits per channel, or as grey levels");
  const ByteView png = file.content();
  checkPng(ByteReader(png, file.name()), header);
  map.label = decodePngLabels(png, file.name());
  flipRows(map.label, header.width);
}

}  // namespace

LabelMap readLabels(const std::string& name) {
  try {
    CheckedFile file(name);
    LabelMap map;
    if (isPng(file.head()))
      readPng(file, map);
    else if (isPgm(file.head()))
      readPgm(file, map);
    else
      refuse(name, "is not a label picture", "give a png or pgm (P2, P5), one value per region");
    map.source = {name, file.sha256()};
    return map;
  } catch (const std::bad_alloc&) {
    refuse(name, "there is not enough memory for it", "give a smaller picture");
  }
}

}  // namespace roomgraph
