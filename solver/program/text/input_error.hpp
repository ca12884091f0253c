// Wrong input: where it stands, what was found, what is allowed, and how to put it right. The one
// exception of the case reader and of the command line's own checks; the program exits with 2.
//
//   disc.toml:7:6: motion.nu: found the string "fast"; expected a finite number
//   --set motion.nu=fast: motion.nu: found the string "fast"; expected a finite number
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace stationary {

/// Where a value comes from: a place in a file, or a command-line option.
struct Origin {
  std::string file;  ///< empty: not from a file
  int line = 0;      ///< from 1; 0: the file as a whole
  int column = 0;
  std::string option;  ///< as typed, "--set motion.nu=0.3"

  static Origin in_file(std::string file, int line = 0, int column = 0);
  static Origin of_option(std::string option);
  std::string text() const;
};

class InputError : public std::runtime_error {
 public:
  /// key is dotted; key, allowed and remedy may be empty.
  InputError(Origin origin, std::string key, std::string found, std::string allowed,
             std::string remedy = {});
  /// Several told at once, a line each; what is asked of it beside is of the first. Not of none.
  explicit InputError(const std::vector<InputError>& several);

  const Origin& origin() const { return origin_; }
  const std::string& key() const { return key_; }
  const std::string& found() const { return found_; }
  const std::string& allowed() const { return allowed_; }
  const std::string& remedy() const { return remedy_; }

 private:
  Origin origin_;
  std::string key_;
  std::string found_;
  std::string allowed_;
  std::string remedy_;
};

/// Text from outside made safe to print on one line: control characters, and bytes that are not UTF-8,
/// escaped, long text cut.
std::string printable(std::string_view text);

/// printable() in double quotes.
std::string in_quotes(std::string_view text);

/// "a", "b", "c".
std::string listed(std::span<const std::string_view> names);

/// "did you mean "x"?" or nothing.
template <class OptionalName>
std::string did_you_mean(const OptionalName& nearest) {
  return nearest ? "did you mean " + in_quotes(*nearest) + "?" : std::string();
}

}  // namespace stationary
