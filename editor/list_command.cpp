#include <hachure/editor/component_reference.h>
#include <hachure/editor/list_command.h>
#include <hachure/editor/usage_error.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/scene/scene_schema.h>
#include <hachure/systems/styles/style.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace hachure {
namespace {

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

std::string range_text(const FieldInfo& field) {
    if (field.kind == FieldKind::enumeration) {
        std::string names;
        for (const std::string& option : field.options) names += (names.empty() ? "" : "|") + option;
        return names;
    }
    std::string text(to_string(field.kind));
    if (field.range) text += fmt::format(" [{:g}, {:g}]", field.range->min, field.range->max);
    if (!field.unit.empty()) text += " " + field.unit;
    return text;
}

/// A type's name as the compiler spells it, without the namespaces that the house's own types are in.
std::string bare_name(std::string_view name) {
    std::string text(name);
    for (const std::string_view space : {"hachure::", "(anonymous namespace)::", "{anonymous}::", "<unnamed>::"})
        for (std::size_t at = text.find(space); at != std::string::npos; at = text.find(space, at))
            text.erase(at, space.size());
    return text;
}

void list_styles(const App& app) {
    for (const BuiltInStyle& style : built_in_styles())
        print(fmt::format("{:<10} {}\n", style.name, parse_style(app.types(), style.name, style.text).doc));
}

void list_components(const App& app) {
    for (const TypeInfo& type : app.types().types()) {
        print(fmt::format("{}  {}\n", type.name, type.doc));
        for (const FieldInfo& field : type.fields)
            print(fmt::format("  {:<18} {:<24} default {:<12} {}\n", field.name, range_text(field),
                              format_field(field, field.default_value), field.doc));
    }
}

void list_aovs(App& app) {
    for (const AovInfo& aov : frame_requests(app.world()).known) {
        std::string channels;
        for (const std::string& channel : aov.channel_names) channels += (channels.empty() ? "" : " ") + channel;
        print(fmt::format("{:<12} {:<30} {}\n", aov.name, channels, aov.doc));
    }
}

/// "reads A, B; writes C; queues commands", as far as it applies.
std::string access_text(const Access& access) {
    if (access.exclusive) return "anything; runs alone";
    std::vector<std::string> reads, writes;
    if (access.reads_world) reads.emplace_back("anything");
    for (const auto* items : {&access.components, &access.resources})
        for (const Access::Item& item : *items) (item.writes ? writes : reads).push_back(bare_name(item.name));
    std::ranges::sort(reads);
    std::ranges::sort(writes);
    std::vector<std::string> parts;
    if (!reads.empty()) parts.push_back(fmt::format("reads {}", fmt::join(reads, ", ")));
    if (!writes.empty()) parts.push_back(fmt::format("writes {}", fmt::join(writes, ", ")));
    if (access.commands) parts.emplace_back("queues commands");
    return fmt::format("{}", fmt::join(parts, "; "));
}

void list_systems(App& app) {
    for (const SystemInfo& system : app.schedule().systems())
        print(fmt::format("{:<10} {:<18} {}\n", to_string(system.stage), system.name, access_text(system.access)));
}

} // namespace

void add_list_command(CLI::App& app, ListOptions& options) {
    CLI::App* command = app.add_subcommand(
        "list", "List the styles, components, AOVs or systems that there are, or the schema of scene files");
    command
        ->add_option("KIND", options.what, "styles, components, aovs, systems or schema (JSON schema of scene files)")
        ->required();
    command->add_flag("--markdown", options.markdown,
                      "Print the reference page of the components (docs/components.md)");
}

int run_list(const ListOptions& options) {
    if (options.markdown && options.what != "components")
        throw UsageError("list: --markdown is for components, not for '" + options.what + "'");
    App app;
    register_capabilities(app);
    if (options.what == "styles")
        list_styles(app);
    else if (options.markdown)
        print(component_reference(app.types()));
    else if (options.what == "components")
        list_components(app);
    else if (options.what == "aovs")
        list_aovs(app);
    else if (options.what == "systems")
        list_systems(app);
    else if (options.what == "schema")
        print(scene_schema(app.world(), app.types()).dump(2) + "\n");
    else
        throw UsageError("list: '" + options.what + "' is none of styles, components, aovs, systems, schema");
    return 0;
}

} // namespace hachure
