#pragma once

namespace hachure {

class App;

/// WorldTransform follows Transform (or LocalMatrix) and the parents; only changed branches are visited.
void register_transform(App& app);

} // namespace hachure
