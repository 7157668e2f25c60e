#include "roomgraph/map_files/load_grid.h"

#include <new>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/map_files/map_formats.h"
#include "roomgraph/scans/object_header.h"

namespace roomgraph {
namespace {

/** MRPT's own classes, as against a word that begins a text. */
bool isRegisteredName(const std::string& className) {
  return className.size() > 1 && className[0] == 'C' && className[1] >= 'A' && className[1] <= 'Z';
}

[[noreturn]] void refuseUnknown(CheckedFile& file) {
  if (file.head().size == 0) refuse(file.name(), "is empty", "copy or save the map again");
  const std::string remedy = "give an " + mapFormatNames();
  const auto object = peekObjectHeader(file.head());
  if (object && isRegisteredName(object->className))
    refuse(file.name(), "holds an MRPT object of class " + object->className, remedy);
  refuse(file.name(), "is not a map of a known kind", remedy);
}

GreyMap readByContent(CheckedFile& file, const LoadGridOptions& options) {
  for (const MapFormat& format : mapFormats()) {
    if (!format.looksLike(file)) continue;
    GreyMap map = format.read(file, options);
    map.source.kind = format.kind;
    return map;
  }
  refuseUnknown(file);
}

}  // namespace

GreyMap loadGrid(const std::string& name, const LoadGridOptions& options) {
  try {
    CheckedFile file(name);
    GreyMap map = readByContent(file, options);
    map.source.file = name;
    if (map.source.sha256.empty()) map.source.sha256 = file.sha256();
    return map;
  } catch (const DataError&) {
    throw;
  } catch (const std::bad_alloc&) {
    refuse(name, "there is not enough memory for it", "give a smaller map");
  } catch (const std::exception&) {
    // MRPT's texts run over many lines and name its source files.
    refuse(name, "it cannot be read as a map", "copy or save the map again");
  }
}

}  // namespace roomgraph
