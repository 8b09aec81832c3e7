// A hundred characters in one picture, each with a clip and a time of its own: what animation, transforms and
// deformation take of a frame, beside the whole frame, and what that is with deformation on the GPU. The model is
// Khronos' Fox where HACHURE_MODELS has it, else a file that is given, else an arm of as many joints and vertices.

#include <hachure/components/animation.h>
#include <hachure/components/deform.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/light/light.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/tests/benchmarks/bench_report.h>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace hachure;

constexpr double limit_ms = 8.0;

/// An arm of `joints` joints in a row, with a clip that moves all of them.
assets::Model long_arm(int joints, int rings, int sides) {
    assets::Model model;
    assets::Primitive tube;
    assets::Skin skin;
    assets::Animation swing{.name = "swing", .channels = {}, .duration = 1.0f};
    const float length = 2.0f, bone = length / static_cast<float>(joints);
    for (int ring = 0; ring <= rings; ++ring)
        for (int side = 0; side < sides; ++side) {
            const float height = length * static_cast<float>(ring) / static_cast<float>(rings);
            const float angle = 6.2831853f * static_cast<float>(side) / static_cast<float>(sides);
            const glm::vec3 out(std::cos(angle), 0.0f, std::sin(angle));
            tube.positions.push_back(0.2f * out + glm::vec3(0.0f, height, 0.0f));
            tube.normals.push_back(out);
            const float at = std::min(height / bone, static_cast<float>(joints) - 1.001f);
            const int below = static_cast<int>(at);
            const float above = at - static_cast<float>(below);
            tube.joints[0].emplace_back(below, std::min(below + 1, joints - 1), 0, 0);
            tube.weights[0].emplace_back(1.0f - above, above, 0.0f, 0.0f);
        }
    const auto count = static_cast<std::uint32_t>(sides);
    for (std::uint32_t ring = 0; ring < static_cast<std::uint32_t>(rings); ++ring)
        for (std::uint32_t side = 0; side < count; ++side) {
            const std::uint32_t a = ring * count + side, b = ring * count + (side + 1) % count;
            tube.indices.insert(tube.indices.end(), {a, a + count, b, b, a + count, b + count});
        }
    model.nodes.resize(static_cast<std::size_t>(joints) + 1);
    model.nodes[0] = {.name = "arm", .mesh = 0, .skin = 0};
    for (int joint = 0; joint < joints; ++joint) {
        assets::Node& node = model.nodes[static_cast<std::size_t>(joint) + 1];
        node = {.name = fmt::format("joint {}", joint), .parent = joint == 0 ? -1 : joint};
        node.translation.y = joint == 0 ? 0.0f : bone;
        if (joint + 1 < joints) node.children = {joint + 2};
        skin.joints.push_back(joint + 1);
        skin.inverse_bind.push_back(glm::translate(glm::mat4(1.0f), {0.0f, -bone * static_cast<float>(joint), 0.0f}));
        assets::AnimationChannel channel{.node = joint + 1, .path = assets::AnimationPath::rotation, .components = 4};
        for (int key = 0; key <= 30; ++key) {
            const glm::quat turn =
                glm::angleAxis(0.1f * std::sin(0.2094395f * static_cast<float>(key)), glm::vec3(0, 0, 1));
            channel.times.push_back(static_cast<float>(key) / 30.0f);
            channel.values.insert(channel.values.end(), {turn.x, turn.y, turn.z, turn.w});
        }
        swing.channels.push_back(channel);
    }
    model.meshes.push_back({"arm", {tube}, {}});
    model.skins.push_back(skin);
    model.animations.push_back(swing);
    model.scenes.push_back({"scene", {0, 1}});
    return model;
}

std::filesystem::path model_file(const bench::Arguments& arguments) {
    if (!arguments.model.empty()) return arguments.model;
    const char* folder = std::getenv("HACHURE_MODELS");
    const std::filesystem::path fox = folder ? std::filesystem::path(folder) / "characters/khronos/Fox.glb" : "";
    return folder && std::filesystem::exists(fox) ? fox : "";
}

/// Copies of a model on a square.
class Crowd {
public:
    Crowd(gpu::Context& context, const assets::Model& model, int count, Canvas canvas) : renderer_(app_, context) {
        register_capabilities(app_);
        World& world = app_.world();
        world.set_resource(canvas);
        const SpawnedModel first = spawn_model(world, model);
        const float size = glm::length(geometry::bounds_of(first.points).extent());
        const int side = static_cast<int>(std::ceil(std::sqrt(count)));
        std::vector<glm::vec3> points;
        for (int i = 0; i < count; ++i) {
            const Entity root = i == 0 ? first.root : world.instantiate(first.root);
            const glm::vec3 place(0.8f * size * static_cast<float>(i % side), 0.0f,
                                  0.8f * size * static_cast<float>(i / side));
            world.get_mutable<Transform>(root).translation = place;
            world.add(root, Animation{.clip = first.clips[static_cast<std::size_t>(i) % first.clips.size()],
                                      .offset = 0.037f * static_cast<float>(i)});
            for (const glm::vec3& point : first.points) points.push_back(point + place);
            roots_.push_back(root);
        }
        spawn_framing_camera(world, points, canvas);
        spawn_default_light(world);
    }

