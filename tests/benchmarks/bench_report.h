#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::bench {

/// How a benchmark program was called: `[--quick] [--csv FILE] [MODEL]`.
struct Arguments {
    bool quick = false; ///< a small size, and no verdicts: the tests run it so that it can't rot
    std::filesystem::path csv;
    std::filesystem::path model; ///< empty for the benchmark's own
};

/// Reads the arguments; prints the usage and exits with 2 when they are wrong.
[[nodiscard]] Arguments parse_arguments(int argc, char** argv, std::string_view what_it_measures);

/// The rows of a benchmark: name, value, unit, limit, verdict.
class Report {
public:
    explicit Report(const Arguments& arguments) : arguments_(arguments) {}

    /// A figure without a limit.
    void add(std::string_view name, double value, std::string_view unit);

    /// A figure that must not exceed `limit`.
    void add_limited(std::string_view name, double value, std::string_view unit, double limit);

    /// Prints the table, writes the CSV file; the exit code: 1 when a figure falls short (never with --quick).
    [[nodiscard]] int finish() const;

private:
    struct Row {
        std::string name;
        double value;
        std::string unit;
        std::optional<double> limit;
    };

    Arguments arguments_;
    std::vector<Row> rows_;
};

/// The middle value; of an even number the mean of the two middle ones.
[[nodiscard]] double median(std::vector<double> values);

/// Milliseconds on a clock that never goes back.
[[nodiscard]] double now_ms();

} // namespace hachure::bench
