#pragma once
#include "roomgraph/images/Colour.h"

/** The colours of lines and marks: Okabe and Ito's, which the colour-blind can tell apart. */
namespace roomgraph::ink {

constexpr Colour text{32, 36, 42}, quiet{105, 112, 122}, paper{255, 255, 255}, rule{205, 210, 216};
constexpr Colour blue{0, 114, 178}, vermilion{213, 94, 0}, green{0, 158, 115}, sky{86, 180, 233},
    orange{230, 159, 0}, yellow{240, 228, 66}, purple{204, 121, 167}, inside{92, 74, 110};

}  // namespace roomgraph::ink
