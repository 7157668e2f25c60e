#pragma once
#include <string>
#include <vector>

#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LabelMap.h"

namespace roomgraph {

/** Names of the plans of `data`/room_seg/ipa, without ending, by name: those that have a
 *  labels/NAME_labels.png, which is the truth. Throws DataError where there is none. */
std::vector<std::string> floorPlanNames(const std::string& data);

/** The truth of a plan: which room each pixel of its plain picture belongs to. */
LabelMap floorPlanTruth(const std::string& data, const std::string& name);

/** Whether there is a picture NAMEvariant.png, as "_furnitures". */
bool hasFloorPlan(const std::string& data, const std::string& name, const std::string& variant);

/** That picture, of a building of `truthWidth` cells of 0.05 m: a picture of another width shows
 *  the same building at another scale, and so has other cells. */
GreyMap floorPlan(const std::string& data, const std::string& name, const std::string& variant,
                  int truthWidth);

}  // namespace roomgraph
