#pragma once
namespace roomgraph {

/** Metres (or m2) as files hold them: rounded to 0.1 mm, never "-0". Files hold no more than that,
 *  so that reading and writing again gives the same bytes. */
double rounded(double value);

}  // namespace roomgraph
