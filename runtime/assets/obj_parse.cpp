#include <hachure/runtime/assets/mesh_builder.h>
#include <hachure/runtime/assets/obj_data.h>
#include <hachure/runtime/assets/text_scanner.h>

#include <array>

namespace hachure::assets {
namespace {

/// Some writers end the text with the zero that ends their strings.
std::string_view without_padding(std::string_view text) { return text.substr(0, text.find_last_not_of('\0') + 1); }

class ObjParser {
public:
    ObjParser(const std::filesystem::path& file, std::string_view text, WarningList& warnings)
        : scan_(file, without_padding(text)), warnings_(warnings) {
        if (text.starts_with("\xef\xbb\xbf")) scan_.advance(3); // a byte order mark
        data_.objects.push_back(model_name(file));
        data_.runs.push_back({0, 0, -1});
        data_.positions.reserve(text.size() / 80);
        data_.corners.reserve(text.size() / 16);
        data_.faces.reserve(text.size() / 48);
    }

    ObjData run() {
        while (!scan_.at_end()) {
            scan_.skip_blanks_and_continuations();
            if (!scan_.at_line_end()) statement();
            scan_.skip_line();
        }
        return std::move(data_);
    }

private:
    void statement() {
        const std::string_view name = scan_.word();
        if (name == "v") return position();
        if (name == "f") return face();
        if (name == "vt") return texcoord();
        if (name == "vn") return normal();
        if (name == "o") return object();
        if (name == "usemtl") return material();
        if (name == "mtllib") return library();
        if (name != "g" && name != "s") warnings_.add_name("statements not read", name);
    }

    /// Reads up to N numbers to the end of the line and returns how many there were.
    template <std::size_t N> std::size_t numbers(std::array<float, N>& values) {
        std::size_t count = 0;
        for (;; ++count) {
            scan_.skip_blanks_and_continuations();
            if (scan_.at_line_end() || count == N) return count;
            if (!scan_.read(values[count]) || !(scan_.at_word_end() || scan_.peek() == '#'))
                scan_.fail("expected a number");
        }
    }

    void position() {
        std::array<float, 7> v;
        const std::size_t count = numbers(v);
        if (count < 3) scan_.fail("a position has three numbers");
        const glm::vec3 position(v[0], v[1], v[2]);
        if (!is_finite(position)) scan_.fail("a position is not finite");
        data_.positions.push_back(position);
        // Six numbers are position and colour; a fourth alone, or before the colour, is a weight.
        const bool has_color = count >= 6;
        if (!has_color && data_.colors.empty()) return;
        data_.colors.resize(data_.positions.size(), glm::vec3(1.0f));
        if (has_color) data_.colors.back() = {v[count - 3], v[count - 2], v[count - 1]};
    }

    void texcoord() {
        std::array<float, 3> v{};
        if (numbers(v) == 0) scan_.fail("a texture coordinate has at least one number");
        data_.texcoords.emplace_back(v[0],
                                     1.0f - v[1]); // OBJ counts v from the bottom of the image, Model from its top
    }

    void normal() {
        std::array<float, 3> v;
        if (numbers(v) < 3) scan_.fail("a normal has three numbers");
        data_.normals.emplace_back(v[0], v[1], v[2]);
    }

    /// A position in a list of `size` so far, from one counted from 1, or backwards from -1.
    std::uint32_t index(std::size_t size) {
        std::int64_t i = 0;
        if (!scan_.read(i)) scan_.fail("expected an index");
        if (i < 0) i += static_cast<std::int64_t>(size) + 1;
        if (i < 1 || i > 0xfffffffe) scan_.fail("index out of range");
        return static_cast<std::uint32_t>(i - 1);
    }

    ObjCorner corner() {
        ObjCorner corner{index(data_.positions.size()), ObjCorner::absent, ObjCorner::absent};
        if (scan_.peek() == '/') {
            scan_.advance(1);
            if (scan_.peek() != '/' && !scan_.at_word_end()) corner.t = index(data_.texcoords.size());
            if (scan_.peek() == '/') {
                scan_.advance(1);
                if (!scan_.at_word_end()) corner.n = index(data_.normals.size());
            }
        }
        if (!scan_.at_word_end() && scan_.peek() != '#') scan_.fail("expected v, v/t, v//n or v/t/n");
        return corner;
    }

    void face() {
        data_.faces.push_back(
            {static_cast<std::uint32_t>(data_.corners.size()), static_cast<std::uint32_t>(scan_.offset())});
        for (;;) {
            scan_.skip_blanks_and_continuations();
            if (scan_.at_line_end()) return;
            data_.corners.push_back(corner());
        }
    }

    void start_run(std::uint32_t object, std::int32_t material) {
        const auto face = static_cast<std::uint32_t>(data_.faces.size());
        if (data_.runs.back().first_face == face)
            data_.runs.back() = {face, object, material};
        else
            data_.runs.push_back({face, object, material});
    }

    void object() {
        const std::string_view name = scan_.rest_in_line();
        if (data_.objects.size() == max_obj_parts) {
            warnings_.add_count("objects are more than can be kept apart");
            return;
        }
        data_.objects.emplace_back(name);
        start_run(static_cast<std::uint32_t>(data_.objects.size() - 1), data_.runs.back().material);
    }

    void material() {
        const std::string_view name = scan_.rest_in_line();
        auto at = materials_.find(name);
        if (at == materials_.end()) {
            if (materials_.size() == max_obj_parts) {
                warnings_.add_count("materials are more than can be kept apart");
                return;
            }
            at = materials_.emplace(name, static_cast<std::int32_t>(materials_.size())).first;
            data_.materials.emplace_back(name);
        }
        start_run(data_.runs.back().object, at->second);
    }

    void library() {
        const std::string_view name = scan_.rest_in_line();
        constexpr std::size_t max_libraries = 64;
        if (data_.libraries.size() < max_libraries)
            data_.libraries.emplace_back(name);
        else
            warnings_.add_name("material libraries not read", name);
    }

    TextScanner scan_;
    WarningList& warnings_;
    ObjData data_;
    std::unordered_map<std::string_view, std::int32_t> materials_; ///< views of the text
};

} // namespace

ObjData parse_obj(const std::filesystem::path& file, std::string_view text, WarningList& warnings) {
    return ObjParser(file, text, warnings).run();
}

} // namespace hachure::assets
