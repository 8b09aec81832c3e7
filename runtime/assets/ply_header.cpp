#include <hachure/runtime/assets/ply_header.h>
#include <hachure/runtime/assets/text_scanner.h>

#include <optional>
#include <utility>

namespace hachure::assets {
namespace {

std::optional<PlyType> ply_type(std::string_view name) {
    static constexpr std::pair<std::string_view, PlyType> names[] = {
        {"char", PlyType::i8},   {"int8", PlyType::i8},     {"uchar", PlyType::u8},   {"uint8", PlyType::u8},
        {"short", PlyType::i16}, {"int16", PlyType::i16},   {"ushort", PlyType::u16}, {"uint16", PlyType::u16},
        {"int", PlyType::i32},   {"int32", PlyType::i32},   {"uint", PlyType::u32},   {"uint32", PlyType::u32},
        {"float", PlyType::f32}, {"float32", PlyType::f32}, {"double", PlyType::f64}, {"float64", PlyType::f64}};
    for (const auto& [known, type] : names)
        if (known == name) return type;
    return std::nullopt;
}

class HeaderParser {
public:
    HeaderParser(const std::filesystem::path& file, std::string_view text) : scan_(file, text), size_(text.size()) {}

    PlyHeader run() {
        if (word() != "ply") scan_.fail("not a PLY file: it does not start with \"ply\"");
        next_line();
        format();
        while (!statement()) next_line();
        scan_.skip_line();
        header_.body = scan_.offset();
        for (const PlyElement& element : header_.elements) check_size(element);
        return std::move(header_);
    }

private:
    std::string_view word() {
        scan_.skip_blanks();
        return scan_.word();
    }

    void next_line() {
        scan_.skip_line();
        if (scan_.at_end()) scan_.fail("the header does not end");
    }

    void format() {
        for (;;) {
            const std::string_view name = word();
            if (name == "format") break;
            if (name != "comment" && name != "obj_info") scan_.fail("expected the format");
            next_line();
        }
        const std::string_view name = word();
        if (name == "binary_little_endian")
            header_.format = PlyFormat::little_endian;
        else if (name == "binary_big_endian")
            header_.format = PlyFormat::big_endian;
        else if (name != "ascii")
            scan_.fail("unknown PLY format");
        if (word() != "1.0") scan_.fail("unknown PLY version");
        next_line();
    }

    /// True at the end of the header.
    bool statement() {
        const std::string_view name = word();
        if (name == "end_header") return true;
        if (name == "element")
            element();
        else if (name == "property")
            property();
        else if (!name.empty() && name != "comment" && name != "obj_info")
            scan_.fail("unknown statement in the header");
        return false;
    }

    void element() {
        PlyElement element;
        element.name = word();
        scan_.skip_blanks();
        std::int64_t count = 0;
        if (element.name.empty() || !scan_.read(count) || !scan_.at_word_end() || count < 0)
            scan_.fail("expected the name and the count of an element");
        element.count = static_cast<std::uint64_t>(count);
        header_.elements.push_back(std::move(element));
    }

    PlyType type() {
        const auto known = ply_type(word());
        if (!known) scan_.fail("unknown type of a property");
        return *known;
    }

    void property() {
        if (header_.elements.empty()) scan_.fail("a property before the first element");
        PlyProperty property;
        scan_.skip_blanks();
        const std::size_t start = scan_.offset();
        property.is_list = word() == "list";
        if (property.is_list)
            property.count_type = type();
        else
            scan_.rewind(start);
        property.type = type();
        property.name = word();
        if (property.name.empty()) scan_.fail("a property without a name");
        if (property.is_list && property.count_type >= PlyType::f32)
            scan_.fail("the count of a list must be an integer");
        header_.elements.back().properties.push_back(std::move(property));
    }

    /// A row takes a byte and a separator for each ascii value, or its sizes in binary; lists may be empty.
    void check_size(const PlyElement& element) {
        std::uint64_t row = 0;
        for (const PlyProperty& p : element.properties)
            row += header_.format == PlyFormat::ascii ? 2 : ply_size(p.is_list ? p.count_type : p.type);
        const std::uint64_t left = size_ - header_.body + 1; // the last separator may be missing
        if (row > 0 && element.count > left / row)
            scan_.fail("truncated: the header claims " + std::to_string(element.count) + " of " + element.name +
                       ", more than the file can hold");
    }

    TextScanner scan_;
    std::size_t size_;
    PlyHeader header_;
};

} // namespace

std::size_t ply_size(PlyType type) {
    static constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

PlyHeader parse_ply_header(const std::filesystem::path& file, std::string_view text) {
    return HeaderParser(file, text).run();
}

} // namespace hachure::assets
