#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hachure::bench {

/// Nanoseconds since it was made.
class Stopwatch {
public:
    [[nodiscard]] double ns() const {
        return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Makes the compiler believe that `value` and all memory are looked at here, so that it leaves out nothing.
template <class T> void keep(const T& value) { asm volatile("" : : "g"(&value) : "memory"); }

/// A benchmark checks that it has done the work that it times; throws Error saying what was not so.
void require(bool holds, const char* what);

/// One thing to time.
struct Case {
    std::string name;            ///< "GROUP: what"; no commas, for it becomes a cell of a CSV file
    std::function<double()> run; ///< prepares, does the work once, and returns what it took in `unit`
    std::string panel;           ///< of the chart; empty when it is in none
    std::optional<double> limit; ///< of the ratio to the group's raw floor
    std::string unit = "ns";     ///< "ns" is per entity
};

/// Cases that are timed in turn with one floor: the same on raw arrays, as fast as the machine does it.
struct Group {
    std::string floor_name;
    std::function<double()> floor; ///< as Case::run, in nanoseconds per entity; empty when the group has none
    std::vector<Case> cases;
};

/// How long to measure a group for: rounds until the minimum of them and the seconds are over, and no more than the
/// maximum. While a figure falls short it goes on for up to `patience` seconds in all: what others do on the machine
/// only ever adds time, and a core that is shared with another program keeps fewer fetches from memory on the way.
struct Effort {
    int min_rounds = 1;
    int max_rounds = 1;
    double seconds = 0.0;
    double patience = 0.0;
};

/// What a case took over all rounds. The best is what the machine can do, and what ratios are made of; the median is
/// what its noise made of it.
struct Result {
    std::string name, panel, unit;
    double best = 0.0;
    double median = 0.0;
    double floor = 0.0; ///< the best of the group's floor; 0 when it has none
    std::optional<double> limit;

    [[nodiscard]] double ratio() const { return best / floor; }
};

/// Times a group: in each round the floor and then every case once, so that the machine's noise meets all of them. The
/// floor is the first of the results, without a panel.
[[nodiscard]] std::vector<Result> measure(const Group& group, const Effort& effort);

} // namespace hachure::bench
