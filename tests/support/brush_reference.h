#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace hachure::test {

/// The ripple of figure 2, h(r) = cos r / (1 + r / 5), with its derivatives and integrals in closed form or double
/// precision, and the circles on which features of its reliefs are. Nothing here is shared with what is tested.
namespace ripple {

inline double h(double r) { return std::cos(r) / (1.0 + 0.2 * r); }

/// By the product rule: with q = 1 / (1 + r/5), q' = -q^2 / 5.
inline double derivative(int order, double r) {
    const double q = 1.0 / (1.0 + 0.2 * r);
    double sum = 0.0, q_part = q, choose = 1.0; // the i-th derivative of q
    for (int i = 0; i <= order; ++i) {
        const double phase = 1.5707963267948966 * (order - i);
        sum += choose * q_part * std::cos(r + phase);
        q_part *= -0.2 * (i + 1) * q;
        choose *= double(order - i) / double(i + 1);
    }
    return sum;
}

/// The integral of h from 0: Simpson's rule on a fine grid.
class Integral {
public:
    explicit Integral(double to) {
        for (double r = 0.0; r < to + step; r += step) table_.push_back(table_.empty() ? 0.0 : next());
    }

    [[nodiscard]] double once(double r) const {
        const auto i = static_cast<std::size_t>(r / step);
        const double from = static_cast<double>(i) * step;
        return table_.at(i) + simpson(from, r);
    }

private:
    static constexpr double step = 0.02;
    static double simpson(double a, double b) { return (b - a) / 6.0 * (h(a) + 4.0 * h(0.5 * (a + b)) + h(b)); }
    [[nodiscard]] double next() const {
        const double from = step * static_cast<double>(table_.size() - 1);
        return table_.back() + simpson(from, from + step);
    }

    std::vector<double> table_;
};

} // namespace ripple

/// Where a function of the radius has its maxima between `from` and `to`: by sign changes of its slope, refined.
inline std::vector<double> maxima(const std::function<double(double)>& f, double from, double to) {
    std::vector<double> found;
    constexpr double step = 1e-2, tiny = 1e-4;
    const auto slope = [&](double r) { return f(r + tiny) - f(r - tiny); };
    for (double r = from; r + step < to; r += step) {
        if (!(slope(r) > 0.0 && slope(r + step) <= 0.0)) continue;
        double low = r, high = r + step;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (low + high);
            (slope(middle) > 0.0 ? low : high) = middle;
        }
        found.push_back(0.5 * (low + high));
    }
    return found;
}

} // namespace hachure::test
