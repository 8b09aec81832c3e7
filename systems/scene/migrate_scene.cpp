#include <hachure/systems/scene/migrate_scene.h>

#include <array>
#include <map>
#include <optional>
#include <stdexcept>

namespace hachure {
namespace {

using nlohmann::json;

[[noreturn]] void refuse(const std::string& pointer, const std::string& fault) {
    throw std::invalid_argument(pointer + "\n" + fault);
}

/// One object of version 0 as an entity, without its children.
json entity_of(const json& object, const std::string& pointer) {
    if (!object.is_object()) refuse(pointer, "an entity is an object");
    json entity = json::object();
    if (const auto found = object.find("components"); found != object.end()) {
        if (!found->is_object()) refuse(pointer + "/components", "the components of an entity are an object");
        entity = *found;
    }
    for (const auto& [key, value] : object.items()) {
        if (key == "id")
            entity["name"] = value;
        else if (key == "file")
            entity["model"] = value;
        else if (key == "position")
            entity["transform"]["translation"] = value;
        else if (key != "components" && key != "parent")
            entity[key] = value;
    }
    return entity;
}

/// Makes the tree out of the list of version 0.
class Tree {
public:
    Tree(const json& objects, MovedPointers& moved) : objects_(objects), moved_(moved), below_(objects.size()) {
        for (std::size_t i = 0; i < objects.size(); ++i) {
            const json& object = objects[i];
            if (object.is_object() && object.contains("id") && object["id"].is_string())
                by_id_.try_emplace(object["id"].get<std::string>(), i);
        }
        for (std::size_t i = 0; i < objects.size(); ++i) (parent_of(i) ? below_[*parent_of(i)] : roots_).push_back(i);
    }

    json build() {
        json entities = json::array();
        for (const std::size_t root : roots_)
            entities.push_back(entity(root, "/entities/" + std::to_string(entities.size()), 1));
        if (built_ != objects_.size()) refuse("/objects", "entities hang on each other in a circle");
        return entities;
    }

private:
    std::optional<std::size_t> parent_of(std::size_t index) const {
        const json& object = objects_[index];
        if (!object.is_object() || !object.contains("parent") || object["parent"].is_null()) return {};
        const std::string pointer = "/objects/" + std::to_string(index) + "/parent";
        if (!object["parent"].is_string()) refuse(pointer, "a parent is the id of an entity");
        const auto found = by_id_.find(object["parent"].get<std::string>());
        if (found == by_id_.end()) refuse(pointer, "there is no entity of that id");
        return found->second;
    }

    json entity(std::size_t index, const std::string& pointer, int depth) {
        constexpr int max_depth = 250; // as deep as a file of version 1 can say it
        const std::string old = "/objects/" + std::to_string(index);
        if (depth > max_depth) refuse(old, "entities hang on each other too deep");
        ++built_;
        json made = entity_of(objects_[index], old);
        note(pointer, old);
        json children = json::array();
        for (const std::size_t child : below_[index])
            children.push_back(entity(child, pointer + "/children/" + std::to_string(children.size()), depth + 1));
        if (!children.empty()) made["children"] = std::move(children);
        return made;
    }

    void note(const std::string& pointer, const std::string& old) {
        moved_.emplace_back(pointer, old);
        moved_.emplace_back(pointer + "/name", old + "/id");
        moved_.emplace_back(pointer + "/model", old + "/file");
        moved_.emplace_back(pointer + "/transform/translation", old + "/position");
    }

    const json& objects_;
    MovedPointers& moved_;
    std::map<std::string, std::size_t> by_id_;
    std::vector<std::vector<std::size_t>> below_;
    std::vector<std::size_t> roots_;
    std::size_t built_ = 0;
};

void from_version_0(json& document, MovedPointers& moved) {
    document["hachure_scene"] = 1;
    const auto found = document.find("objects");
    if (found == document.end()) return;
    if (!found->is_array()) refuse("/objects", "the objects of a scene are a list");
    const json objects = std::move(*found);
    document.erase("objects");
    document["entities"] = Tree(objects, moved).build();
    moved.emplace_back("/entities", "/objects");
}

/// Entry i makes version i + 1 out of version i.
constexpr std::array<void (*)(json&, MovedPointers&), scene_version> steps{&from_version_0};

} // namespace

MigratedScene migrate_scene(const json& document, int version) {
    MigratedScene result{document, {}};
    for (auto step = static_cast<std::size_t>(version); step < steps.size(); ++step) {
        MovedPointers moved;
        steps[step](result.document, moved);
        result.moved.insert(result.moved.begin(), std::move(moved));
    }
    return result;
}

} // namespace hachure
