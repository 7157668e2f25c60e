// load_plugin LIBRARY: loads it as MRPT's viewers do with -l and asks MRPT for its classes.

#include <mrpt/rtti/CObject.h>
#include <mrpt/system/os.h>

#include <iostream>

int main(int argc, char** argv) {
  const char* const names[] = {"roomgraph::CRoomGraph", "roomgraph::CMapComparison"};
  if (argc != 2 || mrpt::rtti::findRegisteredClass(names[0])) {
    std::cerr << "usage: load_plugin LIBRARY, not linked to it\n";
    return 2;
  }
  if (!mrpt::system::loadPluginModule(argv[1])) return 1;
  int code = 0;
  for (const char* name : names) {
    if (mrpt::rtti::findRegisteredClass(name)) continue;
    std::cerr << name << " is not registered\n";
    code = 1;
  }
  return code;
}
