// The one place where text from outside becomes part of a page's HTML. Titles are escaped; tables, paths and metadata are
// JSON, packed and in base64, so that none of their characters is HTML's.
#pragma once

#include <string>
#include <string_view>

namespace stationary {

/// Text as HTML that shows it, in an element or a quoted attribute: & < > " ' are named, and control characters but tab
/// and line ends become U+FFFD, as do bytes that are not UTF-8.
std::string html_text(std::string_view text);

/// As zlib packs it, in base64. Throws std::runtime_error where memory does not suffice.
std::string packed(std::string_view text);

}  // namespace stationary
