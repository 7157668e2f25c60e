#pragma once

namespace roomgraph {

/** From now on SIGINT, SIGTERM and SIGHUP end the program, as ever, but after the results that are
 *  just taking their places, and with none left unfinished. To be called before other threads are
 *  started. */
void finishResultsBeforeEnding();

}  // namespace roomgraph
