#include "roomgraph/drawing/run_marks.h"

#include <iterator>

#include "roomgraph/drawing/ink.h"

namespace roomgraph {
namespace {

constexpr Colour kColours[] = {ink::blue,     ink::vermilion,  ink::green,     ink::purple,
                               ink::orange,   ink::sky,        {0, 0, 0},      {110, 60, 150},
                               {140, 81, 10}, {128, 128, 128}, {120, 150, 30}, {150, 20, 80},
                               {40, 60, 130}, {240, 128, 114}};

constexpr const char* kShapes[] = {
    "M-5,0A5,5,0,1,1,5,0A5,5,0,1,1,-5,0Z",         // circle
    "M-4.5,-4.5H4.5V4.5H-4.5Z",                    // square
    "M0,-5.5L5.5,4.5H-5.5Z",                       // triangle
    "M0,-6L6,0L0,6L-6,0Z",                         // diamond
    "M-2,-5.5H2V-2H5.5V2H2V5.5H-2V2H-5.5V-2H-2Z",  // cross
    "M0,5.5L5.5,-4.5H-5.5Z",                       // triangle pointing down
};

}  // namespace

Colour runColour(std::size_t run) { return kColours[run % std::size(kColours)]; }

RunPattern runPattern(std::size_t run) { return RunPattern(run / 7 % 4); }

const char* runShape(std::size_t run) { return kShapes[run % std::size(kShapes)]; }

}  // namespace roomgraph
