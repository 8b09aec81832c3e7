#include <hachure/tests/layers/source_tree.h>

#include <algorithm>
#include <fstream>
#include <set>

namespace hachure::test {
namespace {

namespace fs = std::filesystem;

/// The paths that the file includes as `open`path`close`.
std::vector<std::string> included(const fs::path& file, const std::string& open, char close) {
    std::vector<std::string> paths;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        const std::size_t start = line.find_first_not_of(" \t");
        if (start == line.npos || line.compare(start, 8, "#include") != 0) continue;
        const std::size_t at = line.find(open), end = at == line.npos ? at : line.find(close, at + open.size());
        if (end != line.npos) paths.push_back(line.substr(at + open.size(), end - at - open.size()));
    }
    return paths;
}

std::vector<Include> includes_below(const std::string& folder, const std::set<std::string>& extensions,
                                    const std::string& open, char close, const std::string& prefix) {
    std::vector<Include> result;
    if (!fs::is_directory(source_root() / folder)) return result;
    for (const auto& entry : fs::recursive_directory_iterator(source_root() / folder)) {
        if (!entry.is_regular_file() || !extensions.contains(entry.path().extension().string())) continue;
        const std::string from = fs::relative(entry.path(), source_root()).generic_string();
        for (const std::string& path : included(entry.path(), open, close)) result.push_back({from, prefix + path});
    }
    return result;
}

} // namespace

fs::path source_root() { return HACHURE_SOURCE_DIR; }

std::vector<Include> source_includes(const std::vector<std::string>& folders) {
    std::vector<Include> all;
    for (const std::string& folder : folders)
        for (Include& include : includes_below(folder, {".h", ".cpp"}, "<hachure/", '>', ""))
            all.push_back(std::move(include));
    return all;
}

std::vector<Include> shader_includes() {
    return includes_below("shaders", {".glsl", ".vert", ".frag", ".comp"}, "\"", '"', "shaders/");
}

std::vector<std::string> folders_in(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(source_root() / folder))
        if (entry.is_directory()) names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

std::vector<std::string> stems_in(const std::string& folder, const std::string& extension) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(source_root() / folder))
        if (entry.path().extension() == extension) names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

std::string top(const std::string& path, int count) {
    std::size_t end = 0;
    for (int i = 0; i < count && end != path.npos; ++i) end = path.find('/', end == 0 ? 0 : end + 1);
    return path.substr(0, end);
}

} // namespace hachure::test
