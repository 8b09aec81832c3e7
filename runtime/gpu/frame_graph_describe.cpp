#include <hachure/runtime/gpu/frame_graph_state.h>

#include <fmt/format.h>

#include <iterator>

namespace hachure::gpu {
namespace {

using detail::Access;
using detail::TextureNode;
using detail::TextureUse;

std::string_view to_string(Format format) {
    switch (format) {
    case Format::r8:
        return "r8";
    case Format::rg8:
        return "rg8";
    case Format::rgba8:
        return "rgba8";
    case Format::srgb8_alpha8:
        return "srgb8_alpha8";
    case Format::r16f:
        return "r16f";
    case Format::rg16:
        return "rg16";
    case Format::rgba16:
        return "rgba16";
    case Format::rg16f:
        return "rg16f";
    case Format::rgba16f:
        return "rgba16f";
    case Format::r32f:
        return "r32f";
    case Format::rg32f:
        return "rg32f";
    case Format::rgba32f:
        return "rgba32f";
    case Format::r32ui:
        return "r32ui";
    case Format::rg32ui:
        return "rg32ui";
    case Format::depth32f:
        return "depth32f";
    case Format::depth24:
        return "depth24";
    }
    return "?";
}

std::string_view fate(const TextureNode& texture) {
    if (!texture.owned()) return "imported";
    if (!texture.survives()) return "unused";
    return texture.kept ? "kept" : "transient";
}

std::string version_name(const TextureNode& texture, std::uint32_t version) {
    return fmt::format("{}.{}", texture.name, version);
}

std::string describe_use(const TextureNode& texture, const TextureUse& use) {
    const std::string name = version_name(texture, use.version);
    switch (use.access) {
    case Access::create:
        return fmt::format("create {} {}x{} {} {}", name, texture.desc.width, texture.desc.height,
                           to_string(texture.desc.format), fate(texture));
    case Access::read:
        return "read " + name;
    case Access::write:
        return fmt::format("write {} -> {}", version_name(texture, use.version - 1), name);
    }
    return {};
}

/// A string in Graphviz's quotes.
std::string quoted(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

} // namespace

std::string FrameGraph::describe() const {
    const auto& frame = state_->frame;
    std::string out;
    for (const detail::PassNode& pass : frame.passes) {
        fmt::format_to(std::back_inserter(out), "{}: {}\n", pass.name, gpu::to_string(pass.state));
        for (const TextureUse& use : pass.uses) {
            fmt::format_to(std::back_inserter(out), "  {}\n", describe_use(frame.textures[use.texture], use));
        }
    }
    for (const TextureNode& texture : frame.textures) {
        if (!texture.required) continue;
        fmt::format_to(std::back_inserter(out), "require {}\n", version_name(texture, *texture.required));
    }
    return out;
}

std::string FrameGraph::describe_dot() const {
    const auto& frame = state_->frame;
    std::string out = "digraph frame {\n  rankdir=LR\n";
    for (const detail::PassNode& pass : frame.passes) {
        const std::string node = quoted("pass " + pass.name);
        const auto label = quoted(fmt::format("{}\n{}", pass.name, gpu::to_string(pass.state)));
        fmt::format_to(std::back_inserter(out), "  {} [shape=box label={}]\n", node, label);
        for (const TextureUse& use : pass.uses) {
            const TextureNode& texture = frame.textures[use.texture];
            const std::string version = quoted(version_name(texture, use.version));
            if (use.access == Access::write) {
                const std::string onto = quoted(version_name(texture, use.version - 1));
                fmt::format_to(std::back_inserter(out), "  {} -> {}\n", onto, node);
            }
            fmt::format_to(std::back_inserter(out), "  {} -> {}\n", use.writes() ? node : version,
                           use.writes() ? version : node);
        }
    }
    return out + "}\n";
}

} // namespace hachure::gpu
