#pragma once

#include <string>

namespace CLI {
class App;
}

namespace hachure {

/// `hachure list`, as the user typed it.
struct ListOptions {
    std::string what;      ///< styles, components, aovs, systems or schema
    bool markdown = false; ///< the reference page, for components alone
};

void add_list_command(CLI::App& app, ListOptions& options);

/// Prints what there is of the kind. Throws UsageError for an unknown kind, and for Markdown of another kind than
/// components.
int run_list(const ListOptions& options);

} // namespace hachure
