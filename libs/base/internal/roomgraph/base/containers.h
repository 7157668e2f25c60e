#pragma once
#include "roomgraph/base/sequences.h"
