#include <hachure/editor/play/find_tests.h>
#include <hachure/runtime/error.h>

#include <algorithm>
#include <set>
#include <string>

namespace hachure::play {
namespace {

std::vector<std::filesystem::path> tests_below(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> found;
    std::error_code fault;
    for (auto entry = std::filesystem::recursive_directory_iterator(folder, fault);
         !fault && entry != std::filesystem::recursive_directory_iterator(); entry.increment(fault))
        if (entry->path().filename().string().ends_with(".play.json") && entry->is_regular_file())
            found.push_back(entry->path());
    if (fault) throw Error(folder.string(), "can't be searched", fault.message());
    if (found.empty()) throw Error(folder.string(), "holds no playback test: no *.play.json file");
    std::ranges::sort(found);
    return found;
}

} // namespace

std::vector<std::filesystem::path> find_tests(std::span<const std::filesystem::path> paths) {
    std::vector<std::filesystem::path> tests;
    std::set<std::filesystem::path> known;
    for (const std::filesystem::path& path : paths) {
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) throw Error(path.string(), "there is no such file or folder");
        const bool folder = std::filesystem::is_directory(path, ignored);
        for (const std::filesystem::path& test : folder ? tests_below(path) : std::vector{path})
            if (known.insert(std::filesystem::weakly_canonical(test)).second) tests.push_back(test);
    }
    return tests;
}

} // namespace hachure::play
