#include <mrpt/core/initializer.h>

#include "roomgraph/mrpt_plugin/register_classes.h"

// Runs when libroomgraph_mrpt.so is loaded, as by `RawLogViewer -l libroomgraph_mrpt.so`.
MRPT_INITIALIZER(registerOnLoad) { roomgraph::registerMrptClasses(); }
