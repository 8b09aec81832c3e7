#include <hachure/runtime/assert.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/shader_library.h>

#include <algorithm>
#include <utility>

namespace hachure::gpu {

/// A program and what it was made of.
struct ShaderLibrary::Entry {
    ProgramSource source;
    Program program;
    std::vector<Watched> watched; ///< every file looked for, as it was
    std::string error;            ///< of the last reload; empty: the program is up to date
};

std::string ProgramSource::key() const {
    std::string key;
    for (const std::string* name : {&vertex, &fragment, &compute}) {
        if (name->empty()) continue;
        if (!key.empty()) key += '+';
        key += *name;
    }
    if (defines.empty()) return key;
    key += " [";
    for (const ShaderDefine& define : defines) {
        if (key.back() != '[') key += ' ';
        key += define.name + '=' + define.value;
    }
    return key + ']';
}

ShaderLibrary::ShaderLibrary() : files_(ShaderFiles::from_environment()) {}

ShaderLibrary::ShaderLibrary(const std::filesystem::path& directory) : files_(directory) {}

ShaderLibrary::~ShaderLibrary() = default;

void ShaderLibrary::set_directory(const std::filesystem::path& directory) {
    files_ = ShaderFiles(directory);
    directory_changed_ = true;
}

Program& ShaderLibrary::program(const ProgramSource& source) {
    const bool draws = !source.vertex.empty() && !source.fragment.empty() && source.compute.empty();
    const bool computes = source.vertex.empty() && source.fragment.empty() && !source.compute.empty();
    HACHURE_ASSERT(draws || computes, "a program is a vertex and a fragment shader, or a compute shader");
    const std::string key = source.key();
    if (const auto found = entries_.find(key); found != entries_.end()) return found->second->program;
    auto entry = std::make_unique<Entry>();
    entry->source = source;
    entry->program = compile(source, entry->watched);
    return entries_.emplace(key, std::move(entry)).first->second->program;
}

Program ShaderLibrary::compile(const ProgramSource& source, std::vector<Watched>& watched) const {
    const std::pair<GLenum, const std::string*> wanted[] = {{GL_VERTEX_SHADER, &source.vertex},
                                                            {GL_FRAGMENT_SHADER, &source.fragment},
                                                            {GL_COMPUTE_SHADER, &source.compute}};
    std::vector<ShaderStage> stages;
    watched.clear();
    for (const auto& [stage, name] : wanted) {
        if (name->empty()) continue;
        // Stamped as they are looked for, so that files that are missing or wrong are watched as well.
        const auto watch = [&](const std::string& file) { watched.push_back({file, files_.stamp(file)}); };
        stages.push_back({stage, load_shader_source(files_, *name, source.defines, watch)});
    }
    return Program(stages, source.key());
}

bool ShaderLibrary::is_stale(const Entry& entry) const {
    return std::any_of(entry.watched.begin(), entry.watched.end(),
                       [&](const Watched& file) { return files_.stamp(file.name) != file.stamp; });
}

bool ShaderLibrary::reload_changed() {
    bool changed = false;
    for (const auto& [key, entry] : entries_) {
        if (!directory_changed_ && !is_stale(*entry)) continue;
        changed = true;
        try {
            entry->program = compile(entry->source, entry->watched);
            entry->error.clear();
            ++generation_;
        } catch (const Error& error) {
            entry->error = error.what();
        }
    }
    directory_changed_ = false;
    if (!changed) return false;
    errors_.clear();
    for (const auto& [key, entry] : entries_) {
        if (!entry->error.empty()) errors_.push_back(entry->error);
    }
    return true;
}

} // namespace hachure::gpu
