#pragma once
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <type_traits>

namespace roomgraph {

/** Which sites of simulated runs a program is to read: see simulatedSites(). */
inline void declareSites(std::string& data, std::string& only, CLI::App& app) {
  app.add_option("--data", data, "folder with one folder per site, each with runs and a truth.csv")
      ->required();
  app.add_option("--only", only, "only sites with this in their name");
}

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
