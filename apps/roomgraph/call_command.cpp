#include "call_command.h"

#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

namespace roomgraph {
namespace {

constexpr int kNoShell = 127;

/** A file without a name, which nobody has to read for the writer to go on. */
int fileWith(const std::string& content) {
  const int file = memfd_create("roomgraph", MFD_CLOEXEC);
  if (file < 0) return file;
  if (write(file, content.data(), content.size()) == ssize_t(content.size()) &&
      lseek(file, 0, SEEK_SET) == 0)
    return file;
  close(file);
  return -1;
}

/** The command gets the signals that this program keeps back. */
int spawn(const std::string& command, int input, pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  std::string shell = "sh", option = "-c", text = command;
  const std::array<char*, 4> arguments{shell.data(), option.data(), text.data(), nullptr};
  const int failure =
      posix_spawn(&child, "/bin/sh", &actions, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return failure;
}

}  // namespace

int callCommand(const std::string& command, const std::string& input) {
  const int file = fileWith(input);
  if (file < 0) return kNoShell;
  pid_t child = 0;
  const int failure = spawn(command, file, child);
  close(file);
  if (failure != 0) return kNoShell;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return kNoShell;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace roomgraph
