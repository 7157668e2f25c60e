#include "interruption.h"

#include <csignal>
#include <thread>

#include "roomgraph/base/StagedFiles.h"

namespace roomgraph {

void finishResultsBeforeEnding() {
  sigset_t endings;
  sigemptyset(&endings);
  for (const int ending : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&endings, ending);
  pthread_sigmask(SIG_BLOCK, &endings, nullptr);  // in all threads, which inherit it
  std::thread([endings] {
    int ending = 0;
    sigwait(&endings, &ending);
    StagedFiles::abandonAll();
    std::signal(ending, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &endings, nullptr);
    std::raise(ending);
  }).detach();
}

}  // namespace roomgraph
