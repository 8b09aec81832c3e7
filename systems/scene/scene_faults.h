#pragma once

#include <hachure/runtime/ecs/field_info.h>
#include <hachure/systems/scene/scene_file.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace hachure {

/// What is wrong with a scene, and where: as the parts of Error.
struct SceneFault {
    std::string subject, fault, where;
};

/// Where a reader of scenes says what it finds: the first fault ends it, or all are collected.
class SceneFaults {
public:
    enum class At { first_throws, all_are_kept };

    /// So many faults and warnings are told, and no more: the place of each costs a walk over the text.
    static constexpr std::size_t max_told = 200;

    explicit SceneFaults(At at) : at_(at) {}

    /// What stands at `pointer` of the file's root is wrong. Throws Error unless all are kept; the reader then goes on
    /// as if it were not there.
    void fault(const SceneFile& file, std::string_view pointer, std::string_view text);

    /// The same for what another reader said whole, with its subject.
    void fault(std::string_view text);

    /// Odd, and no error.
    void warn(const SceneFile& file, std::string_view pointer, std::string_view text);
    void warn(std::string line);

    /// What is wrong with a file that a field names (`file_fault`), looked at once.
    const std::string& file_fault(const FieldInfo& field, const std::string& file);

    [[nodiscard]] const std::vector<SceneFault>& faults() const { return faults_; }

    /// One line each.
    [[nodiscard]] std::vector<std::string> warnings() const;

private:
    /// Whether the same has been said of the same place.
    bool is_told(const SceneFile& file, std::string_view pointer, std::string_view text);

    At at_;
    std::vector<SceneFault> faults_;
    std::vector<std::string> warnings_;
    std::unordered_set<std::string> told_; ///< a scene that is referred to many times says the same many times
    std::unordered_map<std::string, std::string> looked_at_; ///< what is wrong with files, by unit and path
    std::size_t untold_ = 0;
};

} // namespace hachure
