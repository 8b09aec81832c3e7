#pragma once

#include <hachure/components/name_index.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/scene/renderer.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace hachure::play {

/// A frame that was just played. What expectations read from the GPU is read once.
class PlayedFrame {
public:
    /// `names` must be up to date.
    PlayedFrame(std::int64_t number, App& app, Renderer& renderer, const NameIndex& names,
                std::optional<std::uint64_t> allocations)
        : number_(number), app_(&app), renderer_(&renderer), names_(&names), allocations_(allocations) {}

    [[nodiscard]] std::int64_t number() const { return number_; }
    [[nodiscard]] App& app() { return *app_; }
    [[nodiscard]] const World& world() const { return app_->world(); }
    [[nodiscard]] Renderer& renderer() { return *renderer_; }
    [[nodiscard]] const NameIndex& names() const { return *names_; }

    /// How often systems before stage render allocated memory; nothing when nobody counts.
    [[nodiscard]] std::optional<std::uint64_t> allocations() const { return allocations_; }

    /// The picture; of frames that were drawn.
    const assets::Image& picture() {
        if (!picture_) picture_ = renderer_->read_picture();
        return *picture_;
    }

    /// A buffer that was asked for; of frames that were drawn.
    const assets::Image& aov(const std::string& name) {
        const auto found = aovs_.find(name);
        return found != aovs_.end() ? found->second : aovs_.emplace(name, renderer_->read_aov(name)).first->second;
    }

private:
    std::int64_t number_;
    App* app_;
    Renderer* renderer_;
    const NameIndex* names_;
    std::optional<std::uint64_t> allocations_;
    std::optional<assets::Image> picture_;
    std::map<std::string, assets::Image> aovs_;
};

} // namespace hachure::play
