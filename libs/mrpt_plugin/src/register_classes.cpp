#include "roomgraph/mrpt_plugin/register_classes.h"

#include <mrpt/rtti/CObject.h>

#include "roomgraph/mrpt_plugin/CMapComparison.h"
#include "roomgraph/mrpt_plugin/CRoomGraph.h"

void roomgraph::registerMrptClasses() {
  mrpt::rtti::registerClass(CLASS_ID(CRoomGraph));
  mrpt::rtti::registerClass(CLASS_ID(CMapComparison));
}
