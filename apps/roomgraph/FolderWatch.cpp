#include "FolderWatch.h"

#include <fcntl.h>
#include <linux/magic.h>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>

#include "file_authors.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/map_files/map_formats.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kWhole = IN_CLOSE_WRITE | IN_MOVED_TO;
constexpr unsigned kAway = IN_DELETE | IN_MOVED_FROM;
constexpr unsigned kFolderAway = IN_DELETE_SELF | IN_MOVE_SELF | IN_UNMOUNT | IN_IGNORED;

/** By its name, which is all that is known of a file that is not whole yet. */
bool hasExtensionOf(const std::string& name, bool ofPicture) {
  for (const MapFormat& format : mapFormats()) {
    if ((std::strcmp(format.kind, "image") == 0) != ofPicture) continue;
    for (const std::string extension : format.extensions)
      for (const char* compression : {"", ".gz", ".zst"})
        if (endsWith(name, extension + compression)) return true;
  }
  return false;
}

/** Where leases say nothing of writers. */
bool isOnNetwork(int file) {
  struct statfs disk {};
  if (fstatfs(file, &disk) != 0) return true;
  const auto type = std::uint32_t(disk.f_type);
  return type == NFS_SUPER_MAGIC || type == CIFS_SUPER_MAGIC || type == SMB2_SUPER_MAGIC;
}

/** As far as the system tells: of a file of our own, on a local disk. */
bool isBeingWritten(const std::string& file) {
  const int opened = open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (opened < 0) return false;
  const bool is =
      !isOnNetwork(opened) && fcntl(opened, F_SETLEASE, F_RDLCK) != 0 && errno == EAGAIN;
  close(opened);
  return is;
}

}  // namespace

FolderWatch::FolderWatch(const std::string& folder) : folder_(folder) {
  std::signal(SIGIO, SIG_IGN);  // from a writer that comes while isBeingWritten() asks
  inotify_ = inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
  if (inotify_ < 0 || inotify_add_watch(inotify_, folder.c_str(),
                                        kWhole | kAway | IN_CREATE | IN_MODIFY | IN_DELETE_SELF |
                                            IN_MOVE_SELF | IN_ONLYDIR) < 0) {
    const std::string problem = std::strerror(errno);
    if (inotify_ >= 0) close(inotify_);
    throw DataError(folder + ": cannot be watched (" + problem + "): name a folder that is there");
  }
  listAll();
}

FolderWatch::~FolderWatch() { close(inotify_); }

std::string FolderWatch::path(const std::string& name) const {
  return (fs::path(folder_) / name).string();
}

void FolderWatch::listAll() {
  const auto now = fs::file_time_type::clock::now();
  std::error_code error;
  for (fs::directory_iterator at(folder_, error), end; at != end && !error; at.increment(error)) {
    const std::string name = at->path().filename().string(), map = mapOf(name);
    if (map.empty() || isBeingWritten(at->path().string())) continue;  // its end is an event
    std::error_code ignored;
    if (now - fs::last_write_time(at->path(), ignored) > kSettle)
      listed_.insert(map);
    else
      changed_[map] = Clock::now() + kSettle;
  }
}

std::string FolderWatch::mapOf(const std::string& name) const {
  if (name.empty() || name.front() == '.') return "";
  if (hasExtensionOf(name, false)) return name;
  if (!hasExtensionOf(name, true)) return "";
  std::error_code error;
  for (const char* extension : {".yaml", ".yml"}) {
    const fs::path yaml = fs::path(name).replace_extension(extension);
    if (fs::exists(fs::path(folder_) / yaml, error)) return yaml.string();
  }
  return "";
}

std::string FolderWatch::mapWithPicture(const std::string& name) const {
  if (!hasExtensionOf(name, true)) return "";
  const std::vector<std::string> maps = mapsWithPicture(path(name));
  return maps.empty() ? "" : fileName(maps.front());
}

void FolderWatch::handle(unsigned what, const std::string& name) {
  if (what & kFolderAway)
    throw DataError(folder_ + ": is gone: make it again, then start the watch again");
  if (what & IN_Q_OVERFLOW) return listAll();
  std::string map = mapOf(name);
  if (map.empty() && (what & kWhole)) map = mapWithPicture(name);
  if (map.empty()) return;
  listed_.erase(map);
  changed_.erase(map);
  std::error_code ignored;
  const bool isLink = (what & IN_CREATE) && fs::is_symlink(path(name), ignored);  // never closed
  if (isLink || (what & kWhole)) changed_[map] = Clock::now() + kSettle;
}

void FolderWatch::readEvents() {
  alignas(inotify_event) std::array<char, 1 << 16> buffer{};
  for (;;) {
    const ssize_t size = read(inotify_, buffer.data(), buffer.size());
    if (size <= 0) return;
    for (ssize_t at = 0; at < size;) {
      inotify_event event{};
      std::memcpy(&event, &buffer[std::size_t(at)], sizeof event);
      const char* name = &buffer[std::size_t(at) + sizeof event];
      handle(event.mask, event.len > 0 ? name : "");
      at += ssize_t(sizeof event + event.len);
    }
  }
}

std::optional<std::string> FolderWatch::takeWhole() {
  const auto earliest =
      std::min_element(changed_.begin(), changed_.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  std::string name;
  if (earliest != changed_.end() && earliest->second <= Clock::now()) {
    name = earliest->first;
    changed_.erase(earliest);
  } else if (!listed_.empty()) {
    name = *listed_.begin();
    listed_.erase(listed_.begin());
  } else {
    return std::nullopt;
  }
  return path(name);
}

int FolderWatch::patience() const {
  Clock::time_point first = Clock::time_point::max();
  for (const auto& [name, due] : changed_) first = std::min(first, due);
  if (first == Clock::time_point::max()) return -1;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(first - Clock::now());
  return int(std::max<std::chrono::milliseconds::rep>(left.count(), 0));
}

std::string FolderWatch::next() {
  for (;;) {
    readEvents();
    if (auto map = takeWhole()) return *std::move(map);
    pollfd event{inotify_, POLLIN, 0};
    poll(&event, 1, patience());
  }
}

}  // namespace roomgraph
