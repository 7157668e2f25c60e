#include "CallFiles.h"

#include <cctype>
#include <climits>
#include <filesystem>

#include "file_authors.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sentence_text.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestFileName = NAME_MAX - StagedFiles::kLongestSuffix;  // [bytes]

[[noreturn]] void refuseBoth(const std::string& one, const std::string& other,
                             const std::string& file) {
  if (one == other) throw UsageError(one + ": is named twice: name it once");
  throw UsageError(one + " and " + other + " would both be written as " + file +
                   ": rename one, or choose another folder or file for it");
}

/** Whether the file is there, and something would be lost with it. */
bool hasContent(const std::string& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) && fs::file_size(file, error) > 0 && !error;
}

bool goesOnWithNumber(const std::string& name, const std::string& stem) {
  return name.size() > stem.size() && name.compare(0, stem.size(), stem) == 0 &&
         std::isdigit(static_cast<unsigned char>(name[stem.size()])) != 0;
}

}  // namespace

void CallFiles::addInput(const std::string& file, bool mayBeRenewed) {
  const auto identity = identityOf(file);
  if (!identity) return;  // its reader says so
  const auto known = inputs_.emplace(*identity, mayBeRenewed).first;
  known->second = known->second && mayBeRenewed;
}

void CallFiles::reads(const std::string& file) {
  addInput(file, false), addInput(pictureOf(file), false);
}

void CallFiles::reads(const std::vector<std::string>& files) {
  for (const std::string& file : files) reads(file);
}

void CallFiles::consults(const std::string& file) { addInput(file, true); }

void CallFiles::writes(const std::string& file, const std::string& source) {
  add({file, source, Place::inFolder});
}

void CallFiles::writesOfEach(const std::vector<std::string>& maps, const std::string& folder,
                             const std::vector<std::string>& extensions) {
  for (const std::string& map : maps)
    for (const std::string& extension : extensions) writes(outputFile(folder, map, extension), map);
}

void CallFiles::writesNumbered(const std::string& stem, const std::string& source) {
  const std::string place = placeOnDisk(stem);
  for (const auto& [file, other] : sources_)
    if (goesOnWithNumber(file, place)) refuseBoth(source, other, file);
  const fs::path folder = fs::path(stem).parent_path();
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
    const std::string name = entry.path().filename().string();
    if (goesOnWithNumber(name, fileName(stem)))
      checkReplaced({(folder / name).string(), source, Place::inFolder});
  }
}

void CallFiles::writesTo(const std::string& option, const std::string& file) {
  if (!file.empty()) add({file, option, Place::named});
}

void CallFiles::draws(const std::string& option, const std::string& file) {
  add({file, option, Place::drawn});
}

void CallFiles::updates(const std::string& option, const std::string& file) {
  if (!file.empty()) add({file, option, Place::updated});
}

std::string CallFiles::Output::remedy() const {
  return place == Place::inFolder ? "choose another folder with --output"
                                  : "choose another file with " + source;
}

void CallFiles::add(const Output& output) {
  const std::string name = fileName(output.file);
  const bool isOfMap = output.place == Place::inFolder && output.source != kFolderOption;
  if (name.size() > kLongestFileName)
    throw UsageError(formatted("%s: its name is too long for a file (%zu bytes, at most %zu): ",
                               output.file.c_str(), name.size(), kLongestFileName) +
                     (isOfMap ? "rename " + output.source : output.remedy()));
  const auto [known, isNew] = sources_.emplace(placeOnDisk(output.file), output.source);
  if (!isNew) refuseBoth(known->second, output.source, output.file);
  checkReplaced(output);
}

void CallFiles::checkReplaced(const Output& output) const {
  const auto refuseTo = [&](const std::string& replace) {
    throw UsageError(
        output.file + ": would replace " + replace + ": " + output.remedy() +
        (output.place == Place::inFolder ? ", or other formats where there are any" : ""));
  };
  const std::string& file = output.file;
  if (const auto identity = identityOf(file)) {
    const auto input = inputs_.find(*identity);
    const bool isRenewed =
        output.place == Place::inFolder && (endsWith(file, ".json") || endsWith(file, ".ini"));
    if (input != inputs_.end() && !(input->second && isRenewed)) refuseTo("a file that is read");
  }
  if (!hasContent(file)) return;
  if (const std::string map = foreignMapOf(file); !map.empty())
    refuseTo("a part of the map " + map + ", which roomgraph has not written");
  const bool mayBeMap = output.place == Place::inFolder || output.place == Place::drawn;
  if (!mayBeMap && isMapOrArchive(file)) refuseTo("a map or an archive");
  if (output.place != Place::updated && !isOurs(file))
    refuseTo("a file that roomgraph has not written");
}

}  // namespace roomgraph
