#pragma once
#include <string>

namespace roomgraph::test {

/** The name of a file of this process that holds these bytes until the next call; in memory, where
 *  the system has a place for that. */
const std::string& asFile(const std::string& bytes);

/** A png whose chunks have the right checksums, whatever they hold; other bytes as they are. */
std::string withPngChecksums(std::string bytes);

}  // namespace roomgraph::test
