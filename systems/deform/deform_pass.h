#pragma once

namespace hachure {

class App;

/// Pass "deform": makes the shapes of seen surfaces that are deformed on the GPU (DeformInputs) before anything draws
/// them. There is none in frames without such surfaces; it is reused while none of them changed.
void register_deform_pass(App& app);

} // namespace hachure
