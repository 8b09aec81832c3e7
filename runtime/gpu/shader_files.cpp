#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/embedded_shaders.h>
#include <hachure/runtime/gpu/shader_source.h>

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <system_error>
#include <utility>

namespace hachure::gpu {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t max_shader_bytes = std::uintmax_t{1} << 20;

std::string read_text(const fs::path& path) {
    std::error_code failed;
    const std::uintmax_t bytes = fs::file_size(path, failed);
    if (failed) throw Error(path.string(), failed.message());
    if (bytes > max_shader_bytes) throw Error(path.string(), "a shader file is larger than 1 MiB");
    std::string text(static_cast<std::size_t>(bytes), '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(text.data(), static_cast<std::streamsize>(bytes));
    // An editor may have shortened it meanwhile: what could be read counts.
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (file.bad() || (bytes > 0 && text.empty())) throw Error(path.string(), "the file cannot be read");
    return text;
}

} // namespace

ShaderFiles::ShaderFiles(fs::path directory) : directory_(std::move(directory)) {
    std::error_code failed;
    if (!directory_.empty() && !fs::is_directory(directory_, failed)) {
        throw Error(directory_.string(), "there is no such shader directory");
    }
}

ShaderFiles ShaderFiles::from_environment() {
    const char* directory = std::getenv("HACHURE_SHADERS");
    return ShaderFiles(directory != nullptr ? fs::path(directory) : fs::path());
}

std::optional<std::string> ShaderFiles::read(const std::string& name) const {
    std::error_code failed;
    if (!directory_.empty() && fs::is_regular_file(directory_ / name, failed)) return read_text(directory_ / name);
    for (const EmbeddedShader& shader : embedded_shaders()) {
        if (name == shader.name) return shader.text;
    }
    return std::nullopt;
}

ShaderFiles::Stamp ShaderFiles::stamp(const std::string& name) const {
    if (directory_.empty()) return {};
    std::error_code failed;
    const fs::path path = directory_ / name;
    const auto modified = fs::last_write_time(path, failed);
    if (failed) return {};
    const std::uintmax_t bytes = fs::file_size(path, failed);
    if (failed) return {};
    return {true, static_cast<std::int64_t>(modified.time_since_epoch().count()), bytes};
}

} // namespace hachure::gpu
