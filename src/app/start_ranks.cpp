// SPDX-License-Identifier: BSD-3-Clause
#include "app/start_ranks.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"

namespace packbed::app {
namespace {

// Below this a rank waits for its neighbors more than it works.
constexpr double fewest_grains_per_rank = 20000.0;

/// Cores, not the threads of a core, which share its arithmetic.
int physical_cores() {
  std::ifstream info("/proc/cpuinfo");
  std::set<std::pair<std::string, std::string>> cores;
  std::string line;
  std::string package;
  while (std::getline(info, line)) {
    const auto value = [&] { return line.substr(std::min(line.find(':') + 1, line.size())); };
    if (line.starts_with("physical id")) package = value();
    if (line.starts_with("core id")) cores.emplace(package, value());
  }
  const auto threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return cores.empty() ? threads : std::min(threads, static_cast<int>(cores.size()));
}

std::vector<std::string> words_of(int ranks, const RunCommand& command) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe").string();
  std::vector<std::string> words = {
      // Open MPI counts cores, not threads of the hardware, and else refuses more ranks than that.
      "mpiexec", "-q", "--oversubscribe", "-n", fmt::format("{}", ranks)};
  for (const auto& word : {program, std::string("run"), command.file.string()})
    words.push_back(word);
  if (!command.directory.empty()) words.insert(words.end(), {"-o", command.directory});
  words.emplace_back(command.resume ? "--resume" : "--overwrite");  // asked and answered here
  if (command.json) words.emplace_back("--json");
  return words;
}

/// Becomes mpiexec, out of reach of the terminal's Ctrl-C, and ends if this process ends.
[[noreturn]] void become_mpiexec(std::vector<std::string> words, int failed) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  // A rank that waits lets other programs have its core: else they keep it from the rank that is waited for.
  setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);  // NOLINT(concurrency-mt-unsafe): one thread
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp("mpiexec", arguments.data());
  const int why = errno;
  if (write(failed, &why, sizeof why) < 0) _exit(3);
  _exit(3);
}

pid_t child = 0;         // NOLINT: a signal handler has nothing else
int signals_so_far = 0;  // NOLINT

extern "C" void pass_on(int /*signal*/) { kill(child, ++signals_so_far == 1 ? SIGUSR1 : SIGTERM); }

int wait_for_child() {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  return 128 + WTERMSIG(status);
}

}  // namespace

int useful_ranks(double grains) {
  return std::clamp(static_cast<int>(grains / fewest_grains_per_rank), 1, physical_cores());
}

int run_on_ranks(int ranks, const RunCommand& command) {
  // mpiexec puts a pipe where the terminal was.
  if (isatty(STDERR_FILENO) == 1) setenv("PACKBED_PROGRESS", "1", 1);
  // Open MPI refuses root, as whom packbed may well run in a container, unless told twice.
  setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 0);
  setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 0);
  std::array<int, 2> failed{};
  if (pipe2(failed.data(), O_CLOEXEC) != 0) throw DataError("no pipe can be made");
  child = fork();
  if (child == 0) become_mpiexec(words_of(ranks, command), failed[1]);
  close(failed[1]);
  for (const int signal : std::array{SIGINT, SIGTERM, SIGUSR1}) {
    struct sigaction action {};
    action.sa_handler = pass_on;
    sigaction(signal, &action, nullptr);
  }
  int why = 0;
  ssize_t told = -1;  // of a failure; nothing is told where mpiexec runs
  do told = read(failed[0], &why, sizeof why);
  while (told < 0 && errno == EINTR);
  const bool started = child > 0 && told == 0;
  close(failed[0]);
  if (!started) {
    throw DataError(
        fmt::format("mpiexec cannot be started ({}); install the package openmpi-bin, or run "
                    "with -n 1",
                    std::strerror(child > 0 ? why : errno)));
  }
  return wait_for_child();
}

}  // namespace packbed::app
