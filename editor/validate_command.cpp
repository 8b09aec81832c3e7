#include <hachure/editor/play/play_document.h>
#include <hachure/editor/validate_command.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/json_text.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/scene/load_scene.h>
#include <hachure/systems/styles/style.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace hachure {
namespace {

Findings check_scene(const std::filesystem::path& file) {
    App app;
    register_capabilities(app);
    const SceneFindings found = inspect_scene(app, file);
    Findings result;
    for (const SceneFault& fault : found.faults)
        result.faults.emplace_back(Error(fault.subject, fault.fault, fault.where).what());
    result.warnings = found.warnings;
    return result;
}

/// Every component of a style on its own, so that the fault of one does not hide that of another.
Findings check_style(const std::filesystem::path& file) {
    App app;
    register_capabilities(app);
    Findings result;
    const assets::JsonText text = assets::JsonText::read(file);
    for (std::string& fault : style_faults(app.types(), text)) result.faults.push_back(std::move(fault));
    return result;
}

Findings check_play(const std::filesystem::path& file) {
    App app;
    register_capabilities(app);
    return {play::play_faults(app.types(), file), {}};
}

Findings check_model(const std::filesystem::path& file) { return {{}, assets::read_model(file).warnings}; }

Findings check(const std::filesystem::path& file) {
    const std::vector<Checker> kinds = checkers();
    const std::string name = file.filename().string();
    const auto kind = std::ranges::find_if(kinds, [&](const Checker& one) { return name.ends_with(one.ending); });
    try {
        if (kind != kinds.end()) return kind->check(file);
        if (assets::input_kind(file) == assets::InputKind::model) return check_model(file);
        throw Error(file.string(), "is no kind of file that can be checked: scenes (.scene.json), playback tests "
                                   "(.play.json), styles (.json), models");
    } catch (const Error& error) {
        return {{error.what()}, {}};
    }
}

void print_text(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

} // namespace

std::vector<Checker> checkers() {
    return {{".scene.json", "scene", check_scene},
            {".play.json", "playback test", check_play},
            {".json", "style", check_style}};
}

void add_validate_command(CLI::App& app, ValidateOptions& options) {
    CLI::App* command = app.add_subcommand("validate", "Tell all that is wrong with scenes, styles and models");
    command->add_option("FILE", options.files, "a scene (.scene.json), a playback test (.play.json), a style (.json) or a model")->required();
}

int run_validate(const ValidateOptions& options) {
    std::size_t faults = 0, warnings = 0;
    for (const std::filesystem::path& file : options.files) {
        const Findings found = check(file);
        faults += found.faults.size();
        warnings += found.warnings.size();
        for (const std::string& fault : found.faults) print_text("fault: " + fault + "\n");
        for (const std::string& warning : found.warnings) print_text("warning: " + warning + "\n");
    }
    print_text(fmt::format("{} {}, {} {}, {} {}\n", options.files.size(), options.files.size() == 1 ? "file" : "files",
                      faults, faults == 1 ? "fault" : "faults", warnings, warnings == 1 ? "warning" : "warnings"));
    return faults == 0 ? 0 : 1;
}

} // namespace hachure
