#include <hachure/tests/layers/source_tree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

// HACHURE_UNITY compiles the .cpp files of a folder together, so that what their anonymous namespaces hold meets.
namespace hachure::test {
namespace {

/// The types, variables and functions that the anonymous namespaces of a formatted source declare, one string each: the
/// name, and a function's parameters as they are written, since overloads may live together. It looks at what stands at
/// the start of lines, and knows no C++ beyond that: it finds most names, and leaves the others to the compiler.
std::vector<std::string> anonymous_names(const std::string& source) {
    static const std::regex type("(?:template <.*> )?(?:struct|class|enum|union)(?: class)? (\\w+).*");
    static const std::regex other(
        "(?!using |namespace | )[\\w:<>,*& ]*[ >*&](\\w+)(?:\\[[^\\]]*\\])*(?: =|[({;]).*");
    std::vector<std::string> names;
    bool inside = false;
    std::istringstream stream(source);
    for (std::string line; std::getline(stream, line);) {
        if (line == "namespace {") inside = true;
        if (line == "} // namespace") inside = false;
        std::smatch match;
        if (!inside || (!std::regex_match(line, match, type) && !std::regex_match(line, match, other))) continue;
        std::string name = match[1];
        if (name == "operator") continue;
        const std::size_t open = static_cast<std::size_t>(match.position(1)) + name.size();
        if (line[open] == '(') {
            for (std::string more; line.find_first_of("{;", open) == line.npos && std::getline(stream, more);)
                line += more.substr(std::min(more.find_first_not_of(' ') - 1, more.size()));
            const std::size_t end = std::min(line.find_first_of("{;", open), line.size());
            name += line.substr(open, line.find_last_of(')', end) + 1 - open);
        }
        names.push_back(name);
    }
    return names;
}

/// What one file declares twice is for the compiler to judge: declarations and definitions, specialisations.
using FilesOfName = std::map<std::string, std::set<std::string>>;

/// The names of each folder that is compiled together.
std::map<std::string, FilesOfName> names_by_folder() {
    std::map<std::string, FilesOfName> folders;
    for (const std::string layer : {"runtime", "components", "systems", "editor", "tests"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(source_root() / layer)) {
            if (entry.path().extension() != ".cpp") continue;
            std::ifstream stream(entry.path());
            const std::string folder = entry.path().parent_path().lexically_relative(source_root()).generic_string();
            for (const std::string& name : anonymous_names({std::istreambuf_iterator<char>(stream), {}}))
                folders[folder][name].insert(entry.path().filename().string());
        }
    folders.erase("tests/benchmarks"); // mostly programs of their own
    return folders;
}

TEST(AnonymousNames, AreUniqueInTheirFolder) {
    std::size_t checked = 0;
    for (const auto& [folder, names] : names_by_folder())
        for (const auto& [name, files] : names) {
            EXPECT_EQ(files.size(), 1u) << name << " is in the anonymous namespaces of " << folder << "/"
                                        << testing::PrintToString(files);
            ++checked;
        }
    EXPECT_GT(checked, 1000u) << "the sources were not found";
}

TEST(AnonymousNames, AreTypesVariablesAndFunctionsWithTheirParameters) {
    const std::string source = R"(namespace hachure {
int outside = 1;
namespace {

using std::numbers::pi;
constexpr double first = 1.0;
const std::map<std::string, int> table{
    {"a", 1},
};
int counts[3][2];
struct Plain {
    int member = 0;
};
enum class Kind { one };
template <class T> struct Generic;
bool operator==(const Plain& a, const Plain& b) { return a.member == b.member; }
double Plain::twice() { return 2.0; }
std::vector<int> read(const std::string& text,
                      std::function<void()> done) {
    return {};
}
template <class T> T read(T value) { return value; }
TEST(Suite, Name) {}

} // namespace

int also_outside() { return 1; }
} // namespace hachure
)";
    const std::vector<std::string> expected{"first",
                                            "table",
                                            "counts",
                                            "Plain",
                                            "Kind",
                                            "Generic",
                                            "read(const std::string& text, std::function<void()> done)",
                                            "read(T value)"};
    EXPECT_EQ(anonymous_names(source), expected);
}

} // namespace
} // namespace hachure::test
