#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/file_fields.h>
#include <hachure/systems/scene/scene_faults.h>

#include <fmt/format.h>

#include <utility>

namespace hachure {

bool SceneFaults::is_told(const SceneFile& file, std::string_view pointer, std::string_view text) {
    return !told_.insert(fmt::format("{}\n{}\n{}", file.text().subject(), pointer, text)).second;
}

void SceneFaults::fault(const SceneFile& file, std::string_view pointer, std::string_view text) {
    if (at_ == At::first_throws) throw Error(file.text().subject(), text, file.where(pointer));
    if (faults_.size() < max_told && !is_told(file, pointer, text))
        faults_.push_back({file.text().subject(), std::string(text), file.where(pointer)});
}

void SceneFaults::fault(std::string_view text) {
    if (at_ == At::first_throws) throw Error(text);
    if (faults_.size() < max_told) faults_.push_back({{}, std::string(text), {}});
}

void SceneFaults::warn(const SceneFile& file, std::string_view pointer, std::string_view text) {
    if (is_told(file, pointer, text)) return;
    if (warnings_.size() < max_told)
        warn(Error(file.text().subject(), text, file.where(pointer)).what());
    else
        ++untold_;
}

void SceneFaults::warn(std::string line) {
    if (warnings_.size() < max_told)
        warnings_.push_back(std::move(line));
    else
        ++untold_;
}

const std::string& SceneFaults::file_fault(const FieldInfo& field, const std::string& file) {
    const auto [entry, added] = looked_at_.try_emplace(field.unit + "\n" + file);
    if (added) entry->second = hachure::file_fault(field, file);
    return entry->second;
}

std::vector<std::string> SceneFaults::warnings() const {
    std::vector<std::string> result = warnings_;
    if (untold_ > 0) result.push_back(fmt::format("and {} warnings more", untold_));
    return result;
}

} // namespace hachure
