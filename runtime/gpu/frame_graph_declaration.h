#pragma once

#include <hachure/runtime/gpu/frame_graph.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace hachure::gpu::detail {

enum class Access : std::uint8_t { create, read, write };

/// A pass's use of a texture. `version` is the one the pass sees: for create and write, the one that it makes.
struct TextureUse {
    std::uint32_t texture = 0;
    std::uint32_t version = 0;
    Access access = Access::read;

    [[nodiscard]] bool writes() const { return access != Access::read; }
};

/// A declared pass, and below it what plan_frame() decided.
struct PassNode {
    std::string name;
    std::uint64_t key = 0; ///< hash of the name: its identity over frames
    std::unique_ptr<PassBody> body;
    std::vector<TextureUse> uses; ///< at most one per texture
    KeyHash keys;
    bool has_keys = false;
    bool side_effect = false;
    std::optional<std::uint64_t> pixels; ///< when declared

    PassState state = PassState::culled;
    std::optional<std::uint64_t> signature; ///< of all its results depend on; empty: unknown, must run
};

/// A declared texture, and below it what plan_frame() decided.
struct TextureNode {
    struct Import {
        std::uint32_t id = 0;
        ImportOptions options;
    };

    std::string name;
    std::uint64_t key = 0; ///< hash of the name: its identity over frames
    TextureDesc desc;
    std::optional<Import> import;
    std::vector<std::uint32_t> writers;    ///< [v - 1]: the pass that makes version v
    std::optional<std::uint32_t> required; ///< version that someone outside wants

    std::uint32_t last_version = 0;         ///< after culling: what it holds at the frame's end
    std::optional<std::uint64_t> signature; ///< of that version
    bool kept = false;                      ///< its contents stay for later frames
    bool runs = false;                      ///< its writers run
    std::uint32_t last_use = 0;             ///< the last surviving pass that uses it

    std::optional<std::uint32_t> id; ///< the back end's, from its first use in execute()

    [[nodiscard]] std::uint32_t newest() const { return static_cast<std::uint32_t>(writers.size()); }
    [[nodiscard]] bool survives() const { return last_version > 0; }
    [[nodiscard]] bool owned() const { return !import; }
};

/// The passes and textures of one frame as they were declared. Checks every declaration and says what is wrong by
/// throwing FrameGraphError.
class FrameDeclaration {
public:
    std::vector<PassNode> passes;
    std::vector<TextureNode> textures;

    /// Forgets all passes and textures; handles made before are refused from now on.
    void reset();

    std::uint32_t add_pass(std::string_view name);
    TextureHandle import_texture(std::string_view name, const TextureDesc& desc, std::uint32_t id,
                                 ImportOptions options);
    TextureHandle create(std::uint32_t pass, std::string_view name, const TextureDesc& desc);
    TextureHandle read(std::uint32_t pass, TextureHandle handle);
    TextureHandle write(std::uint32_t pass, TextureHandle handle);

    /// Marks what someone outside wants.
    void require(TextureHandle handle);

    /// The texture of a handle; `who` begins the error message, as in "pass 'lines' reads".
    [[nodiscard]] const TextureNode& texture(TextureHandle handle, std::string_view who) const;

    /// The texture of a handle that `pass` has declared in just this version.
    [[nodiscard]] const TextureNode& declared_texture(std::uint32_t pass, TextureHandle handle) const;

private:
    [[nodiscard]] bool is_current(TextureHandle handle) const { return handle && handle.stamp_ == stamp_; }
    [[noreturn]] static void refuse(TextureHandle handle, std::string_view who);

    std::uint32_t add_texture(std::string_view name, const TextureDesc& desc, const std::string& who);
    [[nodiscard]] TextureHandle use(std::uint32_t pass, std::uint32_t texture, Access access, std::uint32_t version);
    [[nodiscard]] std::uint32_t newest_texture(std::uint32_t pass, TextureHandle handle, std::string_view verb) const;
    [[nodiscard]] const TextureUse* find_use(std::uint32_t pass, std::uint32_t texture) const;
    [[nodiscard]] std::string maker(const TextureNode& texture) const;

    std::unordered_set<std::uint64_t> pass_names_; // by key
    std::unordered_map<std::uint64_t, std::uint32_t> texture_names_;
    std::unordered_map<std::uint32_t, std::uint32_t> imported_ids_;
    std::uint32_t stamp_ = 0;
};

} // namespace hachure::gpu::detail
