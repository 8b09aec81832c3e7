#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <string>

namespace hachure {

enum class Repeat { once, loop, ping_pong };

/// Plays a clip of the model whose root carries it (see Rig). A change of `clip` fades from what is shown to the new
/// one, which begins at its start.
struct Animation {
    std::string clip; ///< empty: the pose that the file itself shows
    Repeat repeat = Repeat::loop;
    bool playing = true;
    float speed = 1.0f;
    float offset = 0.0f;
    float fade = 0.2f;
    double time = 0.0;

    friend bool operator==(const Animation&, const Animation&) = default;
};

inline void reflect(TypeBuilder<Animation>& type) {
    type.name("animation").doc("the clip that a character plays");
    type.field("clip", &Animation::clip).doc("name of the clip; empty for the pose that the file shows");
    type.field("repeat", &Animation::repeat)
        .doc("what comes after the clip's end")
        .options({"once", "loop", "ping_pong"});
    type.field("playing", &Animation::playing).doc("whether time goes on");
    type.field("speed", &Animation::speed)
        .doc("clip seconds per second; negative plays from the end to the start")
        .range(-1000, 1000);
    type.field("offset", &Animation::offset)
        .doc("clip seconds that count as played when it begins")
        .unit("s")
        .range(-1e6, 1e6);
    type.field("fade", &Animation::fade)
        .doc("how long a change of clip blends from the one before")
        .unit("s")
        .range(0, 1000);
    type.field("time", &Animation::time).doc("clip seconds that it has played").unit("s").range(0, 1e9);
}

} // namespace hachure
