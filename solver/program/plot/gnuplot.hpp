// gnuplot as a child process: a script in, an image out. Neither a shell nor a file name is
// involved that could be misread.
#pragma once

#include <string>
#include <string_view>

namespace stationary {

/// Any text as a string of gnuplot's, on one line: control characters escaped, bytes that are not
/// UTF-8 replaced; within single quotes gnuplot expands nothing.
std::string in_gnuplot_quotes(std::string_view text);

/// Runs the script: what gnuplot writes to its standard output. Throws std::runtime_error with
/// gnuplot's message where it is not installed or fails.
std::string run_gnuplot(std::string_view script);

/// An SVG as gnuplot writes it, made well-formed whatever its texts hold, and the cells of a map with sharp edges.
std::string finished_svg(std::string image);

}  // namespace stationary
