#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/type_id.h>

#include <cxxabi.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace hachure::detail {
namespace {

std::string demangled(const std::string& mangled) {
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> text(
        abi::__cxa_demangle(mangled.c_str(), nullptr, nullptr, &status), &std::free);
    return text ? std::string(text.get()) : mangled;
}

/// Whether a name of a scope ends in the anonymous namespace or in a function: `(anonymous namespace)::`, `f()::`,
/// `A::f() const::`, `f() &::`.
bool is_private_scope(std::string_view scope) {
    return scope.ends_with(')') || scope.ends_with('&') || scope.ends_with(") const") ||
           scope.ends_with(") volatile") || scope.ends_with('}');
}

/// Whether two files may have different types of this name.
bool belongs_to_one_file(std::string_view name) {
    for (std::size_t at = name.find("::"); at != name.npos; at = name.find("::", at + 2))
        if (is_private_scope(name.substr(0, at))) return true;
    return name.find("{lambda") != name.npos || name.find("{unnamed") != name.npos;
}

class Registry {
public:
    TypeId id(const TypeKey& key) {
        const std::lock_guard lock(mutex_);
        if (const auto found = known_.find(key.mangled); found != known_.end()) return checked(found->second, key);
        // Copied: the text lies in a library that may be unloaded.
        const std::string mangled(key.mangled);
        const Known known{next_++, key.size, key.alignment};
        if (!belongs_to_one_file(demangled(mangled))) known_.emplace(mangled, known);
        return known.id;
    }

private:
    struct Known {
        TypeId id;
        std::size_t size;
        std::size_t alignment;
    };

    static TypeId checked(const Known& known, const TypeKey& key) {
        if (known.size != key.size || known.alignment != key.alignment) {
            const std::string message = fmt::format(
                "{} has {} bytes aligned to {} in one library and {} aligned to {} in another: build both from the "
                "same sources",
                demangled(std::string(key.mangled)), known.size, known.alignment, key.size, key.alignment);
            assertion_failed("a type has one layout", message.c_str(), __FILE__, __LINE__);
        }
        return known.id;
    }

    std::mutex mutex_;
    std::map<std::string, Known, std::less<>> known_;
    TypeId next_ = 1;
};

} // namespace

TypeId next_type_id(TypeFamily family, const TypeKey& key) {
    static std::array<Registry, 4> registries;
    return registries[static_cast<std::size_t>(family)].id(key);
}

} // namespace hachure::detail
