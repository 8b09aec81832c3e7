#include <hachure/systems/deform/deform_input.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace hachure {
namespace {

template <class Entry> void append_palette(const std::vector<Entry>& palette, std::vector<glm::vec4>& pose) {
    static_assert(sizeof(Entry) == 4 * sizeof(glm::vec4) && std::is_trivially_copyable_v<Entry>);
    pose.resize(4 * palette.size());
    if (!palette.empty()) std::memcpy(pose.data(), palette.data(), palette.size() * sizeof(Entry));
}

} // namespace

DeformInput deform_input(const DeformState& state, std::uint64_t version) {
    DeformInput input{.mesh = state.mesh,
                      .version = version,
                      .method = state.settings.method,
                      .palette_size = state.palette.size(),
                      .morphs = false,
                      .pose = {}};
    if (input.method == geometry::SkinMethod::dual_quaternion)
        append_palette(state.motions, input.pose);
    else
        append_palette(state.palette, input.pose);
    const auto counts = [](float weight) { return weight != 0.0f && std::isfinite(weight); };
    input.morphs = std::ranges::any_of(state.weights, counts);
    if (!input.morphs) return input;
    const std::size_t first = input.pose.size();
    input.pose.resize(first + (state.weights.size() + 3) / 4, glm::vec4(0.0f));
    for (std::size_t t = 0; t < state.weights.size(); ++t)
        if (counts(state.weights[t])) input.pose[first + t / 4][static_cast<int>(t % 4)] = state.weights[t];
    return input;
}

} // namespace hachure
