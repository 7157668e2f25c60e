#include "roomgraph/base/StagedFiles.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, int error) {
  throw DataError(path + ": cannot be written (" + std::generic_category().message(error) +
                  "): choose a folder that exists, may be written and has room");
}

/** The parts of all StagedFiles of this process. Whoever holds the mutex sees none half made, and
 *  no commit half done. */
struct AllParts {
  std::mutex mutex;
  std::set<std::string> names;
};

AllParts& allParts() {
  static AllParts parts;
  return parts;
}

/** Whether the name is still that of the open file. */
bool isNameOf(const std::string& name, int descriptor) {
  struct stat named {
  }, open{};
  return stat(name.c_str(), &named) == 0 && fstat(descriptor, &open) == 0 &&
         named.st_dev == open.st_dev && named.st_ino == open.st_ino;
}

/** Removes a part whose writer was stopped: one that nobody has locked. */
void removeLeftover(const std::string& name) {
  const int descriptor = open(name.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return;
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 && isNameOf(name, descriptor)) unlink(name.c_str());
  close(descriptor);
}

/** A new file, locked; -1 with errno where there is none, which is EEXIST for a name that another
 *  writer has. */
int makePart(const std::string& name, mode_t mode) {
  removeLeftover(name);
  const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (descriptor < 0) return -1;
  // A file system without locks has leftovers, but works.
  const bool isTaken = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (!isTaken && isNameOf(name, descriptor)) return descriptor;
  close(descriptor);  // another writer took it for a leftover before it was locked
  errno = EEXIST;
  return -1;
}

}  // namespace

/** A new file beside the target that goes away again unless it is renamed. */
class StagedFiles::Part {
 public:
  /** With these permissions; those of any new file where there are none. */
  Part(const std::string& path, const std::optional<fs::perms>& permissions) : path_(path) {
    const mode_t mode = permissions ? mode_t(*permissions) & 0777 : 0666;
    const std::lock_guard<std::mutex> lock(allParts().mutex);
    for (unsigned long attempt = 0; descriptor_ < 0; ++attempt) {
      name_ = path + ".roomgraph-part" + std::to_string(attempt);
      descriptor_ = makePart(name_, mode);
      if (descriptor_ < 0 && errno != EEXIST) fail(path, errno);
    }
    allParts().names.insert(name_);
    // What the umask took; not every file system can, and the bytes are worth more.
    if (permissions) (void)fchmod(descriptor_, mode);
  }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;
  ~Part() {
    if (place_ != Place::settled) {
      const std::lock_guard<std::mutex> lock(allParts().mutex);
      unlink(name_.c_str());
      allParts().names.erase(name_);
    }
    close(descriptor_);
  }

  /** To the disk, so that all that can fail for want of room has failed. */
  void write(const std::string& bytes) {
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t count = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
      if (count < 0 && errno != EINTR) fail(path_, errno);
      if (count > 0) done += std::size_t(count);
    }
    if (fsync(descriptor_) != 0) fail(path_, errno);
  }

  const std::string& name() const { return name_; }

  // The caller of these holds the mutex.

  /** What was there keeps the part's name, so that it can be put back. */
  void becomeTarget() {
    const bool isAlone = !isFile(path_);
    if (!isAlone && exchange()) {
      place_ = Place::exchanged;
      return;
    }
    if (std::rename(name_.c_str(), path_.c_str()) != 0) fail(path_, errno);
    place_ = isAlone ? Place::alone : Place::settled;  // some file systems cannot exchange files
  }
  /** Puts back what was there. */
  void undo() {
    if (place_ == Place::exchanged && exchange()) place_ = Place::part;
    if (place_ == Place::alone && std::rename(path_.c_str(), name_.c_str()) == 0)
      place_ = Place::part;
  }
  void settle() {
    if (place_ == Place::exchanged) unlink(name_.c_str());
    place_ = Place::settled;
    allParts().names.erase(name_);
  }

 private:
  enum class Place { part, exchanged, alone, settled };

  static bool isFile(const std::string& name) {
    struct stat status {};
    return lstat(name.c_str(), &status) == 0 && S_ISREG(status.st_mode);
  }
  bool exchange() const {
    return renameat2(AT_FDCWD, name_.c_str(), AT_FDCWD, path_.c_str(), RENAME_EXCHANGE) == 0;
  }

  std::string path_, name_;
  int descriptor_ = -1;
  Place place_ = Place::part;
};

StagedFiles::StagedFiles() = default;
StagedFiles::~StagedFiles() = default;

std::string StagedFiles::add(const std::string& path, const std::string& bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  // Renaming onto a device or a pipe would replace it.
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw DataError(path + ": cannot be written (not a regular file): choose another name");
  std::string target = path;
  std::optional<fs::perms> permissions;
  if (fs::exists(status)) {
    permissions = status.permissions();
    const fs::path followed = fs::canonical(path, error);
    if (!error) target = followed.string();
  }
  auto part = std::make_unique<Part>(target, permissions);
  part->write(bytes);
  parts_.push_back(std::move(part));
  return parts_.back()->name();
}

void StagedFiles::commit() {
  {
    const std::lock_guard<std::mutex> lock(allParts().mutex);
    try {
      for (const std::unique_ptr<Part>& part : parts_) part->becomeTarget();
    } catch (...) {
      for (const std::unique_ptr<Part>& part : parts_) part->undo();
      throw;
    }
    for (const std::unique_ptr<Part>& part : parts_) part->settle();
  }
  parts_.clear();
}

void StagedFiles::abandonAll() {
  allParts().mutex.lock();  // for ever: the process is about to end
  for (const std::string& name : allParts().names) unlink(name.c_str());
}

}  // namespace roomgraph
