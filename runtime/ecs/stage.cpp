#include <hachure/runtime/ecs/stage.h>

#include <array>
#include <cstddef>

namespace hachure {

std::string_view to_string(Stage stage) {
    constexpr std::array<std::string_view, 8> names{"input",  "script", "animate",  "transform",
                                                    "deform", "light",  "material", "render"};
    return names[static_cast<std::size_t>(stage)];
}

} // namespace hachure
