#pragma once

namespace hachure {

class App;

/// Lays the layers of a view over each other, makes the AOV `depth` on request and the texture `picture` that windows
/// and files show. Its system comes after those of every capability that draws.
void register_compose(App& app);

} // namespace hachure
