#include <hachure/runtime/assets/mesh_builder.h>
#include <hachure/runtime/assets/mesh_bytes.h>
#include <hachure/runtime/assets/obj_material.h>
#include <hachure/runtime/assets/text_scanner.h>

#include <algorithm>
#include <cstring>
#include <unordered_map>

namespace hachure::assets {
namespace {

constexpr std::size_t max_library_bytes = std::size_t{16} << 20;
constexpr std::size_t max_image_bytes = std::size_t{256} << 20;

/// A file beside the OBJ, or nothing and a warning.
MeshBytes read_beside(const std::filesystem::path& obj, std::string_view name, std::string_view what,
                      std::size_t max_bytes, WarningList& warnings) {
    const std::filesystem::path path = path_beside(obj, name);
    std::error_code error;
    if (path.empty()) {
        warnings.add_name(std::string(what) + " outside of the file's folder are not read", name);
    } else if (!std::filesystem::is_regular_file(path, error) || std::filesystem::file_size(path, error) > max_bytes) {
        warnings.add_name(std::string(what) + " not found, or too large", name);
    } else {
        try {
            return read_mesh_bytes(path);
        } catch (const Error& unreadable) {
            warnings.add_name(std::string(what) + " not readable", unreadable.what());
        }
    }
    return {};
}

class LibraryReader {
public:
    LibraryReader(const std::filesystem::path& obj, std::span<const std::string> names, Model& model,
                  WarningList& warnings)
        : obj_(obj), model_(model), warnings_(warnings), defined_(names.size(), false) {
        for (std::size_t i = 0; i < names.size(); ++i) by_name_.emplace(names[i], i);
        for (const std::string& name : names) {
            Material& material = model.materials.emplace_back();
            material.name = name;
            material.metallic = 0.0f;
        }
    }

    void read(std::string_view text) {
        TextScanner scan(obj_, text);
        current_ = nullptr;
        for (; !scan.at_end(); scan.skip_line()) {
            scan.skip_blanks();
            if (scan.at_line_end()) continue;
            const std::string_view name = scan.word();
            if (name == "newmtl")
                select(scan.rest_in_line());
            else if (current_)
                property(name, scan);
        }
    }

    void report_undefined() {
        for (std::size_t i = 0; i < defined_.size(); ++i)
            if (!defined_[i]) warnings_.add_name("materials not defined", model_.materials[i].name);
    }

private:
    /// Materials that the model does not use are passed over.
    void select(std::string_view name) {
        const auto at = by_name_.find(name);
        current_ = at == by_name_.end() || defined_[at->second] ? nullptr : &model_.materials[at->second];
        if (current_) defined_[at->second] = true;
    }

    void property(std::string_view name, TextScanner& scan) {
        if (name == "Kd")
            return color(scan, [&](const glm::vec3& c) { current_->base_color = {c, current_->base_color.a}; });
        if (name == "Ke") return color(scan, [&](const glm::vec3& c) { current_->emissive = c; });
        if (name == "d") return number(scan, [&](float v) { opacity(v); });
        if (name == "Tr") return number(scan, [&](float v) { opacity(1.0f - v); });
        if (name == "Pr") return number(scan, [&](float v) { current_->roughness = v; });
        if (name == "Pm") return number(scan, [&](float v) { current_->metallic = v; });
        if (name == "map_Kd") return image(scan.rest_in_line());
        constexpr std::string_view passed_over[] = {"Ka", "Ks", "Ns", "Ni", "Tf", "illum"};
        if (std::ranges::find(passed_over, name) == std::end(passed_over))
            warnings_.add_name("material statements not read", name);
    }

    /// A value in [0, 1]; anything else is passed over with a warning.
    bool unit_number(TextScanner& scan, float& value) {
        scan.skip_blanks();
        if (scan.read(value) && value >= 0.0f && value <= 1.0f) return true;
        warnings_.add_count("values of materials are not in [0, 1], and not used");
        return false;
    }

    template <class Set> void number(TextScanner& scan, Set&& set) {
        float value = 0.0f;
        if (unit_number(scan, value)) set(value);
    }

    template <class Set> void color(TextScanner& scan, Set&& set) {
        glm::vec3 c(0.0f);
        if (!unit_number(scan, c.x)) return;
        scan.skip_blanks();
        if (scan.at_line_end())
            c.y = c.z = c.x; // the format allows one number for all three
        else if (!unit_number(scan, c.y) || !unit_number(scan, c.z))
            return;
        set(glm::vec3(linear_from_srgb(c.x), linear_from_srgb(c.y), linear_from_srgb(c.z)));
    }

    void opacity(float value) {
        current_->base_color.a = value;
        current_->alpha_mode = value < 1.0f ? AlphaMode::blend : AlphaMode::opaque;
    }

    void image(std::string_view name) {
        if (name.starts_with('-')) {
            warnings_.add_name("options of map_Kd not read", name.substr(0, name.find(' ')));
            name = after_options(name);
        }
        if (name.empty()) return;
        const auto [at, is_new] = images_.try_emplace(std::string(name), -1);
        if (is_new) {
            const MeshBytes bytes = read_beside(obj_, name, "images", max_image_bytes, warnings_);
            if (bytes.size > 0) {
                at->second = static_cast<std::int32_t>(model_.textures.size());
                Texture texture;
                texture.image = static_cast<std::int32_t>(model_.images.size());
                model_.textures.push_back(texture);
                const auto* first = reinterpret_cast<const std::byte*>(bytes.data.get());
                model_.images.push_back({std::string(name), {first, first + bytes.size}});
            }
        }
        current_->base_color_texture.texture = at->second;
    }

    /// Options are "-name" and numbers or on/off; the name of the file is what follows them, blanks included.
    static std::string_view after_options(std::string_view text) {
        for (;;) {
            const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
            const std::string_view word = text.substr(0, end);
            const bool is_option =
                word.starts_with('-') || word == "on" || word == "off" ||
                (!word.empty() && word.find_first_not_of("0123456789.+-eE") == std::string_view::npos);
            if (!is_option || end == text.size()) return is_option ? std::string_view{} : text;
            text.remove_prefix(std::min(text.find_first_not_of(" \t", end), text.size()));
        }
    }

    const std::filesystem::path& obj_;
    Model& model_;
    WarningList& warnings_;
    std::vector<bool> defined_;
    std::unordered_map<std::string_view, std::size_t> by_name_; ///< views of the caller's names
    std::unordered_map<std::string, std::int32_t> images_;      ///< name -> texture
    Material* current_ = nullptr;
};

} // namespace

std::filesystem::path path_beside(const std::filesystem::path& file, std::string_view name) {
    std::string portable(name);
    std::ranges::replace(portable, '\\', '/');
    const std::filesystem::path path(portable);
    // A colon is a drive or the scheme of a URL.
    if (portable.empty() || path.is_absolute() || portable.find(':') != std::string::npos ||
        portable.find('\0') != std::string::npos)
        return {};
    for (const auto& part : path)
        if (part == "..") return {};
    return file.parent_path() / path;
}

void read_obj_materials(const std::filesystem::path& obj, std::span<const std::string> libraries,
                        std::span<const std::string> names, Model& model, WarningList& warnings) {
    LibraryReader reader(obj, names, model, warnings);
    for (const std::string& library : libraries) {
        const MeshBytes bytes = read_beside(obj, library, "material libraries", max_library_bytes, warnings);
        reader.read(bytes.text());
    }
    reader.report_undefined();
}

} // namespace hachure::assets
