// Any text as a graph, a file of names, options, a comparison, or a line to be shown. What is taken
// must come out the same when it is written and read again.
#include <cstdlib>

#include "ByteSource.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/graph_files/graph_json.h"
#include "roomgraph/graph_files/read_graph_json.h"
#include "roomgraph/pipeline/ExtractOptions.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/report/site_json.h"

namespace {

using namespace roomgraph;

void expectSame(const std::string& one, const std::string& other) {
  if (one != other) std::abort();
}

void readAs(unsigned kind, const std::string& text) {
  if (kind == 0) {
    const std::string json = graphJson(parseGraphJson(text, "x.json"));
    expectSame(graphJson(parseGraphJson(json, "x.json")), json);
  } else if (kind == 1) {
    const std::string json = siteJson(parseSiteJson(text, "site.json"));
    expectSame(siteJson(parseSiteJson(json, "site.json")), json);
  } else if (kind == 2) {
    ExtractOptions options, again;
    FieldTable table = describe(options), tableAgain = describe(again);
    fromIni(text, "x.ini", table);
    fromIni(toIni(table), "x.ini", tableAgain);
    expectSame(toIni(tableAgain), toIni(table));
  } else if (kind == 3) {
    const std::string json = comparisonJson(parseComparisonJson(text, "comparison.json"));
    expectSame(comparisonJson(parseComparisonJson(json, "comparison.json")), json);
  } else {
    expectSame(printable(printable(text)), printable(text));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::ByteSource bytes(data, size);
  const unsigned kind = bytes.byte() % 5;
  try {
    readAs(kind, bytes.rest());
  } catch (const DataError&) {
  } catch (const UsageError&) {
  }
  return 0;
}
