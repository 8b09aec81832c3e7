#include <hachure/runtime/assert.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/debug_messages.h>
#include <hachure/runtime/gpu/program.h>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <vector>

namespace hachure::gpu {
namespace {

/// A shader object, needed until its program is linked.
class Shader {
public:
    explicit Shader(const ShaderStage& stage) : name_(gl().CreateShader(stage.stage)) {
        const char* text = stage.source.text.c_str();
        const auto length = static_cast<GLint>(stage.source.text.size());
        gl().ShaderSource(name_, 1, &text, &length);
        gl().CompileShader(name_);
    }
    ~Shader() { gl().DeleteShader(name_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    [[nodiscard]] GLuint name() const { return name_; }

private:
    GLuint name_;
};

using GetParameter = PFNGLGETSHADERIVPROC;
using GetLog = PFNGLGETSHADERINFOLOGPROC;

std::string read_log(GLuint object, GetParameter get_parameter, GetLog get_log) {
    GLint length = 0;
    get_parameter(object, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0;
    get_log(object, static_cast<GLsizei>(log.size()), &written, log.data());
    log.resize(static_cast<std::size_t>(std::max(written, 0)));
    return log;
}

/// An Error is one line: the messages of a log, parted by "; ".
std::string one_line(std::string_view log) {
    std::string line;
    for (const char c : log) {
        if (c == '\n') {
            line += "; ";
        } else {
            line += c;
        }
    }
    return line;
}

void check_compiled(const Shader& shader, const ShaderSource& source) {
    GLint compiled = GL_FALSE;
    gl().GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled != GL_FALSE) return;
    const std::string log = read_log(shader.name(), gl().GetShaderiv, gl().GetShaderInfoLog);
    const std::string readable = readable_shader_log(log, source);
    if (readable.empty()) throw Error(source.files.empty() ? "shader" : source.files.front(), "it does not compile");
    throw Error(one_line(readable));
}

} // namespace

Program::Program(std::span<const ShaderStage> stages, std::string_view label) {
    handle_ = detail::Handle<&Program::destroy>(gl().CreateProgram());
    label_object(GL_PROGRAM, name(), label);
    for (const ShaderStage& stage : stages) {
        const Shader shader(stage);
        check_compiled(shader, stage.source);
        // Deleting an attached shader only marks it; it goes with the program.
        gl().AttachShader(name(), shader.name());
    }
    gl().LinkProgram(name());
    GLint linked = GL_FALSE;
    gl().GetProgramiv(name(), GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE) {
        const std::string log = read_log(name(), gl().GetProgramiv, gl().GetProgramInfoLog);
        throw Error(label, fmt::format("the program does not link: {}", one_line(readable_shader_log(log, {}))));
    }
}

void Program::destroy(GLuint name) { gl().DeleteProgram(name); }

void Program::use() const { gl().UseProgram(name()); }

GLint Program::location(std::string_view name) {
    HACHURE_ASSERT(handle_.get() != 0, "a uniform of a program that was not made");
    if (const auto found = locations_.find(name); found != locations_.end()) return found->second;
    const std::string key(name);
    const GLint location = gl().GetUniformLocation(handle_.get(), key.c_str());
    locations_.emplace(key, location);
    return location;
}

bool Program::has_uniform(std::string_view name) { return location(name) >= 0; }

// OpenGL ignores location -1, which is what a uniform that the program lacks has.

void Program::set(std::string_view uniform, float value) { gl().ProgramUniform1f(name(), location(uniform), value); }

void Program::set(std::string_view uniform, int value) { gl().ProgramUniform1i(name(), location(uniform), value); }

void Program::set(std::string_view uniform, std::uint32_t value) {
    gl().ProgramUniform1ui(name(), location(uniform), value);
}

void Program::set(std::string_view uniform, bool value) { set(uniform, value ? 1 : 0); }

void Program::set(std::string_view uniform, const glm::vec2& value) { set(uniform, std::span(&value, 1)); }

void Program::set(std::string_view uniform, const glm::vec3& value) { set(uniform, std::span(&value, 1)); }

void Program::set(std::string_view uniform, const glm::vec4& value) { set(uniform, std::span(&value, 1)); }

void Program::set(std::string_view uniform, const glm::ivec2& value) {
    gl().ProgramUniform2iv(name(), location(uniform), 1, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, const glm::ivec3& value) {
    gl().ProgramUniform3iv(name(), location(uniform), 1, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, const glm::ivec4& value) {
    gl().ProgramUniform4iv(name(), location(uniform), 1, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, const glm::uvec2& value) {
    gl().ProgramUniform2uiv(name(), location(uniform), 1, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, const glm::uvec3& value) {
    gl().ProgramUniform3uiv(name(), location(uniform), 1, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, const glm::uvec4& value) {
    gl().ProgramUniform4uiv(name(), location(uniform), 1, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, const glm::mat3& value) {
    gl().ProgramUniformMatrix3fv(name(), location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, const glm::mat4& value) { set(uniform, std::span(&value, 1)); }

void Program::set(std::string_view uniform, std::span<const float> values) {
    gl().ProgramUniform1fv(name(), location(uniform), static_cast<GLsizei>(values.size()), values.data());
}

void Program::set(std::string_view uniform, std::span<const int> values) {
    gl().ProgramUniform1iv(name(), location(uniform), static_cast<GLsizei>(values.size()), values.data());
}

// GLM's vectors and matrices are their components without padding, so an array of them is an array of floats.

void Program::set(std::string_view uniform, std::span<const glm::vec2> values) {
    gl().ProgramUniform2fv(name(), location(uniform), static_cast<GLsizei>(values.size()),
                           reinterpret_cast<const float*>(values.data()));
}

void Program::set(std::string_view uniform, std::span<const glm::vec3> values) {
    gl().ProgramUniform3fv(name(), location(uniform), static_cast<GLsizei>(values.size()),
                           reinterpret_cast<const float*>(values.data()));
}

void Program::set(std::string_view uniform, std::span<const glm::vec4> values) {
    gl().ProgramUniform4fv(name(), location(uniform), static_cast<GLsizei>(values.size()),
                           reinterpret_cast<const float*>(values.data()));
}

void Program::set(std::string_view uniform, std::span<const glm::mat4> values) {
    gl().ProgramUniformMatrix4fv(name(), location(uniform), static_cast<GLsizei>(values.size()), GL_FALSE,
                                 reinterpret_cast<const float*>(values.data()));
}

} // namespace hachure::gpu
