// The page as text: what is escaped, what is packed, what fills which place.
#include "solver/program/explore/page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <nlohmann/json.hpp>

#include "solver/program/explore/page_data.hpp"
#include "solver/program/explore/page_text.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

std::string bytes_of(const std::string& base64) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  unsigned group = 0;
  int bits = 0;
  for (const char c : base64) {
    if (c == '=') break;
    group = group << 6U | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    out += static_cast<char>(group >> static_cast<unsigned>(bits) & 0xffU);
  }
  return out;
}

std::string unpacked(const std::string& base64, std::size_t size) {
  const std::string bytes = bytes_of(base64);
  std::string out(size + 1, '\0');
  uLongf length = out.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(out.data()), &length,
                       reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()),
            Z_OK);
  out.resize(length);
  return out;
}

TEST(HtmlText, NamesWhatHtmlReads) {
  EXPECT_EQ(html_text("a < b & c > d"), "a &lt; b &amp; c &gt; d");
  EXPECT_EQ(html_text("\"x\" 'y'"), "&quot;x&quot; &#39;y&#39;");
  EXPECT_EQ(html_text("</script><img src=x onerror=\"f()\">"),
            "&lt;/script&gt;&lt;img src=x onerror=&quot;f()&quot;&gt;");
  EXPECT_EQ(html_text("&lt;"), "&amp;lt;");
  EXPECT_EQ(html_text("ϱ at λ = μ\n"), "ϱ at λ = μ\n");
  EXPECT_EQ(html_text(""), "");
}

TEST(HtmlText, LeavesNothingThatIsNoText) {
  EXPECT_EQ(html_text(std::string("a\0b", 3)),
            "a\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(html_text("\x1b[31m\x7f"), "\xEF\xBF\xBD[31m\xEF\xBF\xBD");
  EXPECT_EQ(html_text("\xff<"), "\xEF\xBF\xBD&lt;");
}

TEST(Packed, ComesBackWhole) {
  for (const std::size_t size : {0U, 1U, 2U, 3U, 4U, 1000U, 100000U}) {
    std::string text;
    for (std::size_t k = 0; k < size; ++k) text += static_cast<char>(k * k % 251);
    const std::string in_page = packed(text);
    EXPECT_EQ(in_page.size() % 4, 0U);
    EXPECT_EQ(in_page.find_first_not_of(
                  "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/="),
              std::string::npos);
    EXPECT_EQ(unpacked(in_page, size), text) << size;
  }
}

TEST(Page, FillsEveryPlaceOnce) {
  // A place may lie across two pieces.
  constexpr std::string_view pieces[] = {"<title>@TITLE@</title><h1>@TI", "TLE@</h1><p>", "@DATA@",
                                         "</p>"};
  EXPECT_EQ(filled_page(pieces, {.title = "x < y", .data = ""}),
            "<title>x &lt; y</title><h1>x &lt; y</h1><p>" + packed("") + "</p>");
}

TEST(Page, ATitleIsNotSearchedForPlaces) {
  constexpr std::string_view pieces[] = {"@TITLE@|@DATA@"};
  EXPECT_EQ(filled_page(pieces, {.title = "@DATA@", .data = "@TITLE@"}),
            "@DATA@|" + packed("@TITLE@"));
}

TEST(Page, IsAllowedToComputeOnlyWithTheSolver) {
  constexpr std::string_view pieces[] = {"script-src 'x'@LIVE_POLICY@|@LIVE@|"};
  constexpr std::string_view solver[] = {"YW", "Jj"};
  EXPECT_EQ(filled_page(pieces, {.title = "", .data = "", .live = solver}),
            "script-src 'x' 'wasm-unsafe-eval'; worker-src blob:|YWJj|");
  EXPECT_EQ(filled_page(pieces, {.title = "", .data = ""}), "script-src 'x'||");
}

PageTable small_table(const std::string& metadata) {
  return {.file = "x.csv",
          .title = "A body",
          .metadata = metadata,
          .parameters = {"body.J.0"},
          .columns = {{"branch", false, "", {"i", "i"}}, {"body.J.0", true, "1,2.5", {}}},
          .rows = 2};
}

TEST(PageData, HasTheTablesAndTheirMetadataWithoutTheRun) {
  const std::vector<PageTable> tables{
      small_table(R"({"schema": 2, "run": {"command_line": ["/home/someone"]}, "rows": 2})")};
  const Json data = Json::parse(page_data(tables, "Title", "1.2.3"));
  EXPECT_EQ(data["version"], "1.2.3");
  EXPECT_EQ(data["title"], "Title");
  const Json& table = data["tables"][0];
  EXPECT_EQ(table["file"], "x.csv");
  EXPECT_EQ(table["rows"], 2);
  EXPECT_EQ(table["parameters"], Json::array({"body.J.0"}));
  EXPECT_EQ(table["columns"][0],
            Json({{"name", "branch"}, {"kind", "text"}, {"cells", {"i", "i"}}}));
  EXPECT_EQ(table["columns"][1],
            Json({{"name", "body.J.0"}, {"kind", "number"}, {"cells", "1,2.5"}}));
  EXPECT_EQ(table["metadata"], Json({{"schema", 2}, {"rows", 2}}));
}

TEST(PageData, MayHaveACaseInThePlaceOfTables) {
  const Json data = Json::parse(page_data({}, "Title", "1", PageCase{"x.toml", "a = \"<\""}));
  EXPECT_EQ(data["tables"], Json::array());
  EXPECT_EQ(data["case"], Json({{"file", "x.toml"}, {"text", "a = \"<\""}}));
}

TEST(PageData, IsMadeWithoutMetadataTooAndOfAnyBytes) {
  for (const char* const metadata : {"", "no JSON", "[1]", "{\"case\""}) {
    std::vector<PageTable> tables{small_table(metadata)};
    tables[0].title = "\xff";
    const Json data = Json::parse(page_data(tables, "\xfe", "1"));
    EXPECT_TRUE(data["tables"][0]["metadata"].is_null()) << metadata;
    EXPECT_EQ(data["tables"][0]["title"], "\xEF\xBF\xBD");
  }
}

}  // namespace
}  // namespace stationary::testing
