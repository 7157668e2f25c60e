#include <mrpt/img/CImage.h>
#include <mrpt/opengl/CFBORender.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <filesystem>

#include "CallFiles.h"
#include "HelpFormatter.h"
#include "ViewWindow.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/version.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/drawing/stage_names.h"
#include "roomgraph/images/png_bytes.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"
#include "usage_fault.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

enum ExitCode { kDone = 0, kBadData = 1, kBadUsage = 2 };

struct Arguments {
  std::vector<std::string> files;
  std::string screenshot;
  std::vector<int> size{1280, 860};
  std::optional<std::size_t> run, frame, fault, stage;  // counted from 1, 0, 1 and 1
};

void say(const std::string& text) {
  std::fprintf(stderr, "roomgraph-view: %s\n", printable(text).c_str());
}

/** The place of the `number`th thing of `count`, counted from 1. */
std::size_t placeOf(const char* option, std::size_t number, std::size_t count) {
  if (number >= 1 && number <= count) return number - 1;
  if (count == 0) throw UsageError(std::string(option) + ": there is none here; leave it out");
  throw UsageError(
      std::string(option) + ": there " +
      (count == 1 ? "is only 1" : "are " + std::to_string(count) + ", counted from 1"));
}

std::size_t placeOfFrame(std::size_t frame, const View& view, std::size_t run) {
  const auto& path = view.path(run);
  if (path.empty()) throw UsageError("--key-frame: the run has no scans; leave it out");
  if (frame <= path.back().keyFrame) return placeInPath(view, run, frame);
  throw UsageError("--key-frame: the last one is " + std::to_string(path.back().keyFrame));
}

ViewState stateOf(const Arguments& arguments, const View& view) {
  const Comparison& comparison = view.comparison;
  ViewState state;
  if (arguments.fault)
    lookAtFault(placeOf("--break", *arguments.fault, view.faults.size()), view, state);
  if (arguments.run) state.run = placeOf("--run", *arguments.run, comparison.runs.size());
  if (arguments.frame) state.frame = placeOfFrame(*arguments.frame, view, state.run);
  const std::size_t stages = view.stages ? stageNames().size() : 0;
  if (arguments.stage) state.stage = placeOf("--stage", *arguments.stage, stages);
  return state;
}

std::string wordsFor(const std::vector<std::string>& files) {
  if (files.size() == 1) return "Reading " + printable(fileName(files[0]));
  const bool isCompared =
      anyOf(files, [](const std::string& file) { return fs::path(file).extension() == ".json"; });
  return (isCompared ? "Reading " : "Reading and comparing ") + std::to_string(files.size()) +
         " files";
}

/** Throws where the picture would take the place of a file that is read, or of somebody else's. */
void checkScreenshot(const Arguments& arguments) {
  CallFiles files;
  files.reads(arguments.files);
  files.draws("--screenshot", arguments.screenshot);
  if (!endsWith(arguments.screenshot, ".png"))
    throw UsageError(arguments.screenshot + ": must end in .png");
}

/** Row by row from the top. */
std::string pngOf(const mrpt::img::CImage& picture) {
  const std::size_t red = picture.getChannelsOrder() == "BGR" ? 2 : 0;  // MRPT 2, and 3
  const auto width = std::size_t(picture.getWidth()), height = std::size_t(picture.getHeight());
  std::vector<std::uint32_t> pixels;
  pixels.reserve(width * height);
  for (std::size_t y = 0; y < height; ++y) {
    const auto* row = picture.ptrLine<std::uint8_t>(unsigned(y));
    for (std::size_t x = 0; x < width; ++x)
      pixels.push_back(
          std::uint32_t(row[3 * x + red] << 16 | row[3 * x + 1] << 8 | row[3 * x + 2 - red]));
  }
  return pngBytes(reinterpret_cast<const unsigned char*>(pixels.data()), int(width), int(height),
                  int(4 * width));
}

/** Draws into memory: no display is needed. */
void writeScreenshot(const Arguments& arguments, const View& view) {
  const ViewState state = stateOf(arguments, view);
  ViewScene drawn(view);
  drawn.update(state);
  drawn.write(state);
  const Box box = state.fault ? drawn.boxAt(view.faults[*state.fault]) : drawn.box();
  const auto width = unsigned(arguments.size[0]), height = unsigned(arguments.size[1]);
  lookDown(*drawn.scene(), box, view.turn, double(width) / height);
  mrpt::opengl::CFBORender render(width, height);
  useCameraOf(*drawn.scene(), render);
  mrpt::img::CImage picture(width, height, mrpt::img::CH_RGB);
  render.render_RGB(*drawn.scene(), picture);
  writeFileAtomically(arguments.screenshot, pngOf(picture));
  std::printf("%s\n", printable(arguments.screenshot).c_str());
}

void declare(Arguments& arguments, CLI::App& app) {
  app.add_option("FILE", arguments.files,
                 "A map, several runs of one site, or a comparison.json, with or without its maps.")
      ->type_name("")
      ->required();
  app.add_option("--screenshot", arguments.screenshot,
                 "Write a picture (.png) instead of opening a window; needs no display.")
      ->type_name("FILE");
  app.add_option("--size", arguments.size,
                 "Size of the window or picture, in pixels (100 to 10000).")
      ->type_name("WIDTH HEIGHT")
      ->expected(2)
      ->allow_extra_args(false)  // the files may follow
      ->check(CLI::Range(100, 10000))
      ->capture_default_str();
  app.add_option("--run", arguments.run, "Show the path of this run, counted from 1 by rank.")
      ->type_name("N");
  app.add_option("--key-frame", arguments.frame, "Show this key frame, counted from 0.")
      ->type_name("K");
  app.add_option("--stage", arguments.stage, "Show this stage of the extraction, counted from 1.")
      ->type_name("N");
  app.add_option("--break", arguments.fault,
                 "Show this break or, of one run, this fault, counted from 1.")
      ->type_name("N");
}

int run(int count, char** words) {
  CLI::App app("Show maps, runs and comparisons in a window.", "roomgraph-view");
  app.set_version_flag("--version", version());
  app.formatter(std::make_shared<HelpFormatter>());
  Arguments arguments;
  declare(arguments, app);
  try {
    app.parse(count, words);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
    say(usageFault(app, {words + 1, words + count}, error) + " (see 'roomgraph-view --help')");
    return kBadUsage;
  }
  const auto load = [&] { return loadView(arguments.files, ExtractOptions(), say); };
  if (arguments.screenshot.empty()) {
    showWindow({load, wordsFor(arguments.files),
                [&](const View& view) { return stateOf(arguments, view); }, arguments.size[0],
                arguments.size[1]});
  } else {
    checkScreenshot(arguments);
    writeScreenshot(arguments, load());
  }
  return kDone;
}

}  // namespace
}  // namespace roomgraph

int main(int count, char** words) {
  try {
    return roomgraph::run(count, words);
  } catch (const roomgraph::UsageError& error) {
    roomgraph::say(error.what());
    return roomgraph::kBadUsage;
  } catch (const std::exception& error) {
    roomgraph::say(error.what());
    return roomgraph::kBadData;
  }
}
