#pragma once
#include "roomgraph/base/statistics.h"
