#pragma once

#include <hachure/runtime/ecs/world.h>

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace hachure {

/// A named float buffer of the frame that can be asked for (`--aov NAME=FILE.exr`).
struct AovInfo {
    std::string name;                       ///< also the name of the frame-graph texture that holds it
    std::string doc;                        ///< one line: what it is, unit, value where nothing is drawn
    std::vector<std::string> channel_names; ///< of the EXR file, in the order of the texture's channels
};

/// What the parts of a frame ask of each other. A resource.
struct FrameRequests {
    std::vector<AovInfo> known;                  ///< every AOV that a registered capability can make
    std::set<std::string, std::less<>> aovs;     ///< what the program wants, every frame, by name
    std::set<std::string, std::less<>> textures; ///< what systems of stage `material` want of this frame, by name

    [[nodiscard]] bool wants(std::string_view name) const { return aovs.contains(name) || textures.contains(name); }
};

/// The world's FrameRequests, made when there are none yet.
[[nodiscard]] FrameRequests& frame_requests(World& world);

} // namespace hachure
