#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::gpu {

/// A `#define name value` put into a shader.
struct ShaderDefine {
    std::string name;
    std::string value = "1";

    friend bool operator==(const ShaderDefine&, const ShaderDefine&) = default;
};

/// Where shader files come from: a directory if one is set and has the file, else the files embedded in the library.
/// Names are paths below shaders/, with '/': "gooch/gooch.frag".
class ShaderFiles {
public:
    /// What tells an edited file from the one read before; `exists` is false for an embedded or absent one.
    struct Stamp {
        bool exists = false;
        std::int64_t modified = 0; ///< of the file system's clock
        std::uintmax_t bytes = 0;

        friend bool operator==(const Stamp&, const Stamp&) = default;
    };

    /// Embedded files only.
    ShaderFiles() = default;
    /// `directory` first; empty: embedded files only. Throws Error when it is no directory.
    explicit ShaderFiles(std::filesystem::path directory);
    /// The directory that the environment variable HACHURE_SHADERS names, if it is set and not empty.
    [[nodiscard]] static ShaderFiles from_environment();

    /// The text of a file, or nothing when there is none. Throws Error when it is there but cannot be read or is over
    /// 1 MiB.
    [[nodiscard]] std::optional<std::string> read(const std::string& name) const;
    [[nodiscard]] Stamp stamp(const std::string& name) const;
    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

private:
    std::filesystem::path directory_;
};

/// A shader with its includes in place, ready for glShaderSource.
///
/// Compilers count the lines of `text`; `lines` leads back to the files. (The usual way, `#line` with a source-string
/// number, does not: Mesa prints number 0 for most messages, whatever the number was.)
struct ShaderSource {
    /// Where a line of `text` comes from.
    struct Line {
        std::uint32_t file = 0;   ///< index into `files`
        std::uint32_t number = 0; ///< from 1

        friend bool operator==(const Line&, const Line&) = default;
    };

    std::string text;               ///< each line ends with a newline
    std::vector<std::string> files; ///< every file in it, the shader itself first
    std::vector<Line> lines;        ///< one per line of `text`; a define has the place of the #version
};

/// Reads `name`, puts `defines` after its #version (which it must have), and replaces each
///     #include "path"
/// by that file's text: `path` is looked for beside the including file, then below shaders/. A file is put in once, at
/// its first include; later ones leave nothing. Includes are replaced whatever `#if` they are in, but not in comments.
/// Throws Error(file, fault, "line N") for a missing file, a file that includes itself over others, a path that leaves
/// shaders/, a malformed #include, or a #version in an included file. `look`, where given, is told every name
/// just before it is looked for, whether it is found or not.
[[nodiscard]] ShaderSource load_shader_source(const ShaderFiles& files, const std::string& name,
                                              std::span<const ShaderDefine> defines = {},
                                              const std::function<void(const std::string&)>& look = {});

/// A compiler's log with places in the files of `source`, one message per line: "gooch/gooch.frag:12: error: ...".
/// Reads the forms of Mesa "0:12(5): error: ...", NVIDIA "0(12) : error C0000: ..."
/// and glslang "ERROR: 0:12: ..."; other lines stay as they are.
[[nodiscard]] std::string readable_shader_log(std::string_view log, const ShaderSource& source);

} // namespace hachure::gpu
