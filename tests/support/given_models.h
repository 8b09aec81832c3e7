#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace hachure::test {

/// A test of one file in the folder that HACHURE_MODELS names, which the tests pass without.
class GivenModelTest : public ::testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        const char* folder = std::getenv("HACHURE_MODELS");
        if (!folder) GTEST_SKIP() << "HACHURE_MODELS names no folder of models";
        file_ = std::filesystem::path(folder) / GetParam();
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
