// load_plugin LIBRARY: loads it as MRPT's viewers do with -l and asks MRPT for its class.

#include <mrpt/rtti/CObject.h>
#include <mrpt/system/os.h>

#include <iostream>

int main(int argc, char** argv) {
  const char* const name = "roomgraph::CRoomGraph";
  if (argc != 2 || mrpt::rtti::findRegisteredClass(name)) {
    std::cerr << "usage: load_plugin LIBRARY, not linked to it\n";
    return 2;
  }
  if (!mrpt::system::loadPluginModule(argv[1])) return 1;
  if (mrpt::rtti::findRegisteredClass(name)) return 0;
  std::cerr << name << " is not registered\n";
  return 1;
}
