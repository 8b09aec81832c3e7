#pragma once

#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/error.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace hachure::assets {

/// Tests that write the files they read, in a folder of their own that goes with them.
class MeshFileTest : public testing::Test {
protected:
    MeshFileTest() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() / ("hachure_" + std::string(test->test_suite_name()) + "_" +
                                                            test->name() + "_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
    }
    ~MeshFileTest() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

    std::filesystem::path write(const std::string& name, std::string_view content) {
        const std::filesystem::path path = folder_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
        return path;
    }

    /// The message of the Error that a reader throws; it must name the file. Empty when it throws none.
    template <class Read> static std::string fault(Read read, const std::filesystem::path& file) {
        try {
            static_cast<void>(read(file));
        } catch (const Error& error) {
            const std::string message = error.what();
            EXPECT_TRUE(message.starts_with(file.string() + ": ")) << message;
            return message.substr(file.string().size() + 2);
        }
        return {};
    }

private:
    std::filesystem::path folder_;
};

/// The only primitive of a model that has one.
inline const Primitive& only(const Model& model) {
    EXPECT_EQ(model.meshes.size(), 1u);
    EXPECT_EQ(model.meshes.at(0).primitives.size(), 1u);
    return model.meshes.at(0).primitives.at(0);
}

/// Bytes of values one after the other, little or big endian.
class Bytes {
public:
    explicit Bytes(bool big_endian = false) : big_endian_(big_endian) {}
    template <class T> Bytes& add(T value) {
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof(T));
        if (big_endian_) std::reverse(raw, raw + sizeof(T));
        text_.append(raw, sizeof(T));
        return *this;
    }
    Bytes& text(std::string_view text) {
        text_ += text;
        return *this;
    }
    [[nodiscard]] const std::string& str() const { return text_; }

private:
    std::string text_;
    bool big_endian_;
};

} // namespace hachure::assets
