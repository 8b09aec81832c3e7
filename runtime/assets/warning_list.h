#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::assets {

/// Collects what a reader wants to say: each kind gives one line, however often it occurs.
class WarningList {
public:
    /// "KIND: FIRST, SECOND, THIRD and 5 more", each name once, cut short and on one line.
    void add_name(std::string_view kind, std::string_view name) {
        constexpr std::size_t shown = 8, longest = 64;
        Entry& entry = find(kind);
        std::string text(name.substr(0, longest));
        std::ranges::replace_if(
            text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
        if (std::ranges::find(entry.names, text) != entry.names.end()) return;
        if (entry.names.size() < shown)
            entry.names.push_back(text);
        else
            ++entry.more;
    }

    /// "COUNT KIND".
    void add_count(std::string_view kind, std::size_t count = 1) { find(kind).count += count; }

    /// One line for each kind, in the order of their first occurrence.
    [[nodiscard]] std::vector<std::string> lines() const {
        std::vector<std::string> lines;
        for (const Entry& entry : entries_) {
            std::string line = entry.count > 0 ? std::to_string(entry.count) + " " + entry.kind : entry.kind;
            for (std::size_t i = 0; i < entry.names.size(); ++i) line += (i == 0 ? ": " : ", ") + entry.names[i];
            if (entry.more > 0) line += " and " + std::to_string(entry.more) + " more";
            lines.push_back(std::move(line));
        }
        return lines;
    }

private:
    struct Entry {
        std::string kind;
        std::vector<std::string> names{};
        std::size_t more = 0, count = 0;
    };
    Entry& find(std::string_view kind) {
        const auto at = std::ranges::find(entries_, kind, &Entry::kind);
        return at != entries_.end() ? *at : entries_.emplace_back(Entry{std::string(kind)});
    }
    std::vector<Entry> entries_;
};

} // namespace hachure::assets
