#include <hachure/tests/layers/source_tree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

namespace hachure::test {
namespace {

bool exists(const std::string& path) { return std::filesystem::exists(source_root() / path); }

std::string text_of(const std::string& path) {
    std::ifstream stream(source_root() / path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The layers that each layer may include.
const std::map<std::string, std::set<std::string>> allowed_layers{
    {"runtime", {"runtime"}},
    {"components", {"runtime", "components"}},
    {"systems", {"runtime", "components", "systems"}},
    {"samples", {"runtime", "components", "systems", "samples"}},
    {"editor", {"runtime", "components", "systems", "editor"}},
    {"tests", {"runtime", "components", "systems", "samples", "editor", "tests"}},
};

/// The modules of runtime/ that each may include; files at the root of runtime/ are for all.
const std::map<std::string, std::set<std::string>> allowed_modules{
    {"ecs", {}},
    {"gpu", {}},
    {"geometry", {}},
    {"assets", {"geometry"}},
    {"animation", {"assets"}},
    {"picture", {"assets"}},
    {"app", {"ecs"}},
    {"scene", {"ecs", "gpu", "geometry", "assets", "animation", "app"}},
};

TEST(Layers, IncludesGoOnlyToTheLeft) {
    std::size_t checked = 0;
    for (const auto& [layer, allowed] : allowed_layers)
        for (const Include& include : source_includes({layer})) {
            EXPECT_TRUE(allowed.contains(top(include.to, 1))) << include.from << " includes " << include.to;
            ++checked;
        }
    EXPECT_GT(checked, 100u) << "the sources were not found";
}

TEST(Layers, EveryIncludeExists) {
    for (const auto& [layer, allowed] : allowed_layers)
        for (const Include& include : source_includes({layer}))
            EXPECT_TRUE(exists(include.to)) << include.from << " includes " << include.to;
}

TEST(Layers, ModulesOfTheRuntimeKeepTheirOrder) {
    for (const std::string& module : folders_in("runtime"))
        EXPECT_TRUE(allowed_modules.contains(module)) << "runtime/" << module << " has no place in the order";
    for (const auto& [module, allowed] : allowed_modules)
        for (const Include& include : source_includes({"runtime/" + module})) {
            const std::string to = include.to.substr(std::string("runtime/").size());
            const bool at_root = to.find('/') == to.npos;
            EXPECT_TRUE(at_root || top(to, 1) == module || allowed.contains(top(to, 1)))
                << include.from << " includes " << include.to;
        }
}

TEST(Layers, ComponentsNeedReflectionAndPlainDataAlone) {
    const std::set<std::string> allowed{"runtime/ecs", "runtime/geometry", "runtime/animation"};
    for (const Include& include : source_includes({"components"}))
        EXPECT_TRUE(top(include.to, 1) == "components" || allowed.contains(top(include.to, 2)))
            << include.from << " includes " << include.to;
}

TEST(Layers, CapabilitiesDoNotIncludeEachOther) {
    const std::set<std::string> services{"systems/model", "systems/styles"}; // for whoever loads files
    for (const Include& include : source_includes({"systems"})) {
        if (include.from == "systems/capabilities.cpp") continue; // the one place that names them all
        const std::string to = top(include.to, 2);
        EXPECT_TRUE(top(include.to, 1) != "systems" || to == top(include.from, 2) || services.contains(to))
            << include.from << " includes " << include.to;
    }
}

TEST(Layers, ShadersIncludeTheCommonOnesAndTheirOwn) {
    const std::vector<Include> includes = shader_includes();
    EXPECT_FALSE(includes.empty());
    for (const Include& include : includes) {
        const std::string folder = top(include.to, 2);
        EXPECT_TRUE(folder == "shaders/common" || folder == "shaders/surface" || folder == top(include.from, 2))
            << include.from << " includes " << include.to;
        EXPECT_TRUE(exists(include.to)) << include.from << " includes " << include.to;
    }
}

/// A capability is a folder of systems/ with a register_ function; services for programs (model, styles) have none.
std::vector<std::string> capabilities() {
    std::vector<std::string> names;
    for (const std::string& name : folders_in("systems"))
        if (text_of("systems/" + name + "/" + name + ".h").find("register_" + name + "(") != std::string::npos)
            names.push_back(name);
    return names;
}

TEST(Capabilities, HaveAComponentOfTheirName) {
    const std::vector<std::string> names = capabilities();
    EXPECT_GE(names.size(), 5u);
    const std::set<std::string> buffers{"velocity"}; // what is asked for as a buffer, and by no entity
    for (const std::string& name : names)
        EXPECT_NE(exists("components/" + name + ".h"), buffers.contains(name)) << name;
}

TEST(Capabilities, AreRegisteredByTheProgramOnce) {
    const std::string text = text_of("systems/capabilities.cpp");
    for (const std::string& name : capabilities()) {
        const std::string call = "    register_" + name + "(app);";
        const std::size_t first = text.find(call);
        EXPECT_NE(first, text.npos) << name;
        EXPECT_EQ(text.find(call, first + 1), text.npos) << name << " is registered twice";
    }
}

TEST(Capabilities, HaveAPlaybackTestOfTheirName) {
    for (const std::string& name : capabilities()) EXPECT_TRUE(exists("tests/playback/" + name + ".play.json")) << name;
}

TEST(Capabilities, ShaderFoldersBelongToOne) {
    const std::vector<std::string> names = capabilities();
    for (const std::string& folder : folders_in("shaders"))
        EXPECT_TRUE(folder == "common" || std::ranges::find(names, folder) != names.end()) << "shaders/" << folder;
}

TEST(Capabilities, ComponentsAreReflectedUnderTheNameOfTheirFile) {
    for (const std::string& name : stems_in("components", ".h")) {
        const std::string text = text_of("components/" + name + ".h");
        if (text.find("reflect(") == text.npos) continue; // what no file or user names
        EXPECT_NE(text.find("type.name(\"" + name + "\")"), text.npos) << name;
    }
}

} // namespace
} // namespace hachure::test
