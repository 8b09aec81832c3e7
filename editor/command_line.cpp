#include <hachure/editor/command_line.h>
#include <hachure/editor/info_command.h>
#include <hachure/editor/list_command.h>
#include <hachure/editor/render_command.h>
#include <hachure/editor/usage_error.h>
#include <hachure/editor/validate_command.h>
#include <hachure/runtime/error.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <string>

namespace hachure {
namespace {

constexpr int exit_failed = 1;
constexpr int exit_usage = 2;

/// Several lines become one: scripts read our errors line by line.
std::string one_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    for (char& c : text)
        if (c == '\n' || c == '\r') c = ' ';
    return text;
}

int report(const std::string& message, int code) {
    std::fprintf(stderr, "hachure: error: %s\n", one_line(message).c_str());
    return code;
}

/// Help and version go to stdout with exit 0, everything else is wrong usage.
int report_parse(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    report(std::string(error.what()) + " (see hachure --help)", exit_usage);
    return exit_usage;
}

} // namespace

int run_command_line(int argc, char** argv) {
    CLI::App app("Hachure: real-time non-photorealistic rendering", "hachure");
    app.set_version_flag("--version", std::string("hachure ") + HACHURE_VERSION);
    app.require_subcommand(1);
    RenderOptions render;
    InfoOptions info;
    ListOptions list;
    ValidateOptions validate;
    add_render_command(app, render);
    add_info_command(app, info);
    add_list_command(app, list);
    add_validate_command(app, validate);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return report_parse(app, error);
    }
    try {
        if (app.got_subcommand("render")) return run_render(render);
        if (app.got_subcommand("info")) return run_info(info);
        if (app.got_subcommand("validate")) return run_validate(validate);
        return run_list(list);
    } catch (const UsageError& error) {
        return report(error.what(), exit_usage);
    } catch (const std::bad_alloc&) {
        return report("not enough memory", exit_failed);
    } catch (const std::exception& error) {
        return report(error.what(), exit_failed);
    }
}

} // namespace hachure
