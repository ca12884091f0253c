#include "solver/program/plot/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>

#include "solver/program/text/input_error.hpp"
#include "solver/program/text/utf8.hpp"

namespace stationary {
namespace {

/// A file without a name, gone when closed. Unlike a pipe it holds everything, so that neither side
/// waits for the other.
using Scratch = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Scratch scratch() {
  Scratch file(std::tmpfile(), &std::fclose);
  if (!file) throw std::system_error(errno, std::generic_category(), "a temporary file");
  return file;
}

std::string text_of(std::FILE* file) {
  std::string out;
  std::rewind(file);
  char block[4096];
  while (const std::size_t count = std::fread(block, 1, sizeof block, file))
    out.append(block, count);
  return out;
}

/// The two ends of a pipe, closed with it.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_, O_CLOEXEC) != 0)
      throw std::system_error(errno, std::generic_category(), "a pipe");
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    ::close(ends_[0]);
    close_input();
  }
  int input() const { return ends_[1]; }
  void close_input() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }
  /// All that comes until nobody has its input any more.
  std::string text() const {
    std::string out;
    char block[65536];
    for (;;) {
      const ::ssize_t count = ::read(ends_[0], block, sizeof block);
      if (count == 0) return out;
      if (count > 0) {
        out.append(block, static_cast<std::size_t>(count));
      } else if (errno != EINTR) {
        throw std::system_error(errno, std::generic_category(), "reading what gnuplot draws");
      }
    }
  }

 private:
  int ends_[2] = {-1, -1};
};

/// On one line.
std::string message_of(std::FILE* errors) {
  std::string out;
  for (const char c : text_of(errors)) {
    if (c != '\n' && c != ' ') {
      out += c;
    } else if (!out.empty() && out.back() != ' ') {
      out += ' ';
    }
  }
  return out.empty() ? "no message" : printable(out);
}

/// With what is no UTF-8 replaced: an SVG that contained it would not open.
std::string well_formed(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    out += length > 0 ? text.substr(0, length) : "\uFFFD";
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

class FileActions {
 public:
  FileActions() { posix_spawn_file_actions_init(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  void give(int ours, int theirs) { posix_spawn_file_actions_adddup2(&actions_, ours, theirs); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

}  // namespace

std::string in_gnuplot_quotes(std::string_view text) {
  std::string out = "'";
  for (const char c : printable(well_formed(text))) {
    if (c == '\'') out += '\'';
    out += c;
  }
  return out + '\'';
}

std::string run_gnuplot(std::string_view script) {
  const Scratch input = scratch();
  const Scratch errors = scratch();
  if (std::fwrite(script.data(), 1, script.size(), input.get()) != script.size() ||
      std::fflush(input.get()) != 0)
    throw std::system_error(errno, std::generic_category(), "a temporary file");
  std::rewind(input.get());

  // Into a file gnuplot writes without a look at whether the disk takes it.
  Pipe image;
  FileActions streams;
  streams.give(::fileno(input.get()), STDIN_FILENO);
  streams.give(image.input(), STDOUT_FILENO);
  streams.give(::fileno(errors.get()), STDERR_FILENO);
  char program[] = "gnuplot";
  char no_personal_settings[] = "-d";
  char* const arguments[] = {program, no_personal_settings, nullptr};
  ::pid_t child = 0;
  if (const int reason =
          ::posix_spawnp(&child, program, streams.get(), nullptr, arguments, ::environ)) {
    throw std::runtime_error(
        fmt::format("gnuplot cannot be run: {}; is it installed (Debian: gnuplot-nox)?",
                    std::strerror(reason)));
  }
  image.close_input();
  std::string drawn = image.text();
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "gnuplot");
  }
  if (WIFSIGNALED(status))
    throw std::runtime_error(fmt::format("gnuplot was ended by signal {}", WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0) {
    throw std::runtime_error(fmt::format("gnuplot ended with exit code {}: {}", WEXITSTATUS(status),
                                         message_of(errors.get())));
  }
  if (drawn.empty()) throw std::runtime_error("gnuplot wrote nothing: " + message_of(errors.get()));
  return drawn;
}

std::string finished_svg(std::string image) {
  boost::replace_all(image, "]]>", "]]&gt;");  // gnuplot escapes & and < alone
  boost::replace_all(image, "<image ",
                     "<image style='image-rendering:crisp-edges;image-rendering:pixelated' ");
  return image;
}

}  // namespace stationary
