#pragma once

namespace hachure {

class App;

/// Surfaces that carry Metal are drawn as milled metal: stripes of random intensity across the direction of least
/// curvature, the one that faces the light white (Gooch et al. 1998, section 4.3).
void register_metal(App& app);

} // namespace hachure
