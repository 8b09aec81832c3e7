#include <hachure/runtime/ecs/snapshot.h>
#include <hachure/runtime/ecs/snapshot/snapshot_column.h>
#include <hachure/runtime/ecs/snapshot/snapshot_field.h>
#include <hachure/runtime/ecs/snapshot/snapshot_fill.h>
#include <hachure/runtime/ecs/snapshot/snapshot_format.h>
#include <hachure/runtime/ecs/snapshot/snapshot_live.h>
#include <hachure/runtime/ecs/snapshot/snapshot_tree.h>

#include <zlib.h>

#include <algorithm>
#include <set>

namespace hachure {
namespace detail {
namespace {

/// Components of a known type, ready to be added.
struct KnownType {
    const TypeInfo* type;
    std::vector<Entity> rows;
    std::vector<FieldColumn> columns;
};

/// The frame: throws Error unless it is whole, unaltered and of this version; returns the sections.
Bytes open_frame(Bytes snapshot, std::string_view subject) {
    ByteReader head(snapshot, subject);
    const std::size_t frame = snapshot_head_bytes + snapshot_checksum_bytes;
    if (snapshot.size() < snapshot_magic.size() ||
        !std::ranges::equal(head.take(snapshot_magic.size()), std::as_bytes(std::span(snapshot_magic))))
        throw Error(subject, "is no snapshot");
    if (snapshot.size() < frame) throw Error(subject, "is truncated");
    if (const auto version = head.number<std::uint32_t>(); version != snapshot_version)
        throw Error(subject, "is a snapshot of version " + std::to_string(version) + ", which is not known");
    const auto length = head.number<std::uint64_t>();
    if (length > snapshot.size()) throw Error(subject, "is truncated");
    const Bytes summed = snapshot.first(snapshot.size() - snapshot_checksum_bytes);
    ByteReader tail(snapshot.last(snapshot_checksum_bytes), subject);
    const auto* begin = reinterpret_cast<const Bytef*>(summed.data());
    if (length != snapshot.size() || tail.number<std::uint32_t>() != ::crc32_z(0, begin, summed.size()))
        throw Error(subject, "has been altered: its checksum does not fit");
    return summed.subspan(snapshot_head_bytes);
}

/// All of a snapshot, checked, before anything happens to a world.
class SnapshotReader {
public:
    SnapshotReader(const TypeRegistry& types, Bytes snapshot, std::string_view subject)
        : types_(types), in_(open_frame(snapshot, subject), subject, snapshot_head_bytes), live_(read_entities()),
          links_(read_links()) {
        unknown_.entities = live_.entities;
        std::set<std::string, std::less<>> names;
        while (in_.left() > 0) {
            ByteReader in = section(SnapshotSection::component);
            const std::size_t all = in.left();
            const TypeBlock block = read_type_block(in, live_.count());
            if (!names.emplace(block.name).second) in.fail("has a component type twice");
            if (names.size() > max_snapshot_types) in.fail("has too many component types");
            keep(block, in.taken_since(all));
        }
    }

    void commit(World& world) && {
        world.restore_entities(live_.ids);
        for (const auto [child, parent] : links_) world.set_parent(live_.entities[child], live_.entities[parent]);
        for (const KnownType& known : known_) add_components(world, *known.type, known.rows, known.columns);
        world.remove_resource<UnknownComponents>();
        if (!unknown_.types.empty() || !unknown_.fields.empty()) world.set_resource(std::move(unknown_));
    }

private:
    ByteReader section(SnapshotSection tag) {
        if (in_.number<SnapshotSection>() != tag) in_.fail("has a section that is not expected here");
        const auto length = in_.number<std::uint64_t>();
        const std::size_t offset = in_.offset();
        return {in_.take(length), in_.subject(), offset};
    }

    LiveEntities read_entities() {
        ByteReader in = section(SnapshotSection::entities);
        return LiveEntities(in);
    }

    std::vector<TreeLink> read_links() {
        ByteReader in = section(SnapshotSection::tree);
        return read_tree(in, live_.count());
    }

    void keep(const TypeBlock& block, Bytes raw) {
        const TypeInfo* type = types_.find(block.name);
        if (!type) {
            unknown_.types.emplace_back(raw.begin(), raw.end());
            return;
        }
        KnownType& known = known_.emplace_back(KnownType{type, {}, {}});
        known.rows.reserve(block.rows.count);
        for (SelectionCursor cursor(block.rows); !cursor.done(); cursor.next())
            known.rows.push_back(live_.entities[cursor.at()]);
        std::vector<const Column*> others;
        for (const Column& column : block.columns) {
            if (const FieldInfo* field = type->field(column.name))
                known.columns.push_back(match_field(column, *field, in_.subject(), arena_));
            else
                others.push_back(&column);
        }
        if (!others.empty()) keep_fields(block, others);
    }

    /// The block again, with nothing but the fields that its type does not have.
    void keep_fields(const TypeBlock& block, std::span<const Column* const> columns) {
        Bits rows(live_.count());
        for (SelectionCursor cursor(block.rows); !cursor.done(); cursor.next()) rows.set(cursor.at());
        ByteWriter out(unknown_.fields.emplace_back());
        write_type_head(out, block.name, rows, columns.size());
        for (const Column* column : columns) out.bytes(column->raw);
    }

    const TypeRegistry& types_;
    ByteReader in_;
    LiveEntities live_;
    std::vector<TreeLink> links_;
    std::vector<KnownType> known_;
    ColumnArena arena_;
    UnknownComponents unknown_;
};

} // namespace
} // namespace detail

void restore_snapshot(World& world, const TypeRegistry& types, std::span<const std::byte> snapshot,
                      std::string_view subject) {
    detail::SnapshotReader(types, snapshot, subject).commit(world);
}

} // namespace hachure
