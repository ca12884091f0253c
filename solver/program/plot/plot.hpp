// The diagram of tables as a gnuplot script, data included; gnuplot then writes the image to its
// standard output.
//
// The principal stretches, or other columns, against the family's parameter, each with a lightness
// of its own, so that they are told apart in grey too. The dash says the class: thick solid stable,
// thin solid elliptic, dashed unstable, dash-dotted oscillatory, dotted marginal. Where curves lie on
// one another the lower is the wider. Events are marked on the curves, sheets numbered; an arrow says
// that a curve leaves the picture. Beside or below, where the table has a spectrum: the frequencies,
// by their Krein signatures, and the growth rate.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "solver/program/diagram/diagram.hpp"
#include "solver/program/plot/diagram_picture.hpp"
#include "solver/program/plot/plot_page.hpp"

namespace stationary {

enum class ImageFormat : std::uint8_t { svg, png, pdf };
constexpr std::array<std::string_view, 3> image_extensions{".svg", ".png", ".pdf"};

/// By the extension, with its dot.
std::optional<ImageFormat> image_format(std::string_view extension);

/// gnuplot's spacing of a legend whose lines are so high; a line of its own is another in each format.
double key_spacing(ImageFormat format, double line);

/// Terminal, encoding and title: what a script begins with.
std::string page_head(ImageFormat format, std::string_view title, const PageSize& size = {});

/// title: shown as it is; empty for none.
std::string gnuplot_script(const Diagram& diagram, ImageFormat format, std::string_view title,
                           const PageChoice& choice = {});

}  // namespace stationary
