#pragma once
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <type_traits>

namespace roomgraph {

/** Reads what a program is told, and does it. It ends with 1 where `run` says that a target is
 *  missed, and with 2 and a line on standard error where it fails. */
template <class Run>
int runBenchmark(CLI::App& app, int argc, char** argv, const Run& run) {
  CLI11_PARSE(app, argc, argv);
  try {
    if constexpr (std::is_void_v<decltype(run())>)
      return run(), 0;
    else
      return run() ? 0 : 1;
  } catch (const std::exception& error) {
    const std::string name = std::filesystem::path(argv[0]).filename().string();
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    return 2;
  }
}

}  // namespace roomgraph
