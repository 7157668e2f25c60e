#include "roomgraph/base/InputFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

constexpr const char* kCheckDisk = "check the disk or the network that it is on";

std::string sizeText(std::uint64_t bytes) {
  const std::uint64_t megabytes = bytes / 1'000'000;
  return megabytes >= 1000 ? std::to_string(megabytes / 1000) + " GB"
                           : std::to_string(megabytes) + " MB";
}

/** Of the last call that failed. */
std::string errorText() { return std::generic_category().message(errno); }

}  // namespace

InputFile::InputFile(const std::string& name, std::uint64_t most) : name_(name) {
  // Without waiting for the other end of a pipe.
  descriptor_ = open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor_ < 0) {
    if (errno == ENOENT || errno == ENOTDIR)
      refuse(name, "there is no such file", "check the name");
    refuse(name, "cannot be opened (" + errorText() + ")", "check its name and its permissions");
  }
  struct stat status {};
  try {
    if (fstat(descriptor_, &status) != 0)
      refuse(name, "cannot be looked at (" + errorText() + ")", kCheckDisk);
    size_ = std::uint64_t(status.st_size);
    if (S_ISDIR(status.st_mode)) refuse(name, "is a directory", "name the file in it");
    if (!S_ISREG(status.st_mode))
      refuse(name, "is a pipe or a device", "save what it gives as a file");
    if (size_ > most) refuse(name, "is larger than " + sizeText(most), "give a smaller file");
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

InputFile::~InputFile() { close(descriptor_); }

void InputFile::read(std::uint64_t offset, void* to, std::size_t count) const {
  auto* next = static_cast<char*>(to);
  while (count > 0) {
    const ssize_t done = pread(descriptor_, next, count, off_t(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) refuse(name_, "cannot be read (" + errorText() + ")", kCheckDisk);
    if (done == 0)
      refuse(name_, "has become shorter", "wait until it is written, or copy it again");
    next += done, count -= std::size_t(done), offset += std::uint64_t(done);
  }
}

std::string readFile(const std::string& name, std::uint64_t most) {
  const InputFile file(name, most);
  std::string bytes(std::size_t(file.size()), '\0');
  file.read(0, bytes.data(), bytes.size());
  return bytes;
}

}  // namespace roomgraph
