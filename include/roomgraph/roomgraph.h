#pragma once
// All that a program needs to extract graphs and to compare maps: docs/library.md shows each of
// them. What is behind them has a header for each step; MRPT's classes are in
// roomgraph/mrpt_plugin.

#include "roomgraph/base/Error.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/check/check_run.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/compare/compare_runs.h"
#include "roomgraph/compare/gate.h"
#include "roomgraph/compare/prepare_run.h"
#include "roomgraph/drawing/draw.h"
#include "roomgraph/graph_files/geojson.h"
#include "roomgraph/graph_files/graph_json.h"
#include "roomgraph/graph_files/graphml.h"
#include "roomgraph/graph_files/osm_xml.h"
#include "roomgraph/graph_files/read_graph_json.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/page/comparison_report.h"
#include "roomgraph/pipeline/extract.h"
#include "roomgraph/repair/merge_runs.h"
#include "roomgraph/repair/repair_site.h"
#include "roomgraph/report/comparison_json.h"
