#include <hachure/runtime/ecs/snapshot.h>
#include <hachure/runtime/ecs/snapshot/snapshot_column.h>
#include <hachure/runtime/ecs/snapshot/snapshot_format.h>
#include <hachure/runtime/ecs/snapshot/snapshot_gather.h>
#include <hachure/runtime/ecs/snapshot/snapshot_live.h>
#include <hachure/runtime/ecs/snapshot/snapshot_tree.h>

#include <zlib.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace hachure {
namespace detail {
namespace {

/// The entities that carry a type of component, in order of slots.
struct Carriers {
    std::vector<std::uint32_t> places; ///< among the live entities
    std::vector<const void*> components;
};

void sort(Carriers& carriers) {
    if (std::ranges::is_sorted(carriers.places)) return;
    std::vector<std::pair<std::uint32_t, const void*>> pairs;
    pairs.reserve(carriers.places.size());
    for (std::size_t i = 0; i < carriers.places.size(); ++i)
        pairs.emplace_back(carriers.places[i], carriers.components[i]);
    std::ranges::sort(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) std::tie(carriers.places[i], carriers.components[i]) = pairs[i];
}

Carriers find_carriers(const World& world, const TypeInfo& type, const LiveEntities& live) {
    struct Search {
        const LiveEntities& live;
        Carriers found;
    } search{live, {}};
    type.each(
        world,
        [](void* context, Entity entity, const void* component) {
            auto& [entities, found] = *static_cast<Search*>(context);
            found.places.push_back(entities.place[entity.index]);
            found.components.push_back(component);
        },
        &search);
    sort(search.found);
    return std::move(search.found);
}

class SnapshotWriter {
public:
    SnapshotWriter(const World& world, const TypeRegistry& types) : world_(world), types_(types), live_(world) {}

    std::vector<std::byte> run() && {
        out_.bytes(std::as_bytes(std::span(snapshot_magic)));
        out_.number(snapshot_version);
        const std::size_t length = out_.size();
        out_.number(std::uint64_t{0});
        section(SnapshotSection::entities, [&] { live_.write(out_); });
        section(SnapshotSection::tree, [&] { write_tree(out_, world_, live_.place); });
        write_components();
        out_.patch(length, std::uint64_t{bytes_.size() + snapshot_checksum_bytes});
        const auto* begin = reinterpret_cast<const Bytef*>(bytes_.data());
        out_.number(static_cast<std::uint32_t>(::crc32_z(0, begin, bytes_.size())));
        return std::move(bytes_);
    }

private:
    struct Unknown {
        TypeBlock block;
        bool whole; ///< a whole type, not just fields of one
    };

    template <class F> void section(SnapshotSection tag, F&& write) {
        out_.number(tag);
        const std::size_t length = out_.size();
        out_.number(std::uint64_t{0});
        write();
        out_.patch(length, std::uint64_t{out_.size() - length - sizeof(std::uint64_t)});
    }

    /// In order of names, so that the order of registration does not matter.
    void write_components() {
        std::map<std::string_view, const TypeInfo*> names;
        if (const auto* unknown = world_.find_resource<UnknownComponents>()) read_unknown(*unknown);
        for (const auto& [name, block] : unknown_) names[name] = nullptr;
        for (const TypeInfo& type : types_.types()) names[type.name] = &type;
        for (const auto& [name, named] : names) {
            const TypeInfo* type = named; // clang 14 lets no lambda capture a structured binding
            const Carriers carriers = type ? find_carriers(world_, *type, live_) : Carriers{};
            const Unknown* unknown = unknown_.contains(name) ? &unknown_.at(name) : nullptr;
            if (type && !carriers.places.empty())
                section(SnapshotSection::component, [&] { write_known(*type, carriers, unknown); });
            else if (unknown && unknown->whole)
                write_unknown(unknown->block);
        }
    }

    void read_unknown(const UnknownComponents& unknown) {
        former_ = &unknown;
        for (const auto& bytes : unknown.types) read_unknown(bytes, true);
        for (const auto& bytes : unknown.fields) read_unknown(bytes, false);
    }

