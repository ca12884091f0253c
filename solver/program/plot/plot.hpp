// The bifurcation diagram of a table as a gnuplot script, data included; gnuplot then writes the
// image to its standard output.
//
// Above: lambda, mu and rho against the family's parameter, each with a lightness of its own, so
// that they are told apart in grey too. The dash says the class: thick solid stable, thin solid
// elliptic, dashed unstable, dash-dotted oscillatory, dotted marginal. Logarithmic where the
// stretches differ by more than a factor of 30. Events are marked on the curves and named along
// the top edge.
// Below, where the table has a spectrum: the frequencies im1 ... im5 and the growth rate.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "solver/program/plot/diagram.hpp"

namespace stationary {

enum class ImageFormat : std::uint8_t { svg, png, pdf };
constexpr std::array<std::string_view, 3> image_extensions{".svg", ".png", ".pdf"};

/// By the extension, with its dot.
std::optional<ImageFormat> image_format(std::string_view extension);

/// Terminal, encoding and title: what a script begins with.
std::string page_head(ImageFormat format, std::string_view title);

/// A place on the page, in the units of PlotPage.
std::string on_page(double x, double y);

/// title: shown as it is; empty for none.
std::string gnuplot_script(const Diagram& diagram, ImageFormat format, std::string_view title);

}  // namespace stationary
