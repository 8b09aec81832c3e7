#include <hachure/runtime/error.h>

namespace hachure {
namespace {

std::string one_line(std::string text) {
    for (char& c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f) c = '?';
    }
    return text;
}

std::string compose(std::string_view subject, std::string_view fault, std::string_view where) {
    std::string text;
    if (!subject.empty()) text.append(subject).append(": ");
    text.append(fault);
    if (!where.empty()) text.append(" (").append(where).append(")");
    return one_line(std::move(text));
}

} // namespace

Error::Error(std::string_view fault) : std::runtime_error(compose({}, fault, {})) {}

Error::Error(std::string_view subject, std::string_view fault, std::string_view where)
    : std::runtime_error(compose(subject, fault, where)) {}

} // namespace hachure
