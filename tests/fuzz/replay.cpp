// Runs a fuzz target without a fuzzer: on each file of the folders that are named, and then on
// COUNT inputs by chance, random ones and changed files in turn; the same ones on each run, and
// others with another SEED, so that runs add up. The one that stops it is left in the file
// replay-input.
//   replay [--seed SEED] COUNT FOLDER...
#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

std::string current;  // what is tried

/** Leaves the input that stopped the program, for the folder of regressions. */
void keepCurrent(int signal) {
  std::ofstream("replay-input", std::ios::binary) << current;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void tryInput(const std::string& bytes) {
  current = bytes;
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

std::vector<std::string> filesIn(const std::string& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> contents;
  for (const fs::path& path : paths) {
    std::ifstream in(path, std::ios::binary);
    contents.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return contents;
}

std::string randomBytes(std::mt19937& random) {
  std::string bytes(random() % 400, '\0');
  for (char& c : bytes) c = char(random());
  return bytes;
}

/** With some bytes changed, taken out or doubled. */
std::string changed(std::string bytes, std::mt19937& random) {
  for (unsigned count = 1 + random() % 4; count > 0 && !bytes.empty(); --count) {
    const std::size_t at = random() % bytes.size(), length = 1 + random() % 16;
    switch (random() % 4) {
      case 0:
        bytes[at] = char(random());
        break;
      case 1:
        bytes[at] = char(bytes[at] ^ (1 << random() % 8));
        break;
      case 2:
        bytes.erase(at, length);
        break;
      default:
        bytes.insert(at, bytes.substr(random() % bytes.size(), length));
    }
  }
  return bytes;
}

}  // namespace

int main(int count, char** arguments) {
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE}) std::signal(signal, keepCurrent);
  std::vector<std::string> words(arguments + 1, arguments + count);
  std::mt19937 random(20160719);
  if (words.size() > 1 && words[0] == "--seed") {
    random.seed(static_cast<std::mt19937::result_type>(std::stoul(words[1])));
    words.erase(words.begin(), words.begin() + 2);
  }
  const long inputs = words.empty() ? 0 : std::stol(words[0]);
  std::vector<std::string> files;
  for (std::size_t i = 1; i < words.size(); ++i)
    for (std::string& bytes : filesIn(words[i])) files.push_back(std::move(bytes));
  for (const std::string& file : files) tryInput(file);
  for (long i = 0; i < inputs; ++i) {
    const bool isNew = files.empty() || i % 4 == 0;
    tryInput(isNew ? randomBytes(random) : changed(files[random() % files.size()], random));
  }
  std::printf("%zu files and %ld inputs\n", files.size(), inputs);
  return 0;
}
