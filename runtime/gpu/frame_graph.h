#pragma once

#include <hachure/runtime/gpu/frame_graph_backend.h>
#include <hachure/runtime/gpu/frame_graph_error.h>
#include <hachure/runtime/gpu/frame_graph_handle.h>
#include <hachure/runtime/gpu/frame_graph_pass.h>
#include <hachure/runtime/gpu/frame_graph_stats.h>

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace hachure::gpu {

/// What the owner of an imported texture promises.
struct ImportOptions {
    /// Key of what the texture holds when the frame begins, so that passes can read it; the owner restores it whenever
    /// a pass may have written the texture. Empty: undefined, to be written before it is read.
    std::optional<std::uint64_t> contents;

    /// Whether what passes wrote is still there in the next frame, so that they need not run again. Not so for a
    /// window's back buffer.
    bool retained = true;
};

/// The passes of one view. They are declared anew in every frame; the graph then drops those that nobody needs, keeps
/// the results of those whose inputs did not change, and executes the others in the order of their declaration:
///
///     graph.begin_frame();
///     const auto& gooch = graph.add_pass<GoochData>("gooch",
///         [&](PassBuilder& pass, GoochData& data) {
///             data.color = pass.create("color", {.width = w, .height = h, .format = Format::rgba16f});
///             pass.depends_on(camera_tick, material_tick);
///         },
///         [=](const GoochData& data, PassContext& context) { draw_into(context.texture(data.color)); });
///     graph.require(gooch.color);
///     graph.run();
///
/// A pass is kept when it called depends_on() and so did every pass it gets its textures from. All the passes that
/// write onto one texture run, or none does: running one overwrites the results of the others. Textures of kept passes
/// stay; the others share memory when their lifetimes do not meet. The graph gives a kept texture back to its pool when
/// no frame has used it for `idle_frames` frames, and the pool destroys what has been idle that long.
///
/// Nothing but execute(), finish() and the destructor calls the back end. Not thread-safe.
class FrameGraph {
public:
    static constexpr std::uint32_t idle_frames = 3;

    /// `backend` outlives the graph; the graph's textures are made and destroyed through it.
    explicit FrameGraph(FrameGraphBackend& backend);
    ~FrameGraph();
    FrameGraph(FrameGraph&&) noexcept;
    FrameGraph& operator=(FrameGraph&&) noexcept;

    /// Starts a frame: passes, handles and published names of the previous one are gone, kept results stay. Also ends a
    /// frame that was left half declared.
    void begin_frame();

    /// Declares a pass. `setup(PassBuilder&, Data&)` is called at once, `execute(const Data&, PassContext&)` when the
    /// pass runs; it must not hold references that are gone by then. The name is unique in the frame. Returns the data,
    /// which lives until the next begin_frame().
    template <std::default_initializable Data, std::invocable<PassBuilder&, Data&> Setup,
              std::invocable<const Data&, PassContext&> Execute>
    const Data& add_pass(std::string_view name, Setup&& setup, Execute&& execute) {
        using Body = detail::TypedPassBody<Data, std::decay_t<Execute>>;
        auto body = std::make_unique<Body>(std::forward<Execute>(execute));
        Data& data = body->data;
        PassBuilder builder = open_pass(name);
        std::forward<Setup>(setup)(builder, data);
        close_pass(std::move(body));
        return data;
    }

    /// A texture that someone else owns, for passes to read or write; version 0. Passes that write it are needed only
    /// when it is required or read. One id is imported once per frame.
    TextureHandle import_texture(std::string_view name, const TextureDesc& desc, std::uint32_t id,
                                 ImportOptions options = {});

    /// Gives a texture a name that other capabilities can find; again with a newer version, replaces the older.
    void publish(std::string_view name, TextureHandle handle);

    /// What was published in this frame under the name, or an empty handle.
    [[nodiscard]] TextureHandle find(std::string_view name) const;

    /// Someone outside wants these contents after the frame: a window, a file. They must be what the texture holds at
    /// the frame's end.
    void require(TextureHandle handle);

    /// The shape of a texture of this frame.
    [[nodiscard]] const TextureDesc& desc(TextureHandle handle) const;

    /// Decides what is culled, reused and run.
    void compile();

    /// Executes what compile() decided. When the back end or a pass throws, the exception passes through, what had not
    /// finished counts as changed, and the next frame can begin.
    void execute();

    /// compile() and execute().
    void run() {
        compile();
        execute();
    }

    /// Waits for the GPU, so that stats() has the GPU times of the frame that was executed last.
    void finish();

    /// The back end's id of a texture that was required, read from execute() until the next one.
    [[nodiscard]] std::uint32_t texture(TextureHandle handle) const;

    /// Lets no result of earlier frames stand (a shader was edited): every needed pass runs in the next frame.
    void forget_results();

    /// One entry per pass in the order of declaration, filled by compile() and execute(); valid until begin_frame().
    [[nodiscard]] std::span<const PassStats> stats() const;

    /// Texture memory after the latest execute().
    [[nodiscard]] FrameGraphMemory memory() const;

    /// The graph as text, after compile(): a line per pass with its state, and below it what it uses, as name.version.
    [[nodiscard]] std::string describe() const;

    /// The graph in Graphviz's language: boxes are passes, ellipses are versions of textures.
    [[nodiscard]] std::string describe_dot() const;

private:
    struct State;

    PassBuilder open_pass(std::string_view name);
    void close_pass(std::unique_ptr<detail::PassBody> body);
    std::unique_ptr<State> state_;
};

} // namespace hachure::gpu
