#pragma once

namespace hachure {

class App;

/// Draws the picture on paper (components/paper.h) where the view's camera carries one, and lays lines over it on the
/// way. Its system comes after those of every capability that draws surfaces or lines, and before compose.
void register_paper(App& app);

} // namespace hachure
