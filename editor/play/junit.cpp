#include <hachure/editor/play/junit.h>
#include <hachure/runtime/assets/atomic_file.h>

#include <fmt/format.h>

#include <algorithm>

namespace hachure::play {
namespace {

/// Text for an attribute or an element; characters that XML can't hold become '?'.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\n':
        case '\t':
            result += ' ';
            break;
        default:
            result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
        }
    }
    return result;
}

std::string case_xml(const std::string& suite, const std::string& name, const std::string& file,
                     std::string_view outcome, const std::string& reason) {
    const std::string head = fmt::format("    <testcase classname=\"{}\" name=\"{}\" file=\"{}\"", escaped(suite),
                                         escaped(name), escaped(file));
    if (outcome.empty()) return head + "/>\n";
    return head + fmt::format(">\n      <{} message=\"{}\"/>\n    </testcase>\n", outcome, escaped(reason));
}

std::string suite_xml(const PlayResult& result) {
    const std::string name = result.file.string();
    const auto failures = std::ranges::count(result.expectations, false, &ExpectationResult::passed);
    const int errors = result.error.empty() ? 0 : 1;
    std::string xml = fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n", escaped(name),
        result.expectations.size() + static_cast<std::size_t>(errors), failures, errors, result.seconds);
    for (const ExpectationResult& e : result.expectations)
        xml += case_xml(name, e.pointer + " " + e.what, name, e.passed ? "" : "failure", e.reason);
    if (errors > 0) xml += case_xml(name, "run", name, "error", result.error);
    return xml + "  </testsuite>\n";
}

} // namespace

std::string junit_xml(std::span<const PlayResult> results) {
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"hachure play\">\n";
    for (const PlayResult& result : results) xml += suite_xml(result);
    return xml + "</testsuites>\n";
}

void write_junit(const std::filesystem::path& file, std::span<const PlayResult> results) {
    const std::string text = junit_xml(results);
    assets::write_file_atomically(file, std::as_bytes(std::span(text.data(), text.size())));
}

} // namespace hachure::play
