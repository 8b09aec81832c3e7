#pragma once

#include <hachure/runtime/gpu/handle.h>
#include <hachure/runtime/gpu/shader_source.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

namespace hachure::gpu {

/// One stage of a program.
struct ShaderStage {
    GLenum stage = GL_VERTEX_SHADER;
    ShaderSource source;
};

/// A linked program (glCreateProgram, glCompileShader, glLinkProgram) and its uniforms.
///
/// set() keeps a value until the next set() or until the program is reloaded; a name that the shader does not have, or
/// that the compiler removed because nothing reads it, is ignored. A value of another type than the shader's is a GL
/// error.
class Program {
public:
    Program() = default;
    /// Throws Error when a stage does not compile ("gooch/gooch.frag:12: error: ...", the messages joined by "; ") or
    /// the program does not link.
    Program(std::span<const ShaderStage> stages, std::string_view label);

    /// glUseProgram.
    void use() const;

    /// glProgramUniform. Spans fill arrays from element 0 on.
    void set(std::string_view name, float value);
    void set(std::string_view name, int value); ///< also a sampler's or image's unit
    void set(std::string_view name, std::uint32_t value);
    void set(std::string_view name, bool value);
    void set(std::string_view name, const glm::vec2& value);
    void set(std::string_view name, const glm::vec3& value);
    void set(std::string_view name, const glm::vec4& value);
    void set(std::string_view name, const glm::ivec2& value);
    void set(std::string_view name, const glm::ivec3& value);
    void set(std::string_view name, const glm::ivec4& value);
    void set(std::string_view name, const glm::uvec2& value);
    void set(std::string_view name, const glm::uvec3& value);
    void set(std::string_view name, const glm::uvec4& value);
    void set(std::string_view name, const glm::mat3& value);
    void set(std::string_view name, const glm::mat4& value);
    void set(std::string_view name, std::span<const float> values);
    void set(std::string_view name, std::span<const int> values);
    void set(std::string_view name, std::span<const glm::vec2> values);
    void set(std::string_view name, std::span<const glm::vec3> values);
    void set(std::string_view name, std::span<const glm::vec4> values);
    void set(std::string_view name, std::span<const glm::mat4> values);

    /// Whether the linked program has the uniform.
    [[nodiscard]] bool has_uniform(std::string_view name);

    [[nodiscard]] GLuint name() const { return handle_.get(); }
    [[nodiscard]] explicit operator bool() const { return name() != 0; }

private:
    struct NameHash {
        using is_transparent = void;
        std::size_t operator()(std::string_view name) const { return std::hash<std::string_view>()(name); }
    };

    [[nodiscard]] GLint location(std::string_view name);
    static void destroy(GLuint name);

    detail::Handle<&Program::destroy> handle_;
    /// Locations asked for so far; -1: the program has no such uniform.
    std::unordered_map<std::string, GLint, NameHash, std::equal_to<>> locations_;
};

} // namespace hachure::gpu
