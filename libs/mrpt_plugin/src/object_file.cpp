#include "object_file.h"

#include "roomgraph/scans/object_header.h"

namespace roomgraph {

void readObjectFile(const std::string& path, const ObjectKind& kind,
                    const std::function<void(ByteView)>& read) {
  CheckedFile file(path);
  const std::optional<ObjectHeader> head = peekObjectHeader(file.head());
  if (!head || head->className != kind.className)
    refuse(path, std::string("is not a ") + kind.name, kind.remedy);
  ByteReader in(file.content(), path);
  const ObjectHeader header = readObjectHeader(in);
  checkVersion(in, header, kind.newest);
  const auto size = in.get<std::uint64_t>();
  const ByteView body{in.take(size), static_cast<std::size_t>(size)};
  readObjectEnd(in, header);
  if (in.left() > 0)
    refuse(path, std::string("something follows the ") + kind.name + " in it", "save it again");
  read(body);
}

}  // namespace roomgraph
