#include <hachure/editor/play/report_html.h>
#include <hachure/tests/editor/play/synthetic_results.h>

#include <gtest/gtest.h>

#include <limits>

namespace hachure::test {
namespace {

using namespace play;

TEST(ReportHtml, MarkupIsEscaped) {
    EXPECT_EQ(html_text("<script>alert(\"a\" && 'b')</script>"),
              "&lt;script&gt;alert(&quot;a&quot; &amp;&amp; &#39;b&#39;)&lt;/script&gt;");
    EXPECT_EQ(html_text("a\tb\nc"), "a\tb\nc");
    EXPECT_EQ(html_text(""), "");
}

TEST(ReportHtml, WhatIsNoTextIsReplaced) {
    const std::string no = "\xEF\xBF\xBD";
    EXPECT_EQ(html_text(std::string_view("a\0b\x1B\x7F", 5)), "a" + no + "b" + no + no);
    EXPECT_EQ(html_text("größe – 日本 😀"), "größe – 日本 😀");
    EXPECT_EQ(html_text("\xFF\xFE"), no + no);
    EXPECT_EQ(html_text("\xC3"), no);                            // cut short
    EXPECT_EQ(html_text("\xC3<"), no + "&lt;");                  // and it hides nothing
    EXPECT_EQ(html_text("\xC0\xBC"), no + no);                   // an overlong '<'
    EXPECT_EQ(html_text("\xE0\x80\xBC"), no + no + no);          // another
    EXPECT_EQ(html_text("\xED\xA0\x80"), no + no + no);          // a surrogate
    EXPECT_EQ(html_text("\xF4\x90\x80\x80"), no + no + no + no); // beyond Unicode
}

TEST(ReportHtml, NumbersAreForPeople) {
    EXPECT_EQ(html_number(0.21439), "0.2144");
    EXPECT_EQ(html_number(12.0), "12");
    EXPECT_EQ(html_number(-3.5), "−3.5");
    EXPECT_EQ(html_number(std::numeric_limits<double>::infinity()), "∞");
    EXPECT_EQ(html_number(std::numeric_limits<double>::quiet_NaN()), "n/a");
    EXPECT_EQ(html_seconds(0.431), "0.43 s");
    EXPECT_EQ(html_seconds(12.43), "12.4 s");
    EXPECT_EQ(html_seconds(200.2), "3 min 20 s");
}

TEST(ReportHtml, APictureIsTheFileItself) {
    const TempFolder folder;
    const std::string html = html_picture(picture(folder, "p.png", ball(0.5, 20, 10)), "a \"ball\"", "x");
    EXPECT_TRUE(html.starts_with("<img class=\"x\" alt=\"a &quot;ball&quot;\" width=\"20\" height=\"10\""));
    const std::size_t at = html.find("data:image/png;base64,iVBORw0KGgo"); // as every PNG begins
    ASSERT_NE(at, std::string::npos);
    const std::size_t size = html.size() - 2 - at - std::string("data:image/png;base64,").size();
    EXPECT_EQ(size, (file_text(folder / "p.png").size() + 2) / 3 * 4);
}

TEST(ReportHtml, APictureThatIsNoneIsMissing) {
    const TempFolder folder;
    const auto good = picture(folder, "p.png", ball(0.5, 20, 10));
    const auto cut = folder.write("<cut>.png", file_text(good).substr(0, 60));
    const auto svg = folder.write("p.svg.png", "<svg onload='alert(1)'/>");
    for (const auto& path : {cut, svg, folder / "absent.png", folder.path(), std::filesystem::path()}) {
        const std::string html = html_picture(path, "frame 3", "golden");
        EXPECT_EQ(html.find("<img"), std::string::npos) << path;
        EXPECT_NE(html.find("class=\"missing golden\""), std::string::npos) << path;
    }
    EXPECT_NE(html_picture(cut, "frame 3").find("&lt;cut&gt;.png"), std::string::npos);
}

} // namespace
} // namespace hachure::test