    void frame() {
        renderer_.render_frame(1.0 / 60.0);
        renderer_.finish();
    }
    void pause() {
        for (const Entity root : roots_) app_.world().get_mutable<Animation>(root).playing = false;
    }

    void deform_on(DeformDevice device) {
        for (auto [entity, deform] : app_.world().query<Deform>()) deform.device = device;
    }

    /// Of the last frame.
    double system_ms(std::string_view name) {
        for (const SystemTime& time : app_.schedule().times())
            if (time.name == name) return time.ms;
        return 0.0;
    }
    std::uint64_t vertices() const { return app_.world().resource<DeformCounts>().vertices; }
    std::uint64_t surfaces_on_gpu() const { return app_.world().resource<DeformCounts>().on_gpu; }
    std::uint64_t clips() const { return app_.world().resource<AnimationCounts>().clips; }

private:
    App app_;
    Renderer renderer_;
    std::vector<Entity> roots_;
};

struct Times {
    std::vector<double> animation, transform, deform, sum, frame;
};

Times measure(Crowd& crowd, int frames) {
    Times times;
    for (int i = 0; i < frames; ++i) {
        const double start = bench::now_ms();
        crowd.frame();
        times.frame.push_back(bench::now_ms() - start);
        times.animation.push_back(crowd.system_ms("animation"));
        times.transform.push_back(crowd.system_ms("transform"));
        times.deform.push_back(crowd.system_ms("deform"));
        times.sum.push_back(times.animation.back() + times.transform.back() + times.deform.back());
    }
    return times;
}

/// Whole frames with deformation on either device, in turns, so that whatever else the machine does meets both.
struct Devices {
    std::vector<double> cpu, gpu, deform_of_gpu;
    std::uint64_t surfaces_on_gpu = 0;
};

Devices compare_devices(Crowd& crowd, int rounds, int frames) {
    Devices devices;
    const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    for (int round = 0; round < rounds; ++round)
        for (const DeformDevice device : {DeformDevice::cpu, DeformDevice::gpu}) {
            crowd.deform_on(device);
            for (int i = 0; i < 2; ++i) crowd.frame();
            const Times times = measure(crowd, frames);
            append(device == DeformDevice::cpu ? devices.cpu : devices.gpu, times.frame);
            if (device == DeformDevice::cpu) continue;
            append(devices.deform_of_gpu, times.deform);
            devices.surfaces_on_gpu = crowd.surfaces_on_gpu();
        }
    crowd.deform_on(DeformDevice::cpu);
    for (int i = 0; i < 2; ++i) crowd.frame();
    return devices;
}

} // namespace

int main(int argc, char** argv) {
    const bench::Arguments arguments =
        bench::parse_arguments(argc, argv, "A hundred characters: animation, transforms and deformation per frame");
    const std::filesystem::path file = model_file(arguments);
    const assets::Model model = file.empty() ? long_arm(24, 71, 24) : assets::read_model(file);
    const std::string name = file.empty() ? "arm of 24 joints" : file.stem().string();
    const int count = arguments.quick ? 4 : 100;
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    Crowd crowd(*context, model, count, arguments.quick ? Canvas{160, 120} : Canvas{1024, 768});
    for (int i = 0; i < 3; ++i) crowd.frame();
    const Times times = measure(crowd, arguments.quick ? 3 : 60);
    bench::Report report(arguments);
    const std::string who = fmt::format("{} x {}: ", count, name);
    report.add(who + "vertices deformed", static_cast<double>(crowd.vertices()), "");
    report.add(who + "animation", bench::median(times.animation), "ms");
    report.add(who + "transforms", bench::median(times.transform), "ms");
    report.add(who + "deformation", bench::median(times.deform), "ms");
    report.add_limited(who + "all three", bench::median(times.sum), "ms", limit_ms);
    report.add(who + "whole frame", bench::median(times.frame), "ms");
    const Devices devices = compare_devices(crowd, arguments.quick ? 1 : 6, arguments.quick ? 2 : 10);
    report.add(who + "surfaces deformed on the GPU", static_cast<double>(devices.surfaces_on_gpu), "");
    report.add(who + "whole frame, deformed on the CPU", bench::median(devices.cpu), "ms");
    report.add(who + "whole frame, deformed on the GPU", bench::median(devices.gpu), "ms");
    report.add(who + "deformation on the GPU, what the CPU does for it", bench::median(devices.deform_of_gpu), "ms");
    crowd.pause();
    for (int i = 0; i < 2; ++i) crowd.frame();
    const Times paused = measure(crowd, arguments.quick ? 3 : 60);
    report.add(who + "paused, all three", bench::median(paused.sum), "ms");
    report.add_limited(who + "paused, clips sampled and vertices deformed",
                       static_cast<double>(crowd.clips() + crowd.vertices()), "", 0.0);
    return report.finish();
}
