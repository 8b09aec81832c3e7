#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// Real models, which tests pass without.
namespace hachure::test {

/// The folder that HACHURE_MODELS names; empty when it names none.
inline std::filesystem::path given_models() {
    const char* folder = std::getenv("HACHURE_MODELS");
    return folder ? folder : "";
}

/// What a test says that is skipped without them.
inline constexpr std::string_view no_given_models = "HACHURE_MODELS names no folder of models";

/// The glTF files below one of its folders, sorted; none when it is not there.
inline std::vector<std::filesystem::path> given_gltf_files(const std::string& below) {
    std::vector<std::filesystem::path> files;
    const std::filesystem::path folder = given_models() / below;
    if (given_models().empty() || !std::filesystem::is_directory(folder)) return files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".glb" || entry.path().extension() == ".gltf") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// A test of one file in that folder.
class GivenModelTest : public ::testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (given_models().empty()) GTEST_SKIP() << no_given_models;
        file_ = given_models() / GetParam();
        if (!std::filesystem::exists(file_)) GTEST_SKIP() << file_ << " is not there";
    }

    const std::filesystem::path& file() const { return file_; }

private:
    std::filesystem::path file_;
};

/// The file's name as the name of a test.
inline std::string given_model_name(const ::testing::TestParamInfo<const char*>& given) {
    std::string name = std::filesystem::path(given.param).stem().string();
    std::ranges::replace_if(
        name, [](unsigned char c) { return !std::isalnum(c); }, '_');
    return name;
}

} // namespace hachure::test
