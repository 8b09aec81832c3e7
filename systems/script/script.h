#pragma once

namespace hachure {

class App;

/// Entities with a Script run it: Lua files, compiled once, that read and write the world (docs/scripts.md). What a
/// script may use is bounded by the resource ScriptLimits; those that fail are listed in the resource ScriptErrors.
/// The system is "script.run", after "timeline".
void register_script(App& app);

} // namespace hachure
