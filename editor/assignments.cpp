#include <hachure/components/name_index.h>
#include <hachure/editor/assignments.h>
#include <hachure/editor/usage_error.h>
#include <hachure/runtime/error.h>

namespace hachure {
namespace {

Assignment parse_assignment(const TypeRegistry& types, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw UsageError("--set: '" + text + "' is not PATH=VALUE");
    std::string path = text.substr(0, equals);
    Assignment result;
    if (const std::size_t slash = path.rfind('/'); slash != std::string::npos) {
        result.entity = path.substr(0, slash);
        path.erase(0, slash + 1);
    }
    const std::size_t dot = path.find('.');
    if (dot == std::string::npos) throw UsageError("--set: '" + path + "' is not component.field");
    result.type = types.find(path.substr(0, dot));
    if (!result.type)
        throw UsageError("--set: there is no component '" + path.substr(0, dot) + "' (see hachure list components)");
    result.field = result.type->field(path.substr(dot + 1));
    if (!result.field)
        throw UsageError("--set: component '" + result.type->name + "' has no field '" + path.substr(dot + 1) + "'");
    try {
        result.value = parse_field(*result.field, text.substr(equals + 1));
    } catch (const Error& error) {
        throw UsageError(std::string("--set: ") + error.what());
    }
    return result;
}

} // namespace

std::vector<Assignment> parse_assignments(const TypeRegistry& types, std::span<const std::string> texts) {
    std::vector<Assignment> result;
    for (const std::string& text : texts) result.push_back(parse_assignment(types, text));
    return result;
}

void apply_assignments(World& world, std::span<const Assignment> assignments) {
    NameIndex names;
    for (const Assignment& assignment : assignments) {
        const TypeInfo& type = *assignment.type;
        names.update(world); // an assignment may rename
        bool found = false;
        for (const Entity entity :
             assignment.entity.empty() ? type.entities(world) : names.find_all(world, assignment.entity)) {
            void* component = type.find_mutable(world, entity);
            if (!component) continue;
            assignment.field->set(component, assignment.value);
            found = true;
        }
        if (found) continue;
        const std::string who =
            assignment.entity.empty() ? "no entity" : "no entity called '" + assignment.entity + "'";
        throw Error("--set " + assignment.field->path, who + " carries '" + type.name + "'");
    }
}

} // namespace hachure
