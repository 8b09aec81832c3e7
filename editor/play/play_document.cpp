#include <hachure/editor/play/make_expectation.h>
#include <hachure/editor/play/play_document.h>
#include <hachure/editor/usage_error.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>

#include <functional>

namespace hachure::play {
namespace {

constexpr std::int64_t max_side = 16384;

/// Reads a document part by part. Where faults are collected, a part that has one leaves its default behind.
class Reader {
public:
    Reader(const TypeRegistry& types, const std::filesystem::path& file, const assets::JsonText& text,
           std::vector<std::string>* faults)
        : types_(types), text_(text), object_(text, "", text.root()), faults_(faults) {
        play_.file = file;
        play_.folder = file.parent_path();
    }

    PlayDocument read() {
        part([&] { object_.integer("hachure_play", 1, 1); });
        part([&] { play_.doc = object_.text("doc", ""); });
        part([&] { play_.scene = play_.folder / object_.text("scene"); });
        part([&] { play_.style = object_.text("style", ""); });
        part([&] { play_.clip = object_.text("clip", ""); });
        part([&] { play_.sets = object_.texts("set"); });
        part([&] { check_sets(); });
        part([&] { read_fps(); });
        part([&] { read_size(); });
        part([&] { play_.seed = static_cast<std::uint64_t>(object_.integer("seed", 0, INT64_MAX, 1)); });
        part([&] { play_.frames = object_.integer("frames", 1, max_frames, 1); });
        part([&] { read_backend(); });
        part([&] { read_input(); });
        part([&] { read_expectations(); });
        part([&] { object_.finish(); });
        return std::move(play_);
    }

private:
    void part(const std::function<void()>& read) {
        if (!faults_) return read();
        try {
            read();
        } catch (const Error& error) {
            faults_->emplace_back(error.what());
        }
    }

    void check_sets() {
        for (std::size_t i = 0; i < play_.sets.size(); ++i)
            part([&] { check_assignment(types_, play_.sets[i], text_, child_pointer("/set", i)); });
    }

    void read_fps() {
        const nlohmann::json* value = object_.find("fps");
        if (!value) return;
        const std::string text = value->is_string()   ? value->get<std::string>()
                                 : value->is_number() ? value->dump()
                                                      : "";
        const auto rate = assets::parse_frame_rate(text);
        if (!rate)
            object_.fail("fps",
                         fmt::format("fps is no rate from 1 to {}: 60, 29.97, \"30000/1001\"", assets::max_frame_rate));
        play_.fps = *rate;
    }

    void read_size() {
        const nlohmann::json* value = object_.find("size");
        if (!value) return;
        const auto side = [&](std::size_t i) {
            return (*value)[i].is_number_integer() ? (*value)[i].get<std::int64_t>() : std::int64_t{0};
        };
        if (!value->is_array() || value->size() != 2 || side(0) < 1 || side(1) < 1 || side(0) > max_side ||
            side(1) > max_side)
            object_.fail("size", fmt::format("size is no [width, height] of 1 to {} pixels", max_side));
        play_.size = {static_cast<int>(side(0)), static_cast<int>(side(1))};
    }

    void read_backend() {
        const auto backend = gpu::backend_from_string(object_.text("backend", "auto"));
        if (!backend) object_.fail("backend", "backend is none of auto, egl, osmesa, glfw");
        play_.backend = *backend;
    }

    void read_input() {
        if (object_.has("input") && object_.has("recording")) object_.fail("recording", "there is input already");
        if (const nlohmann::json* events = object_.find("input")) play_.input = parse_input(text_, "/input", *events);
        if (object_.find("recording")) play_.input = read_recording(play_.folder / object_.text("recording"));
        if (!play_.input.empty() && play_.input.rbegin()->first >= play_.frames && object_.has("input"))
            object_.fail("input", fmt::format("an event comes at frame {}, but the last frame is {}",
                                              play_.input.rbegin()->first, play_.frames - 1));
    }

    void read_expectations() {
        const nlohmann::json& expect = object_.at("expect");
        if (!expect.is_array() || expect.empty())
            object_.fail("expect", "expect is no array of expectations, or empty");
        for (std::size_t i = 0; i < expect.size(); ++i)
            part([&] {
                play_.expectations.push_back(make_expectation(
                    {types_, play_.folder, play_.size, play_.frames, text_, child_pointer("/expect", i), expect[i]}));
            });
    }

    const TypeRegistry& types_;
    const assets::JsonText& text_;
    JsonObject object_;
    std::vector<std::string>* faults_;
    PlayDocument play_;
};

} // namespace

PlayDocument read_play(const TypeRegistry& types, const std::filesystem::path& file) {
    const assets::JsonText text = assets::JsonText::read(file);
    return Reader(types, file, text, nullptr).read();
}

PlayDocument parse_play(const TypeRegistry& types, const std::filesystem::path& file, std::string text) {
    const assets::JsonText json = assets::JsonText::parse(file.string(), std::move(text));
    return Reader(types, file, json, nullptr).read();
}

std::vector<std::string> play_faults(const TypeRegistry& types, const std::filesystem::path& file) {
    std::vector<std::string> faults;
    try {
        const assets::JsonText text = assets::JsonText::read(file);
        static_cast<void>(Reader(types, file, text, &faults).read());
    } catch (const Error& error) {
        faults.emplace_back(error.what());
    }
    return faults;
}

} // namespace hachure::play
