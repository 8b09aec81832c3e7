#include <hachure/runtime/assert.h>
#include <hachure/runtime/parallel.h>
#include <hachure/systems/shade_strokes/shade_light.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

constexpr std::size_t light_block = 1024; // samples or cells that a thread takes at a time

/// Calls `body(first, end)` for blocks of `count`, on several threads.
template <class Body> void each_block(std::size_t count, const Body& body) {
    parallel_for((count + light_block - 1) / light_block,
                 [&](std::size_t b) { body(b * light_block, std::min(count, (b + 1) * light_block)); });
}

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_sound(const ShadingLight& light) {
    return is_finite(glm::vec3(light.position)) && std::isfinite(light.position.w) && is_finite(light.direction) &&
           is_finite(light.color) && std::isfinite(light.range) && std::isfinite(light.inner_cone) &&
           std::isfinite(light.outer_cone);
}

/// Unit, or 0 for what has no direction.
glm::vec3 unit(const glm::vec3& v) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : glm::vec3(0.0f);
}

/// As shaders/common/lights.glsl turns it.
glm::vec3 turn_with_gaze(const glm::vec3& v, const ShadeEye& eye, const glm::vec3& world) {
    const glm::vec3 sight = eye.perspective ? unit(eye.place - world) : eye.axis;
    const glm::vec3 sum = eye.axis + sight;
    const float cosine = std::max(1.0f + glm::dot(eye.axis, sight), 1e-6f);
    return v - glm::dot(v, sum) / cosine * sum + 2.0f * glm::dot(v, eye.axis) * sight;
}

/// As `light_reach` there: 1 up to where the light ends by range or cone.
float reach(const ShadingLight& light, const glm::vec3& world) {
    if (light.position.w == 0.0f) return 1.0f;
    const glm::vec3 away = world - glm::vec3(light.position);
    float result = 1.0f;
    if (light.range > 0.0f) {
        const float square = glm::dot(away, away) / (light.range * light.range);
        result = std::clamp(1.0f - square * square, 0.0f, 1.0f);
    }
    if (light.spot) {
        const float inner = std::cos(light.inner_cone), outer = std::cos(light.outer_cone);
        float inside = glm::dot(unit(away), light.direction) - outer;
        inside = std::clamp(inside / std::max(inner - outer, 1e-6f), 0.0f, 1.0f);
        result *= inside * inside;
    }
    return result;
}

float diffuse(const ShadeLightJob& job, const glm::vec3& world, const glm::vec3& normal) {
    float sum = 0.0f;
    for (const ShadingLight& light : job.now.lights) {
        glm::vec3 towards = unit(glm::vec3(light.position) - light.position.w * world);
        if (light.gaze) towards = turn_with_gaze(towards, job.eye, world);
        const float strength = std::max({light.color.r, light.color.g, light.color.b, 0.0f});
        sum += strength * reach(light, world) * std::max(glm::dot(towards, normal), 0.0f);
    }
    return sum;
}

float need_of(const ShadeTone& tone, float light) {
    const float span = std::max(tone.no_shade - tone.full_shade, 1e-4f);
    const float dark = std::clamp((tone.no_shade - light) / span, 0.0f, 1.0f);
    return tone.contrast == 1.0f ? dark : std::pow(dark, tone.contrast);
}

/// A point of the deformed surface in the world.
ShadeLightJob::Sample sample_at(const ShadeLightJob& job, const SurfacePoint& point, const glm::mat3& normal_matrix) {
    const std::uint32_t* corner = &job.indices[3 * std::size_t{point.triangle}];
    const glm::vec3 &a = job.positions[corner[0]], &b = job.positions[corner[1]], &c = job.positions[corner[2]];
    const float w = 1.0f - point.u - point.v;
    const glm::vec3 place = w * a + point.u * b + point.v * c;
    const glm::vec3 normal = job.normals.empty() ? glm::cross(b - a, c - a)
                                                 : w * job.normals[corner[0]] + point.u * job.normals[corner[1]] +
                                                       point.v * job.normals[corner[2]];
    return {glm::vec3(job.world_from_mesh * glm::vec4(place, 1.0f)), unit(normal_matrix * unit(normal))};
}

void gather_samples(ShadeLightJob& job) {
    const std::vector<ShadeSample>& points = job.mesh->samples;
    const glm::mat3 normal_matrix = glm::transpose(glm::inverse(glm::mat3(job.world_from_mesh)));
    job.samples.resize(points.size());
    each_block(points.size(), [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) job.samples[i] = sample_at(job, points[i].point, normal_matrix);
    });
}

void sweep_cells(const ShadeLightJob& job, std::size_t first, std::size_t end) {
    const ShadeMesh& mesh = *job.mesh;
    for (std::size_t c = first; c < end; ++c) {
        float need = 0.0f;
        for (std::size_t i = mesh.first_sample[c]; i < mesh.first_sample[c + 1]; ++i) {
            const float light = diffuse(job, job.samples[i].place, job.samples[i].normal);
            need += mesh.samples[i].weight * need_of(job.tone, std::isfinite(light) ? light : 0.0f);
        }
        job.needed[c] = std::clamp(need, 0.0f, 1.0f) * (job.paint.empty() ? 1.0f : job.paint[c]);
    }
}

} // namespace

void ShadeLightJob::validate() const {
    HACHURE_ASSERT(mesh != nullptr && needed.size() == mesh->cell_count(), "a need per cell");
    HACHURE_ASSERT(paint.empty() || paint.size() == needed.size(), "paint per cell, or none");
    HACHURE_ASSERT(normals.empty() || normals.size() == positions.size(), "a normal per vertex, or none");
    HACHURE_ASSERT(indices.size() == 3 * mesh->sheets.triangle_of.size(), "the mesh's own triangles");
}

void ShadeLightJob::run() {
    now.lights.clear();
    for (const ShadingLight& light : lights)
        if (is_sound(light)) now.lights.push_back(light);
    ignored_lights = lights.size() - now.lights.size();
    const bool gaze = std::ranges::any_of(now.lights, [](const ShadingLight& light) { return light.gaze; });
    now.eye = gaze ? eye : ShadeEye{};
    now.world_from_mesh = world_from_mesh;
    now.tone = tone;
    now.mesh = mesh;
    now.version = version;
    swept = !(now == last);
    if (!swept) return;
    if (now.mesh != last.mesh || now.version != last.version || now.world_from_mesh != last.world_from_mesh)
        gather_samples(*this);
    each_block(needed.size(), [this](std::size_t first, std::size_t end) { sweep_cells(*this, first, end); });
    std::swap(now, last);
}

} // namespace hachure
