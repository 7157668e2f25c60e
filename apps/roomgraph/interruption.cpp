#include "interruption.h"

#include <csignal>
#include <thread>

#include "roomgraph/base/StagedFiles.h"

namespace roomgraph {

namespace {

/** What the caller ignores, as nohup and background jobs do, is to be ignored: a signal that is
 *  blocked would be kept. */
bool isIgnored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void finishResultsBeforeEnding() {
  sigset_t endings;
  sigemptyset(&endings);
  for (const int ending : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU})
    if (!isIgnored(ending)) sigaddset(&endings, ending);
  // A file that grows too large is then an error as any other.
  std::signal(SIGXFSZ, SIG_IGN);
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
