#pragma once

#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/view.h>

namespace hachure {

/// The uniform blocks View (binding 0) and Lights (binding 1) of shaders/common.
class ViewUniforms {
public:
    ViewUniforms();

    /// Uploads what changed since the last call and binds both blocks.
    void bind(const View& view, const LightList& lights);

private:
    gpu::Buffer view_buffer_;
    gpu::Buffer light_buffer_;
    View view_;
    LightList lights_;
    bool filled_ = false;
};

} // namespace hachure
