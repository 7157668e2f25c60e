#pragma once
#include <string>

#include "roomgraph/mrpt_plugin/mrpt_compat.h"

namespace roomgraph {

/** An object as MRPT streams it, gzipped. No time stamp: the same object gives the same bytes. */
std::string gzippedObject(const mrpt::serialization::CSerializable& object);

/** The object as MRPT streams it. */
std::string objectBytes(const mrpt::serialization::CSerializable& object);

}  // namespace roomgraph
