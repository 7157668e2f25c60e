#pragma once
#include <functional>
#include <memory>
#include <string>

namespace roomgraph {

/** Does the work in a thread of its own, and returns when it is done. A window of this size [px]
 *  says meanwhile what is being done, if that takes longer than a moment; whoever closes it ends
 *  the program, so `work` should write nothing. It stays as long as what comes back is held, for
 *  another to take its place. Needs a display and nanogui::init().
 *  @throws what `work` throws. */
std::shared_ptr<void> waitBeside(const std::function<void()>& work, const std::string& words,
                                 int width, int height);

}  // namespace roomgraph
