#include "roomgraph/report/StagedFiles.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, int error) {
  throw DataError(path + ": cannot be written (" + std::generic_category().message(error) +
                  "): choose a folder that exists, may be written and has room");
}

}  // namespace

/** A new file beside the target that goes away again unless it is renamed. */
class StagedFiles::Part {
 public:
  /** With these permissions; those of any new file where there are none. */
  Part(const std::string& path, const std::optional<fs::perms>& permissions) : path_(path) {
    const mode_t mode = permissions ? mode_t(*permissions) & 0777 : 0666;
    // Names that are taken belong to another writer, or to one that was stopped.
    for (int attempt = 0; attempt < 1000 && descriptor_ < 0; ++attempt) {
      name_ = path + ".part" + std::to_string(attempt);
      descriptor_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
      if (descriptor_ < 0 && errno != EEXIST) fail(path, errno);
    }
    if (descriptor_ < 0) fail(path, EEXIST);
    // What the umask took; not every file system can, and the bytes are worth more.
    if (permissions) (void)fchmod(descriptor_, mode);
  }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;
  ~Part() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!isDone_) unlink(name_.c_str());
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
    const int toClose = descriptor_;
    descriptor_ = -1;
    if (close(toClose) != 0) fail(path_, errno);
  }

  void becomeTarget() {
    if (std::rename(name_.c_str(), path_.c_str()) != 0) fail(path_, errno);
    isDone_ = true;
  }

 private:
  std::string path_, name_;
  int descriptor_ = -1;
  bool isDone_ = false;
};

StagedFiles::StagedFiles() = default;
StagedFiles::~StagedFiles() = default;

void StagedFiles::add(const std::string& path, const std::string& bytes) {
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
}

void StagedFiles::commit() {
  for (const std::unique_ptr<Part>& part : parts_) part->becomeTarget();
  parts_.clear();
}

}  // namespace roomgraph
