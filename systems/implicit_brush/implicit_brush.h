#pragma once

namespace hachure {

class App;

/// Lines along features of what is seen, painted with brushes (Implicit Brushes, Vergne et al. 2011): components
/// ImplicitBrush and FeatureImage.
void register_implicit_brush(App& app);

} // namespace hachure
