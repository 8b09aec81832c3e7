#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/file_fields.h>

namespace hachure {

bool is_file_field(const FieldInfo& field) {
    return field.kind == FieldKind::text && (field.unit == "file" || field.unit == "image file");
}

std::string file_fault(const FieldInfo& field, const std::filesystem::path& file) {
    if (field.unit != "image file" || file.empty()) return {};
    try {
        static_cast<void>(assets::read_image(file));
        return {};
    } catch (const Error& error) {
        return error.what();
    }
}

} // namespace hachure
