#pragma once

#include <hachure/runtime/gpu/program.h>
#include <hachure/runtime/gpu/shader_source.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace hachure::gpu {

/// What a program is made of: files below shaders/, either vertex and fragment or compute; the others are empty. The
/// defines go into every stage.
struct ProgramSource {
    std::string vertex = {};
    std::string fragment = {};
    std::string compute = {};
    std::vector<ShaderDefine> defines = {};

    /// "common/full_screen.vert+gooch/gooch.frag [SHADOWS=1]": its label, and what it is cached under.
    [[nodiscard]] std::string key() const;
};

/// Compiles each program once and again when its files are edited. Belongs to the context that is current when it is
/// first used.
class ShaderLibrary {
public:
    /// Files of HACHURE_SHADERS if that is set, then the embedded ones.
    ShaderLibrary();
    /// Files of `directory`, then the embedded ones; empty: embedded only. Throws Error when it is no directory.
    explicit ShaderLibrary(const std::filesystem::path& directory);
    ~ShaderLibrary();
    ShaderLibrary(const ShaderLibrary&) = delete;
    ShaderLibrary& operator=(const ShaderLibrary&) = delete;

    /// As the constructor; programs that exist are reloaded by the next reload_changed().
    void set_directory(const std::filesystem::path& directory);

    /// The program, compiled at the first call. The reference stays valid as long as the library, over reloads too.
    /// Throws Error when a file is missing or does not compile; nothing is cached then.
    [[nodiscard]] Program& program(const ProgramSource& source);

    /// Looks at every file that programs were made of (time and size) and compiles those programs again whose files
    /// changed. A program whose new text is wrong stays as it was, and its message is in errors() until it is right
    /// again. Returns whether a program or errors() changed. Uniforms of a replaced program are unset.
    bool reload_changed();

    /// What is wrong with files edited since they were compiled, one message per program.
    [[nodiscard]] const std::vector<std::string>& errors() const { return errors_; }

    /// Grows whenever a program was replaced: results drawn under an earlier number are out of date.
    [[nodiscard]] std::uint64_t generation() const { return generation_; }

private:
    struct Entry;
    struct Watched {
        std::string name;
        ShaderFiles::Stamp stamp;
    };

    [[nodiscard]] Program compile(const ProgramSource& source, std::vector<Watched>& watched) const;
    [[nodiscard]] bool is_stale(const Entry& entry) const;

    ShaderFiles files_;
    std::map<std::string, std::unique_ptr<Entry>> entries_;
    std::vector<std::string> errors_;
    std::uint64_t generation_ = 0;
    bool directory_changed_ = false;
};

} // namespace hachure::gpu
