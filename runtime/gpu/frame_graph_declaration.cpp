#include <hachure/runtime/gpu/frame_graph_declaration.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>

namespace hachure::gpu::detail {
namespace {

/// Different in every frame of every graph of the process, so that a handle that strays into another one is noticed.
std::uint32_t next_stamp() {
    static std::atomic<std::uint32_t> last{0};
    std::uint32_t stamp = ++last;
    if (stamp == 0) stamp = ++last; // 0 marks the empty handle
    return stamp;
}

void check_desc(const TextureDesc& desc, std::string_view name, const std::string& who) {
    const auto fail = [&](const std::string& fault) {
        throw FrameGraphError(fmt::format("{} '{}' with {}", who, name, fault));
    };
    if (desc.width < 1 || desc.height < 1) fail(fmt::format("size {}x{}", desc.width, desc.height));
    const int most_levels = std::bit_width(static_cast<unsigned>(std::max(desc.width, desc.height)));
    if (desc.levels < 1 || desc.levels > most_levels) {
        fail(fmt::format("{} levels at size {}x{}", desc.levels, desc.width, desc.height));
    }
    if (desc.samples < 1) fail(fmt::format("{} samples", desc.samples));
    if (desc.samples > 1 && desc.levels > 1) fail("both samples and levels");
}

} // namespace

void FrameDeclaration::reset() {
    passes.clear();
    textures.clear();
    pass_names_.clear();
    texture_names_.clear();
    imported_ids_.clear();
    stamp_ = next_stamp();
}

std::uint32_t FrameDeclaration::add_pass(std::string_view name) {
    const auto index = static_cast<std::uint32_t>(passes.size());
    const std::uint64_t key = key_of(name);
    if (!pass_names_.insert(key).second) throw FrameGraphError(fmt::format("two passes are called '{}'", name));
    PassNode& pass = passes.emplace_back();
    pass.name = name;
    pass.key = key;
    return index;
}

std::uint32_t FrameDeclaration::add_texture(std::string_view name, const TextureDesc& desc, const std::string& who) {
    check_desc(desc, name, who);
    const auto index = static_cast<std::uint32_t>(textures.size());
    const std::uint64_t key = key_of(name);
    const auto [known, is_new] = texture_names_.try_emplace(key, index);
    if (!is_new) {
        throw FrameGraphError(fmt::format("{} '{}', which {} already", who, name, maker(textures[known->second])));
    }
    TextureNode& texture = textures.emplace_back();
    texture.name = name;
    texture.key = key;
    texture.desc = desc;
    return index;
}

std::string FrameDeclaration::maker(const TextureNode& texture) const {
    if (!texture.owned()) return "was imported";
    return fmt::format("pass '{}' creates", passes[texture.writers.front()].name);
}

TextureHandle FrameDeclaration::import_texture(std::string_view name, const TextureDesc& desc, std::uint32_t id,
                                               ImportOptions options) {
    const std::uint32_t index = add_texture(name, desc, "the frame imports");
    const auto [known, is_new] = imported_ids_.try_emplace(id, index);
    if (!is_new) {
        throw FrameGraphError(fmt::format("the frame imports texture {} both as '{}' and as '{}'", id,
                                          textures[known->second].name, name));
    }
    textures[index].import = {id, options};
    textures[index].id = id;
    return {index, 0, stamp_};
}

TextureHandle FrameDeclaration::create(std::uint32_t pass, std::string_view name, const TextureDesc& desc) {
    const std::uint32_t index = add_texture(name, desc, fmt::format("pass '{}' creates", passes[pass].name));
    textures[index].writers.push_back(pass);
    return use(pass, index, Access::create, 1);
}

TextureHandle FrameDeclaration::read(std::uint32_t pass, TextureHandle handle) {
    const std::uint32_t index = newest_texture(pass, handle, "reads");
    const TextureNode& texture = textures[index];
    const TextureUse* known = find_use(pass, index);
    if (known && known->writes()) {
        throw FrameGraphError(
            fmt::format("pass '{}' reads '{}', which it also writes", passes[pass].name, texture.name));
    }
    if (handle.version_ == 0 && !texture.import->options.contents) {
        throw FrameGraphError(
            fmt::format("pass '{}' reads '{}', which no pass has written", passes[pass].name, texture.name));
    }
    return known ? handle : use(pass, index, Access::read, handle.version_);
}

TextureHandle FrameDeclaration::write(std::uint32_t pass, TextureHandle handle) {
    const std::uint32_t index = newest_texture(pass, handle, "writes");
    if (const TextureUse* known = find_use(pass, index)) {
        throw FrameGraphError(fmt::format("pass '{}' writes '{}', which it also {}", passes[pass].name,
                                          textures[index].name,
                                          known->access == Access::create ? "creates" : "reads or writes"));
    }
    textures[index].writers.push_back(pass);
    return use(pass, index, Access::write, handle.version_ + 1);
}

TextureHandle FrameDeclaration::use(std::uint32_t pass, std::uint32_t texture, Access access, std::uint32_t version) {
    passes[pass].uses.push_back({texture, version, access});
    return {texture, version, stamp_};
}

/// The texture of a handle that must name its newest version.
std::uint32_t FrameDeclaration::newest_texture(std::uint32_t pass, TextureHandle handle, std::string_view verb) const {
    if (!is_current(handle)) refuse(handle, fmt::format("pass '{}' {}", passes[pass].name, verb));
    const TextureNode& node = textures[handle.texture_];
    if (handle.version_ != node.newest()) {
        throw FrameGraphError(fmt::format("pass '{}' {} version {} of '{}', which pass '{}' has replaced by version {}",
                                          passes[pass].name, verb, handle.version_, node.name,
                                          passes[node.writers[handle.version_]].name, handle.version_ + 1));
    }
    return handle.texture_;
}

const TextureUse* FrameDeclaration::find_use(std::uint32_t pass, std::uint32_t texture) const {
    const auto& uses = passes[pass].uses;
    const auto found = std::find_if(uses.begin(), uses.end(), [&](const auto& use) { return use.texture == texture; });
    return found == uses.end() ? nullptr : &*found;
}

void FrameDeclaration::require(TextureHandle handle) {
    const TextureNode& node = texture(handle, "the frame requires");
    if (handle.version_ == 0) {
        throw FrameGraphError(fmt::format("the frame requires '{}', which no pass has written", node.name));
    }
    if (node.required && node.required != handle.version_) {
        throw FrameGraphError(fmt::format("the frame requires both version {} and version {} of '{}'", *node.required,
                                          handle.version_, node.name));
    }
    textures[handle.texture_].required = handle.version_;
}

const TextureNode& FrameDeclaration::texture(TextureHandle handle, std::string_view who) const {
    if (!is_current(handle)) refuse(handle, who);
    return textures[handle.texture_];
}

void FrameDeclaration::refuse(TextureHandle handle, std::string_view who) {
    if (!handle) throw FrameGraphError(fmt::format("{} an empty handle: no pass has written that texture", who));
    throw FrameGraphError(fmt::format("{} a handle of another frame or graph", who));
}

const TextureNode& FrameDeclaration::declared_texture(std::uint32_t pass, TextureHandle handle) const {
    const std::string& name = passes[pass].name;
    if (!is_current(handle)) refuse(handle, fmt::format("pass '{}' uses", name));
    const TextureNode& node = textures[handle.texture_];
    const TextureUse* known = find_use(pass, handle.texture_);
    if (!known) throw FrameGraphError(fmt::format("pass '{}' uses '{}', which it has not declared", name, node.name));
    if (known->version != handle.version_) {
        throw FrameGraphError(fmt::format("pass '{}' uses version {} of '{}', but has declared version {}", name,
                                          handle.version_, node.name, known->version));
    }
    return node;
}

} // namespace hachure::gpu::detail
