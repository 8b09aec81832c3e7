// README.md quotes programs from their files: what it shows is what is built and tested.

#include <hachure/tests/layers/source_tree.h>

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

namespace hachure::test {
namespace {

struct Quotation {
    std::string file;
    std::string text;
};

/// Every "<!-- quote: FILE -->" of a page with the fenced block that follows it.
std::vector<Quotation> quotations(const std::string& page) {
    const std::string marker = "<!-- quote: ";
    std::vector<Quotation> result;
    std::ifstream stream(source_root() / page);
    for (std::string line; std::getline(stream, line);) {
        if (!line.starts_with(marker)) continue;
        Quotation quotation{line.substr(marker.size(), line.find(' ', marker.size()) - marker.size()), {}};
        std::getline(stream, line);
        EXPECT_EQ(line, "```cpp") << "after the marker of " << quotation.file;
        while (std::getline(stream, line) && line != "```") quotation.text += line + "\n";
        result.push_back(std::move(quotation));
    }
    return result;
}

/// What stands between "// [readme]" and "// [/readme]" in a file.
std::string marked_part(const std::string& file) {
    std::string text;
    bool inside = false;
    std::ifstream stream(source_root() / file);
    for (std::string line; std::getline(stream, line);) {
        if (line == "// [/readme]") inside = false;
        if (inside) text += line + "\n";
        if (line == "// [readme]") inside = true;
    }
    return text;
}

TEST(Readme, QuotesProgramsAsTheyAre) {
    const std::vector<Quotation> all = quotations("README.md");
    ASSERT_FALSE(all.empty());
    for (const Quotation& quotation : all) {
        EXPECT_FALSE(quotation.text.empty()) << quotation.file;
        EXPECT_EQ(quotation.text, marked_part(quotation.file)) << "`./dev readme` renews it";
    }
}

} // namespace
} // namespace hachure::test
