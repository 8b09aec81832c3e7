#include <hachure/runtime/gpu/frame_graph_plan.h>

#include <fmt/format.h>

namespace hachure::gpu::detail {
namespace {

std::uint32_t index32(std::size_t index) { return static_cast<std::uint32_t>(index); }

/// The version that a pass needs to be there before it: what it reads, or writes onto.
std::uint32_t needed_version(const TextureUse& use) { return use.writes() ? use.version - 1 : use.version; }

/// A pass is needed when it has a side effect, makes a required version, or makes what a needed pass needs. Passes only
/// use what was declared before them, so one sweep from the end finds them all.
void cull(FrameDeclaration& frame) {
    const auto need = [&](const TextureNode& texture, std::uint32_t version) {
        if (version > 0) frame.passes[texture.writers[version - 1]].state = PassState::reused;
    };
    for (PassNode& pass : frame.passes) pass.state = pass.side_effect ? PassState::reused : PassState::culled;
    for (const TextureNode& texture : frame.textures) {
        if (texture.required) need(texture, *texture.required);
    }
    for (std::size_t i = frame.passes.size(); i-- > 0;) {
        if (frame.passes[i].state == PassState::culled) continue;
        for (const TextureUse& use : frame.passes[i].uses) need(frame.textures[use.texture], needed_version(use));
    }
}

void find_lifetimes(FrameDeclaration& frame) {
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        if (frame.passes[i].state == PassState::culled) continue;
        for (const TextureUse& use : frame.passes[i].uses) {
            TextureNode& texture = frame.textures[use.texture];
            texture.last_use = index32(i);
            if (use.writes()) texture.last_version = use.version;
        }
    }
}

void check_required(const FrameDeclaration& frame) {
    for (const TextureNode& texture : frame.textures) {
        if (!texture.required || texture.last_version == *texture.required) continue;
        const PassNode& writer = frame.passes[texture.writers[*texture.required]];
        throw FrameGraphError(fmt::format("the frame requires version {} of '{}', which pass '{}' writes over",
                                          *texture.required, texture.name, writer.name));
    }
}

/// What the contents of a version depend on: the signature of the pass that made it, and which of its textures it is.
/// Empty when that pass is not one whose results are kept.
std::optional<std::uint64_t> version_signature(const FrameDeclaration& frame, const TextureNode& texture,
                                               std::uint32_t version) {
    if (version == 0) {
        const auto& contents = texture.import->options.contents;
        return key_of(contents.has_value(), contents.value_or(0));
    }
    const auto& pass = frame.passes[texture.writers[version - 1]].signature;
    return pass ? std::optional(key_of(*pass, texture.key)) : std::nullopt;
}

std::optional<std::uint64_t> pass_signature(const FrameDeclaration& frame, const PassNode& pass) {
    if (!pass.has_keys) return std::nullopt;
    KeyHash hash;
    hash.add(pass.key);
    hash.add(pass.keys.value());
    for (const TextureUse& use : pass.uses) {
        const TextureNode& texture = frame.textures[use.texture];
        const TextureDesc& desc = texture.desc;
        hash.add(use.access);
        hash.add(texture.key);
        for (const int number : {desc.width, desc.height, desc.levels, desc.samples}) hash.add(number);
        hash.add(desc.format);
        if (use.access == Access::create) continue;
        const auto input = version_signature(frame, texture, needed_version(use));
        if (!input) return std::nullopt;
        hash.add(*input);
    }
    return hash.value();
}

/// An imported texture whose owner restores its contents does not keep what passes write, by definition.
bool stays(const TextureNode& texture) {
    return texture.owned() || (texture.import->options.retained && !texture.import->options.contents);
}

void sign(FrameDeclaration& frame) {
    for (PassNode& pass : frame.passes) {
        if (pass.state != PassState::culled) pass.signature = pass_signature(frame, pass);
    }
    for (TextureNode& texture : frame.textures) {
        if (!texture.survives()) continue;
        // The last version's signature covers the whole chain of writers, so it exists only if each of theirs does.
        texture.signature = version_signature(frame, texture, texture.last_version);
        texture.kept = texture.signature && stays(texture);
    }
}

/// Finds the passes that must run, from those that certainly must to all that follow from them:
/// - Running one writer of a texture spoils what is in it, so all its surviving writers run.
/// - A running pass that reads a version which is not in the texture at the frame's end needs it to be made again.
class RunClosure {
public:
    RunClosure(FrameDeclaration& frame, const KeptResults& kept) : frame_(frame), kept_(kept) {}

    void find() {
        for (std::size_t i = 0; i < frame_.passes.size(); ++i) {
            const PassNode& pass = frame_.passes[i];
            if (!pass.signature || (pass.side_effect && !kept_.effect_done(pass))) run_pass(index32(i));
        }
        for (TextureNode& texture : frame_.textures) {
            if (texture.survives() && !(texture.kept && kept_.holds(texture))) run_writers(texture);
        }
        while (!todo_.empty()) {
            const PassNode& pass = frame_.passes[todo_.back()];
            todo_.pop_back();
            for (const TextureUse& use : pass.uses) {
                TextureNode& texture = frame_.textures[use.texture];
                if (use.writes() || use.version != texture.last_version) run_writers(texture);
            }
        }
    }

private:
    void run_pass(std::uint32_t index) {
        PassNode& pass = frame_.passes[index];
        if (pass.state != PassState::reused) return; // culled, or known to run
        pass.state = PassState::run;
        todo_.push_back(index);
    }

    void run_writers(TextureNode& texture) {
        if (texture.runs) return;
        texture.runs = true;
        for (std::uint32_t version = 1; version <= texture.last_version; ++version) {
            run_pass(texture.writers[version - 1]);
        }
    }

    FrameDeclaration& frame_;
    const KeptResults& kept_;
    std::vector<std::uint32_t> todo_;
};

} // namespace

void plan_frame(FrameDeclaration& frame, const KeptResults& kept) {
    cull(frame);
    find_lifetimes(frame);
    check_required(frame);
    sign(frame);
    RunClosure(frame, kept).find();
}

} // namespace hachure::gpu::detail
