#pragma once

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace hachure::test {

/// A picture in closed form, so that it can be moved exactly: waves of all directions, of lengths from 6 to 200 pixels.
class WavePicture {
public:
    WavePicture() {
        std::mt19937 random(5);
        const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
        for (int i = 0; i < 80; ++i) {
            const double length = 6.0 * std::pow(200.0 / 6.0, unit()), angle = glm::two_pi<double>() * unit();
            const double frequency = glm::two_pi<double>() / length;
            waves_.push_back({frequency * std::cos(angle), frequency * std::sin(angle), glm::two_pi<double>() * unit(),
                              0.05 * std::sqrt(length / 200.0)});
        }
    }

    [[nodiscard]] double tone(glm::dvec2 p) const {
        double sum = 0.5;
        for (const Wave& wave : waves_) sum += wave.amplitude * std::cos(wave.x * p.x + wave.y * p.y + wave.phase);
        return sum;
    }

private:
    struct Wave {
        double x, y, phase, amplitude;
    };
    std::vector<Wave> waves_;
};

/// Where what a place shows now was before.
using Origin = std::function<glm::dvec2(glm::dvec2)>;

inline Origin shifted(double x, double y) {
    return [=](glm::dvec2 p) { return p - glm::dvec2(x, y); };
}

/// Turned and enlarged about a place.
inline Origin turned_about(glm::dvec2 middle, double degrees, double times) {
    return [=](glm::dvec2 p) {
        const glm::dvec2 d = (p - middle) / times;
        const double a = -glm::radians(degrees);
        return middle + glm::dvec2(std::cos(a) * d.x - std::sin(a) * d.y, std::sin(a) * d.x + std::cos(a) * d.y);
    };
}

} // namespace hachure::test
