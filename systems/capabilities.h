#pragma once

namespace hachure {

class App;

/// Registers every capability of the house, in the order in which they draw. A program that wants fewer calls their own
/// functions (`register_gooch`, ...).
void register_capabilities(App& app);

} // namespace hachure
