#include <hachure/editor/play/play_result_json.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace hachure::play {
namespace {

using nlohmann::json;

json real_json(double value) {
    if (std::isnan(value)) return nullptr;
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    return value;
}

double real_from(const json& value) {
    if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
    if (value.is_string()) return (value == "inf" ? 1.0 : -1.0) * std::numeric_limits<double>::infinity();
    return value.get<double>();
}

json optional_json(const std::optional<double>& value) {
    return value ? json::array({real_json(*value)}) : json::array();
}

std::optional<double> optional_from(const json& value) {
    if (value.empty()) return std::nullopt;
    return real_from(value.at(0));
}

json curve_json(const Curve& curve) {
    json values = json::array();
    for (const double value : curve.values) values.push_back(real_json(value));
    return {{"name", curve.name},
            {"unit", curve.unit},
            {"first_frame", curve.first_frame},
            {"values", std::move(values)},
            {"at_least", optional_json(curve.at_least)},
            {"at_most", optional_json(curve.at_most)}};
}

Curve curve_from(const json& value) {
    Curve curve{value.at("name"),
                value.at("unit"),
                value.at("first_frame"),
                {},
                optional_from(value.at("at_least")),
                optional_from(value.at("at_most"))};
    for (const json& v : value.at("values")) curve.values.push_back(real_from(v));
    return curve;
}

json evidence_json(const PictureEvidence& e) {
    return {{"golden", e.golden.string()},
            {"actual", e.actual.string()},
            {"difference", e.difference.string()},
            {"max_difference", real_json(e.max_difference)},
            {"differing_share", real_json(e.differing_share)},
            {"flip_p99", real_json(e.flip_p99)},
            {"flip_max", real_json(e.flip_max)},
            {"line_distance", real_json(e.line_distance)}};
}

PictureEvidence evidence_from(const json& value) {
    const auto path = [&](const char* key) { return std::filesystem::path(value.at(key).get<std::string>()); };
    return {path("golden"),
            path("actual"),
            path("difference"),
            real_from(value.at("max_difference")),
            real_from(value.at("differing_share")),
            real_from(value.at("flip_p99")),
            real_from(value.at("flip_max")),
            real_from(value.at("line_distance"))};
}

json expectation_json(const ExpectationResult& e) {
    json result{{"kind", e.kind},
                {"what", e.what},
                {"pointer", e.pointer},
                {"passed", e.passed},
                {"renewed", e.renewed},
                {"reason", e.reason},
                {"first_frame", e.first_frame},
                {"last_frame", e.last_frame},
                {"curves", json::array()},
                {"frames", json::array()}};
    if (e.picture) result["picture"] = evidence_json(*e.picture);
    for (const Curve& curve : e.curves) result["curves"].push_back(curve_json(curve));
    for (const std::filesystem::path& frame : e.frames) result["frames"].push_back(frame.string());
    return result;
}

ExpectationResult expectation_from(const json& value) {
    ExpectationResult e;
    e.kind = value.at("kind");
    e.what = value.at("what");
    e.pointer = value.at("pointer");
    e.passed = value.at("passed");
    e.renewed = value.at("renewed");
    e.reason = value.at("reason");
    e.first_frame = value.at("first_frame");
    e.last_frame = value.at("last_frame");
    if (value.contains("picture")) e.picture = evidence_from(value.at("picture"));
    for (const json& curve : value.at("curves")) e.curves.push_back(curve_from(curve));
    for (const json& frame : value.at("frames")) e.frames.emplace_back(frame.get<std::string>());
    return e;
}

} // namespace

json to_json(const PlayResult& r) {
    json result{{"file", r.file.string()},
                {"doc", r.doc},
                {"passed", r.passed},
                {"error", r.error},
                {"seconds", real_json(r.seconds)},
                {"frames", r.frames},
                {"width", r.width},
                {"height", r.height},
                {"renderer", r.renderer},
                {"log", r.log},
                {"expectations", json::array()},
                {"passes", json::array()},
                {"strip", json::array()},
                {"curves", json::array()},
                {"replay", r.replay}};
    for (const ExpectationResult& e : r.expectations) result["expectations"].push_back(expectation_json(e));
    for (const PassSummary& p : r.passes)
        result["passes"].push_back({{"name", p.name},
                                    {"run", p.run},
                                    {"reused", p.reused},
                                    {"culled", p.culled},
                                    {"cpu_ms", real_json(p.cpu_ms)},
                                    {"gpu_ms", real_json(p.gpu_ms)}});
    for (const StripFrame& s : r.strip)
        result["strip"].push_back({{"frame", s.frame}, {"picture", s.picture.string()}});
    for (const Curve& curve : r.curves) result["curves"].push_back(curve_json(curve));
    return result;
}

PlayResult result_from_json(const json& value) {
    PlayResult r;
    r.file = value.at("file").get<std::string>();
    r.doc = value.at("doc");
    r.passed = value.at("passed");
    r.error = value.at("error");
    r.seconds = real_from(value.at("seconds"));
    r.frames = value.at("frames");
    r.width = value.at("width");
    r.height = value.at("height");
    r.renderer = value.at("renderer");
    r.log = value.at("log").get<std::vector<std::string>>();
    for (const json& e : value.at("expectations")) r.expectations.push_back(expectation_from(e));
    for (const json& p : value.at("passes"))
        r.passes.push_back({p.at("name"), p.at("run"), p.at("reused"), p.at("culled"), real_from(p.at("cpu_ms")),
                            real_from(p.at("gpu_ms"))});
    for (const json& s : value.at("strip")) r.strip.push_back({s.at("frame"), s.at("picture").get<std::string>()});
    for (const json& curve : value.at("curves")) r.curves.push_back(curve_from(curve));
    r.replay = value.at("replay");
    return r;
}

} // namespace hachure::play