    void read_unknown(const std::vector<std::byte>& bytes, bool whole) {
        ByteReader in(bytes, "unknown components");
        TypeBlock block = read_type_block(in, static_cast<std::uint32_t>(former_->entities.size()));
        const std::string_view name = block.name;
        unknown_.emplace(name, Unknown{std::move(block), whole});
    }

    void write_known(const TypeInfo& type, const Carriers& carriers, const Unknown* unknown) {
        std::map<std::string_view, const FieldInfo*> fields;
        std::map<std::string_view, const Column*> others;
        for (const FieldInfo& field : type.fields) fields[field.name] = &field;
        if (unknown)
            for (const Column& column : unknown->block.columns)
                if (fields.try_emplace(column.name, nullptr).second) others[column.name] = &column;
        Bits rows(live_.count());
        for (const std::uint32_t place : carriers.places) rows.set(place);
        make_room(carriers.places.size() * type.size);
        write_type_head(out_, type.name, rows, fields.size());
        const std::vector<std::uint32_t> new_row =
            others.empty() ? std::vector<std::uint32_t>{} : rows_among(unknown->block, carriers.places);
        for (const auto& [name, field] : fields) {
            if (field)
                write_field_column(out_, *field, carriers.components, scratch_);
            else
                write_column_for_rows(out_, *others[name], new_row, static_cast<std::uint32_t>(carriers.places.size()));
        }
    }

    /// Of a type that the registry does not know: the rows whose entities are still alive.
    void write_unknown(const TypeBlock& block) {
        Bits rows(live_.count());
        std::vector<std::uint32_t> places;
        for (SelectionCursor cursor(block.rows); !cursor.done(); cursor.next()) {
            const std::uint32_t place = place_of_former(cursor.at());
            if (place == LiveEntities::nowhere) continue;
            rows.set(place);
            places.push_back(place);
        }
        if (places.empty()) return;
        section(SnapshotSection::component, [&] {
            write_type_head(out_, block.name, rows, block.columns.size());
            const std::vector<std::uint32_t> new_row = rows_among(block, places);
            for (const Column& column : block.columns)
                write_column_for_rows(out_, column, new_row, static_cast<std::uint32_t>(places.size()));
        });
    }

    /// For each row of `block` the row that its entity has among `places`, which ascend.
    std::vector<std::uint32_t> rows_among(const TypeBlock& block, std::span<const std::uint32_t> places) const {
        std::vector<std::uint32_t> result;
        result.reserve(block.rows.count);
        for (SelectionCursor cursor(block.rows); !cursor.done(); cursor.next()) {
            const std::uint32_t place = place_of_former(cursor.at());
            const auto found = std::ranges::lower_bound(places, place);
            const bool there = place != LiveEntities::nowhere && found != places.end() && *found == place;
            result.push_back(there ? static_cast<std::uint32_t>(found - places.begin()) : no_new_row);
        }
        return result;
    }

    std::uint32_t place_of_former(std::uint32_t former) const {
        const Entity entity = former_->entities[former];
        return world_.alive(entity) ? live_.place[entity.index] : LiveEntities::nowhere;
    }

    /// So that a large type is not copied several times while the vector grows.
    void make_room(std::size_t bytes) {
        if (const std::size_t needed = bytes_.size() + bytes; needed > bytes_.capacity())
            bytes_.reserve(std::max(needed, 2 * bytes_.capacity()));
    }

    const World& world_;
    const TypeRegistry& types_;
    LiveEntities live_;
    const UnknownComponents* former_ = nullptr;
    std::map<std::string_view, Unknown> unknown_; ///< views of former_
    std::vector<std::byte> bytes_;
    ByteWriter out_{bytes_};
    std::vector<std::byte> scratch_;
};

} // namespace
} // namespace detail

std::vector<std::byte> save_snapshot(const World& world, const TypeRegistry& types) {
    return detail::SnapshotWriter(world, types).run();
}

} // namespace hachure
