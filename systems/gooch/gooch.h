#pragma once

namespace hachure {

class App;

/// Surfaces that carry Gooch are drawn with cool-to-warm tones (Gooch et al. 1998, section 4.2).
void register_gooch(App& app);

} // namespace hachure
