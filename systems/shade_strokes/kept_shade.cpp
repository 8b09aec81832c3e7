#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/systems/shade_strokes/component_settings.h>
#include <hachure/systems/shade_strokes/kept_shade.h>

#include <utility>

namespace hachure {
namespace {

/// Whether the CPU knows the shape that is drawn. A surface that was given strokes in this very frame may have its
/// shape on the GPU alone: until the next frame, it is shaded in its rest pose.
bool shape_is_known(const ShadeInput& input) {
    return input.item->shape.version != 0 && input.item->shape.positions.size() == input.surface->positions.size();
}

std::uint64_t shape_version(const ShadeInput& input) { return shape_is_known(input) ? input.item->shape.version : 0; }

/// What the density on a surface is painted from.
std::uint64_t density_key(const ShadeInput& input) {
    gpu::KeyHash hash;
    hash.add(input.style->density_by);
    switch (input.style->density_by) {
    case ShadeDensityBy::nothing:
        break;
    case ShadeDensityBy::paint:
        hash.add(input.style->density_channel);
        break;
    case ShadeDensityBy::texture:
        hash.add(std::string_view(input.style->density_texture));
        break;
    case ShadeDensityBy::volumes:
        hash.add(shape_version(input));
        hash.add(input.item->world_from_entity);
        for (const PlacedVolume& placed : input.volumes) {
            hash.add(placed.volume_from_world);
            hash.add(placed.volume.shape);
            for (const float value : {placed.volume.inside, placed.volume.outside, placed.volume.falloff})
                hash.add(value);
        }
    }
    return hash.value();
}

/// Whether amplitudes are to follow the curvature of the shape that is drawn, and it is there.
bool follows_curvature(const ShadeInput& input, const ShadeSettings& settings) {
    return input.asked && input.curvature && input.asked->source == CurvatureSource::recomputed &&
           settings.amplitude_by_curvature > 0.0f && shape_is_known(input) &&
           input.curvature->version == input.item->shape.version &&
           input.curvature->curvatures.size() == input.surface->positions.size();
}

/// What a narrowing is found from; never 0.
std::uint64_t narrowing_key(const ShadeInput& input, const ShadeSettings& settings) {
    gpu::KeyHash hash;
    hash.add(input.curvature->version);
    hash.add(input.asked->method);
    for (const float value :
         {settings.amplitude, settings.amplitude_by_curvature, settings.min_amplitude, settings.max_amplitude})
        hash.add(value);
    return hash.value() | 1u;
}

} // namespace

void KeptShade::step(const ShadeInput& input) {
    const bool other_mesh = mesh_ != input.mesh;
    if (other_mesh) {
        mesh_ = input.mesh;
        needed_.assign(mesh_->mesh.cell_count(), 0.0f);
        density_key_ = 0;
        narrowing_key_ = 0;
        narrowing_.rest_of = nullptr;
        update_.narrowing = {};
        ++narrowing_version_;
    }
    take_shape(input);
    take_density(input);
    light_.mesh = &mesh_->mesh;
    light_.version = gpu::key_of(shape_version(input), density_key_);
    light_.world_from_mesh = input.item->world_from_entity;
    light_.lights = input.lights;
    light_.eye = input.eye;
    light_.tone = shade_tone(*input.style, input.strongest);
    light_.needed = needed_;
    light_.validate();
    light_.run();
    needed_version_ += light_.swept ? 1 : 0;
    const ShadeSettings settings = shade_settings(*input.style);
    take_curvature(input, settings);
    update_strokes(settings);
}

void KeptShade::update_strokes(const ShadeSettings& settings) {
    const bool anew = update_.last_mesh != &mesh_->mesh || !(update_.last_settings == settings);
    update_.mesh = &mesh_->mesh;
    update_.settings = settings;
    update_.needed = needed_;
    update_.changed = light_.swept;
    update_.chains = &chains_;
    update_.validate();
    update_.run();
    version_ += anew || update_.narrowed || update_.stats.touched > 0 ? 1 : 0;
}

void KeptShade::take_shape(const ShadeInput& input) {
    const bool known = shape_is_known(input);
    light_.positions = known ? input.item->shape.positions : std::span<const glm::vec3>(input.surface->positions);
    light_.normals = known ? input.item->shape.normals : std::span<const glm::vec3>(input.surface->normals);
    if (light_.normals.size() != light_.positions.size()) light_.normals = {};
    light_.indices = input.surface->indices;
}

void KeptShade::take_density(const ShadeInput& input) {
    const std::uint64_t key = density_key(input);
    if (density_key_ != key) paint(input);
    density_key_ = key;
    light_.paint = density_;
}

void KeptShade::take_curvature(const ShadeInput& input, const ShadeSettings& settings) {
    const bool follows = follows_curvature(input, settings);
    const std::uint64_t key = follows ? narrowing_key(input, settings) : 0;
    update_.narrowed = key != narrowing_key_;
    if (!update_.narrowed) return;
    narrowing_key_ = key;
    ++narrowing_version_;
    update_.narrowing = {};
    if (!follows) return;
    narrowing_.positions = input.surface->positions;
    narrowing_.indices = input.surface->indices;
    narrowing_.curvatures = input.curvature->curvatures;
    narrowing_.method = input.asked->method;
    narrowing_.settings = settings;
    narrowing_.size = double{mesh_->mesh.size};
    narrowing_.validate();
    narrowing_.run();
    update_.narrowing = {narrowing_.shares, input.surface->indices};
}

void KeptShade::paint(const ShadeInput& input) {
    const ShadeMesh& mesh = mesh_->mesh;
    switch (input.style->density_by) {
    case ShadeDensityBy::nothing:
        density_.clear();
        break;
    case ShadeDensityBy::paint:
        density_by_paint(mesh, *input.surface, input.style->density_channel, density_);
        break;
    case ShadeDensityBy::texture:
        if (input.picture)
            density_by_picture(mesh, *input.surface, *input.picture, density_);
        else
            density_.clear();
        break;
    case ShadeDensityBy::volumes:
        density_by_volumes(mesh, light_.positions, light_.indices, input.item->world_from_entity, input.volumes,
                           density_);
    }
}

std::uint64_t KeptShade::triangles_touched() const {
    std::uint64_t sum = 0;
    for (const std::uint32_t cell : update_.touched()) sum += mesh_->triangles[cell];
    return sum;
}

} // namespace hachure
