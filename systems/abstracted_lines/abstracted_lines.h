#pragma once

namespace hachure {

class App;

/// Surfaces that carry AbstractedLines get lines where the shaded picture is thin, dark or bright, or breaks off
/// (Lee et al. 2007): the scene's tone is drawn and blurred, and each pixel looks for a ridge or valley beside it.
/// docs/abstracted-lines.md says how.
void register_abstracted_lines(App& app);

} // namespace hachure
