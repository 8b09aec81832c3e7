#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/shader_source.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace hachure::gpu {
namespace {

/// "b/../c" below folder "a/" as "a/c"; nothing when it is absolute, empty or leaves the root.
std::optional<std::string> join_name(std::string_view folder, std::string_view path) {
    if (path.empty() || path.front() == '/' || path.find('\\') != std::string_view::npos) return std::nullopt;
    std::string joined = (std::filesystem::path(folder) / path).lexically_normal().generic_string();
    if (joined == ".." || joined.starts_with("../") || joined == ".") return std::nullopt;
    return joined;
}

std::string_view trim(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// What follows `#keyword` when the line is that directive.
std::optional<std::string_view> directive(std::string_view line, std::string_view keyword) {
    line = trim(line);
    if (!line.starts_with('#')) return std::nullopt;
    line = trim(line.substr(1));
    if (!line.starts_with(keyword)) return std::nullopt;
    line.remove_prefix(keyword.size());
    if (!line.empty() && (std::isalnum(static_cast<unsigned char>(line.front())) != 0 || line.front() == '_')) {
        return std::nullopt;
    }
    return trim(line);
}

/// The path between the quotes of an #include, if that is what stands there and only a comment follows.
std::optional<std::string_view> between_quotes(std::string_view text) {
    if (text.size() < 2 || text.front() != '"') return std::nullopt;
    const std::size_t end = text.find('"', 1);
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view rest = trim(text.substr(end + 1));
    if (!rest.empty() && !rest.starts_with("//")) return std::nullopt;
    return text.substr(1, end - 1);
}

/// Whether the line after `line` starts inside a /* comment */, when `line` does so or not.
bool comment_open_after(std::string_view line, bool open) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const std::string_view pair = line.substr(i, 2);
        if (open && pair == "*/") {
            open = false;
            ++i;
        } else if (!open && pair == "//") {
            return false;
        } else if (!open && pair == "/*") {
            open = true;
            ++i;
        }
    }
    return open;
}

class Loader {
public:
    Loader(const ShaderFiles& files, std::span<const ShaderDefine> defines,
           const std::function<void(const std::string&)>& look)
        : files_(files), defines_(defines), look_(look) {}

    ShaderSource load(const std::string& name) {
        const std::optional<std::string> text = find(name);
        if (!text) throw Error(name, "there is no such shader");
        append(name, *text);
        return std::move(source_);
    }

private:
    std::optional<std::string> find(const std::string& name) {
        if (look_) look_(name);
        return files_.read(name);
    }

    struct Place {
        const std::string& name;
        std::uint32_t file;
        std::uint32_t number;

        [[nodiscard]] std::string line() const { return fmt::format("line {}", number); }
    };

    void append(const std::string& name, std::string_view text) {
        const auto file = static_cast<std::uint32_t>(source_.files.size());
        source_.files.push_back(name);
        open_.push_back(name);
        bool versioned = false, in_comment = false;
        for (std::uint32_t number = 1; !text.empty(); ++number) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            const std::string_view line = text.substr(0, end);
            text.remove_prefix(std::min(end + 1, text.size()));
            append_line(line, Place{name, file, number}, in_comment, versioned);
            in_comment = comment_open_after(line, in_comment);
        }
        if (file == 0 && !versioned) throw Error(name, "the shader has no #version");
        if (in_comment) throw Error(name, "a /* comment is not closed");
        open_.pop_back();
    }

    void append_line(std::string_view line, const Place& place, bool in_comment, bool& versioned) {
        const auto path = in_comment ? std::nullopt : directive(line, "include");
        if (path) return include(*path, place);
        emit(line, place);
        if (in_comment || !directive(line, "version")) return;
        if (place.file != 0) throw Error(place.name, "an included file has a #version", place.line());
        versioned = true;
        for (const ShaderDefine& define : defines_)
            emit(fmt::format("#define {} {}", define.name, define.value), place);
    }

    void emit(std::string_view line, const Place& place) {
        source_.text.append(line).append("\n");
        source_.lines.push_back({place.file, place.number});
    }

    void include(std::string_view written, const Place& place) {
        const auto path = between_quotes(written);
        if (!path) throw Error(place.name, "an #include needs a path in double quotes", place.line());
        const std::string folder = std::filesystem::path(place.name).parent_path().generic_string();
        const auto beside = join_name(folder, *path);
        const auto below_root = join_name({}, *path);
        if (!beside && !below_root) {
            throw Error(place.name, fmt::format("\"{}\" leaves the shader directory", *path), place.line());
        }
        for (const auto& candidate : {beside, below_root}) {
            if (!candidate) continue;
            if (std::find(open_.begin(), open_.end(), *candidate) != open_.end()) refuse_cycle(*candidate, place);
            const bool already =
                std::find(source_.files.begin(), source_.files.end(), *candidate) != source_.files.end();
            const std::optional<std::string> text = already ? std::string() : find(*candidate);
            if (!text) continue;
            if (!already) append(*candidate, *text);
            return;
        }
        throw Error(place.name, fmt::format("there is no \"{}\" to include", *path), place.line());
    }

    [[noreturn]] void refuse_cycle(const std::string& name, const Place& place) const {
        std::string chain;
        for (auto it = std::find(open_.begin(), open_.end(), name); it != open_.end(); ++it) chain += *it + " -> ";
        throw Error(place.name, fmt::format("the includes form a cycle: {}{}", chain, name), place.line());
    }

    const ShaderFiles& files_;
    std::span<const ShaderDefine> defines_;
    const std::function<void(const std::string&)>& look_;
    ShaderSource source_;
    std::vector<std::string> open_; // the files whose text is being put in, outermost first
};

} // namespace

ShaderSource load_shader_source(const ShaderFiles& files, const std::string& name,
                                std::span<const ShaderDefine> defines,
                                const std::function<void(const std::string&)>& look) {
    return Loader(files, defines, look).load(name);
}

} // namespace hachure::gpu
