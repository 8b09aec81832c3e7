#include <hachure/runtime/scene/frame_requests.h>

namespace hachure {

FrameRequests& frame_requests(World& world) {
    if (FrameRequests* requests = world.find_resource<FrameRequests>()) return *requests;
    return world.set_resource(FrameRequests{});
}

} // namespace hachure
