// What must hold on any map: random ones, made smaller by rapidcheck where it does not.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "brute_force.h"
#include "random_maps.h"
#include "roomgraph/pipeline/extract.h"

namespace rc {

template <>
struct Arbitrary<roomgraph::test::Stroke> {
  static Gen<roomgraph::test::Stroke> arbitrary() {
    using roomgraph::test::Stroke;
    const auto number = gen::inRange(0u, 60u);
    return gen::build<Stroke>(gen::set(&Stroke::kind, gen::inRange(0u, 6u)),
                              gen::set(&Stroke::x, number), gen::set(&Stroke::y, number),
                              gen::set(&Stroke::width, number), gen::set(&Stroke::height, number));
  }
};

}  // namespace rc

namespace roomgraph::test {
namespace {

/** Checks a property of maps that random strokes make; always with the same seed. */
template <class Property>
void checkOnMaps(const char* name, int count, const Property& property) {
  rc::detail::TestParams params;
  params.seed = 20160719;
  params.maxSuccess = count;
  params.maxSize = 40;
  const auto result = rc::detail::checkTestable(
      [&](const std::vector<Stroke>& strokes, bool isFine) {
        property(isFine ? painted(64, 48, 0.1, strokes) : painted(48, 36, 0.2, strokes));
      },
      rc::detail::TestMetadata{name, name}, params);
  std::ostringstream out;
  rc::detail::printResultMessage(result, out);
  EXPECT_TRUE((result.template is<rc::detail::SuccessResult>())) << out.str();
}

void failOn(const std::vector<std::string>& broken, const MapText& map) {
  if (!broken.empty()) RC_FAIL(broken.front() + "\n" + picture(map));
}

TEST(AnyMap, keepsThePromisesOfEveryStep) {
  checkOnMaps("promises", 300, [](const MapText& map) {
    ExtractOptions options;
    for (const bool onlyLargest : {true, false}) {
      options.keepComponents.onlyLargest = onlyLargest;
      failOn(brokenPromises(extract(greyMap(map), options)), map);
    }
  });
}

TEST(AnyMap, keepsThePromisesWithSmallRooms) {
  checkOnMaps("promises with small rooms", 200, [](const MapText& map) {
    ExtractOptions options;
    options.findRooms.minWidth = 0.7;
    failOn(brokenPromises(extract(greyMap(map), options)), map);
  });
}

TEST(AnyMap, keepsConnectedWhatADiscCanTravel) {
  checkOnMaps("connected", 200, [](const MapText& map) {
    failOn(lostConnections(extract(greyMap(map), {}), 4), map);
  });
}

TEST(AnyMap, keepsThePromisesInAnOfficeWithNoise) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const MapText map = noisyOffice(seed, 400);
    const auto broken = brokenPromises(extract(greyMap(map), {}));
    EXPECT_TRUE(broken.empty()) << "seed " << seed << ": " << broken.front();
  }
}

}  // namespace
}  // namespace roomgraph::test
