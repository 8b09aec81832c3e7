#include <hachure/runtime/assets/path_rules.h>
#include <hachure/runtime/error.h>

#include <algorithm>
#include <cctype>
#include <system_error>

namespace hachure::assets {
namespace {

namespace fs = std::filesystem;

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

// `scheme:` of RFC 3986, which a drive letter matches too.
bool has_scheme(std::string_view name) {
    const std::size_t colon = name.find(':');
    if (colon == std::string_view::npos || colon == 0) return false;
    const auto scheme_char = [](unsigned char c) { return std::isalnum(c) != 0 || c == '+' || c == '.' || c == '-'; };
    return std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
           std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(colon), scheme_char);
}

bool lies_below(const fs::path& inner, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), inner.begin(), inner.end()).first == folder.end();
}

const char* fault_of_name(std::string_view name) {
    if (name.empty()) return "an empty file name";
    if (name.find('\0') != std::string_view::npos) return "a file name with a NUL in it";
    if (name.find('\\') != std::string_view::npos) return "a file name with a backslash in it";
    if (name.front() == '/') return "an absolute path";
    if (has_scheme(name)) return "a URL or a drive";
    if (const fs::path plain = fs::path(name).lexically_normal(); !plain.empty() && *plain.begin() == "..")
        return "a path that leaves the file's folder";
    return nullptr;
}

} // namespace

std::string percent_decode(std::string_view uri) {
    std::string text;
    text.reserve(uri.size());
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const int high = uri[i] == '%' && i + 2 < uri.size() ? hex_digit(uri[i + 1]) : -1;
        const int low = high >= 0 ? hex_digit(uri[i + 2]) : -1;
        if (low >= 0) {
            text += static_cast<char>(high * 16 + low);
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

fs::path resolve_beside(const fs::path& file, std::string_view uri, std::string_view where) {
    const std::string name = percent_decode(uri);
    const auto refuse = [&](const std::string& fault) {
        throw Error(file.string(), "names " + fault + ": '" + name.substr(0, 200) + "'", where);
    };
    if (const char* fault = fault_of_name(name)) refuse(fault);

    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    fs::path target = folder / fs::path(name);
    std::error_code folder_error, target_error;
    const fs::path real_folder = fs::weakly_canonical(fs::absolute(folder), folder_error);
    const fs::path real_target = fs::weakly_canonical(fs::absolute(target), target_error);
    if (folder_error || target_error) refuse("a path that cannot be followed");
    if (!lies_below(real_target, real_folder)) refuse("a path that leaves the file's folder");
    return target;
}

} // namespace hachure::assets
