// Runs a fuzz target without libFuzzer, the same on every machine and under any compiler: seeds as
// they are, then mutations of them from a fixed generator.
//
//   TARGET COUNT SEEDS...     COUNT mutations; SEEDS are files, or directories of them
//
// What escapes the target, and every report of a sanitizer, ends it with the input in TARGET.input.
#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// The sanitizers', where they are linked.
extern "C" __attribute__((weak)) void __sanitizer_set_death_callback(void (*callback)());

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr std::size_t longest = 8192;

std::vector<std::string> read_seeds(const std::vector<std::filesystem::path>& places) {
  std::vector<std::filesystem::path> files;
  for (const auto& place : places) {
    if (!std::filesystem::is_directory(place)) {
      files.push_back(place);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(place)) {
      const auto extension = entry.path().extension();
      if (extension == ".toml" || extension == ".csv" || extension == ".txt")
        files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  std::vector<std::string> out;
  for (const auto& path : files) {
    std::ifstream file(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    // Whole lines.
    if (text.size() > longest) text.resize(text.rfind('\n', longest - 1) + 1);
    out.push_back(std::move(text));
  }
  return out;
}

class Mutator {
 public:
  explicit Mutator(const std::vector<std::string>& seeds) : seeds_(seeds) {}

  std::string next() {
    std::string text = any(seeds_);
    for (std::size_t k = 1 + below(6); k > 0; --k) change(text);
    if (text.size() > longest) text.resize(longest);
    return text;
  }

 private:
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  const std::string& any(const std::vector<std::string>& of) { return of[below(of.size())]; }

  /// Where a piece of another length can go without running over the end.
  void change(std::string& text) {
    static const std::vector<std::string> pieces{"0",
                                                 "-1",
                                                 "nan",
                                                 "inf",
                                                 "1e308",
                                                 "1e-320",
                                                 "-0.0",
                                                 "true",
                                                 "\"\"",
                                                 "[]",
                                                 "{}",
                                                 "[[",
                                                 "]]",
                                                 ".",
                                                 ",",
                                                 ",,",
                                                 "=",
                                                 "\"",
                                                 "'''",
                                                 "\n",
                                                 "\r\n",
                                                 "\n\n",
                                                 "#--set motion.nu=",
                                                 "#--set body.J.7=",
                                                 "\\u0000",
                                                 "\xEF\xBB\xBF",
                                                 "\xFF",
                                                 "9223372036854775808",
                                                 "1979-05-27T07:32:00Z",
                                                 "fold-nu",
                                                 "unstable"};
    const std::size_t at = below(text.size() + 1);
    const std::size_t left = text.size() - at;
    const std::size_t some = std::min(left, 1 + below(24));
    switch (below(7)) {
      case 0:
        if (left > 0) text[at] = static_cast<char>(below(256));
        break;
      case 1:
        if (left > 0) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 2:
        text.erase(at, some);
        break;
      case 3:
        text.insert(at, text.substr(below(text.size() + 1), some));
        break;
      case 4:
        text.insert(at, any(pieces));
        break;
      case 5:
        text.replace(at, some, any(pieces));
        break;
      default: {
        const std::string& other = any(seeds_);
        text = text.substr(0, at) + other.substr(below(other.size() + 1));
      }
    }
  }

  const std::vector<std::string>& seeds_;
  std::mt19937_64 engine_{1};
};

std::string input;       ///< of the target's present call
std::string input_path;  ///< where it is left when that call is the last

void leave_input() { std::ofstream(input_path, std::ios::binary) << input; }

void run(std::string text) {
  input = std::move(text);
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::fputs("usage: TARGET COUNT SEEDS...\n", stderr);
    return 2;
  }
  input_path = std::string(arguments[0]) + ".input";
  if (__sanitizer_set_death_callback != nullptr) __sanitizer_set_death_callback(leave_input);
  std::signal(SIGABRT, [](int) { leave_input(); });
  try {
    const auto seeds = read_seeds({arguments + 2, arguments + count});
    if (seeds.empty()) throw std::runtime_error("no seeds");
    for (const std::string& seed : seeds) run(seed);
    Mutator mutator(seeds);
    for (long k = std::atol(arguments[1]); k > 0; --k) run(mutator.next());
  } catch (const std::exception& error) {
    leave_input();
    std::fprintf(stderr, "%s\nthe input is in %s\n", error.what(), input_path.c_str());
    return 1;
  }
  return 0;
}
