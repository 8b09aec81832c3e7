#include <hachure/runtime/gpu/frame_graph_plan.h>
#include <hachure/runtime/gpu/frame_graph_state.h>

#include <fmt/format.h>

namespace hachure::gpu {

FrameGraph::FrameGraph(FrameGraphBackend& backend) : state_(std::make_unique<State>(backend)) {}
FrameGraph::~FrameGraph() = default;
FrameGraph::FrameGraph(FrameGraph&&) noexcept = default;
FrameGraph& FrameGraph::operator=(FrameGraph&&) noexcept = default;

void FrameGraph::State::check_phase(FrameGraphPhase expected, std::string_view call) const {
    if (phase == expected) return;
    if (phase == FrameGraphPhase::setup) {
        throw FrameGraphError(fmt::format("{} during or after a failure of the setup of pass '{}'", call,
                                          frame.passes.empty() ? "" : frame.passes.back().name));
    }
    throw FrameGraphError(fmt::format("{} out of order: begin_frame(), add_pass(), compile(), execute()", call));
}

void FrameGraph::begin_frame() {
    state_->frame.reset();
    state_->published.clear();
    state_->stats.clear();
    state_->phase = FrameGraphPhase::declaring;
}

PassBuilder FrameGraph::open_pass(std::string_view name) {
    state_->check_phase(FrameGraphPhase::declaring, fmt::format("add_pass('{}')", name));
    const std::uint32_t pass = state_->frame.add_pass(name);
    state_->phase = FrameGraphPhase::setup;
    return {state_->frame, pass};
}

void FrameGraph::close_pass(std::unique_ptr<detail::PassBody> body) {
    state_->frame.passes.back().body = std::move(body);
    state_->phase = FrameGraphPhase::declaring;
}

TextureHandle FrameGraph::import_texture(std::string_view name, const TextureDesc& desc, std::uint32_t id,
                                         ImportOptions options) {
    state_->check_phase(FrameGraphPhase::declaring, "import_texture()");
    return state_->frame.import_texture(name, desc, id, options);
}

void FrameGraph::publish(std::string_view name, TextureHandle handle) {
    static_cast<void>(state_->frame.texture(handle, "the frame publishes"));
    state_->published.insert_or_assign(std::string(name), handle);
}

TextureHandle FrameGraph::find(std::string_view name) const {
    const auto found = state_->published.find(name);
    return found == state_->published.end() ? TextureHandle{} : found->second;
}

void FrameGraph::require(TextureHandle handle) {
    state_->check_phase(FrameGraphPhase::declaring, "require()");
    state_->frame.require(handle);
}

const TextureDesc& FrameGraph::desc(TextureHandle handle) const {
    return state_->frame.texture(handle, "desc() of").desc;
}

void FrameGraph::compile() {
    state_->check_phase(FrameGraphPhase::declaring, "compile()");
    state_->phase = FrameGraphPhase::idle; // should it throw
    detail::plan_frame(state_->frame, state_->kept);
    state_->declare_stats();
    state_->phase = FrameGraphPhase::compiled;
}

void FrameGraph::execute() {
    state_->check_phase(FrameGraphPhase::compiled, "execute()");
    state_->phase = FrameGraphPhase::idle; // should it throw
    state_->execute();
    state_->phase = FrameGraphPhase::executed;
}

void FrameGraph::finish() {
    state_->backend.finish();
    state_->timers.collect(state_->backend);
    state_->update_gpu_times();
}

std::uint32_t FrameGraph::texture(TextureHandle handle) const {
    state_->check_phase(FrameGraphPhase::executed, "texture()");
    const detail::TextureNode& texture = state_->frame.texture(handle, "texture() of");
    if (texture.required != handle.version()) {
        throw FrameGraphError(
            fmt::format("texture() of version {} of '{}', which is not required", handle.version(), texture.name));
    }
    return *texture.id;
}

void FrameGraph::forget_results() { state_->kept.forget(); }

std::span<const PassStats> FrameGraph::stats() const { return state_->stats; }

FrameGraphMemory FrameGraph::memory() const {
    return {.textures = state_->pool.count(),
            .physical_bytes = state_->pool.bytes(),
            .kept_bytes = state_->kept.bytes(),
            .unshared_bytes = state_->unshared_bytes};
}

} // namespace hachure::gpu
