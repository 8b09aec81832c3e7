#pragma once

#include <gtest/gtest.h>
#include <OpenImageIO/imageio.h>

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace hachure::test {

/// A part of an EXR that a test writes, as another renderer would.
struct ExrPart {
    std::vector<std::string> channels;
    std::vector<float> values;             ///< of the data window: rows from the top, channels side by side
    int width = 0, height = 0;             ///< of the data window
    std::string name;                      ///< of the part
    int x = 0, y = 0;                      ///< of the data window, in the display window
    int full_width = 0, full_height = 0;   ///< of the display window; 0: the data window's
    std::vector<OIIO::TypeDesc> types;     ///< of the channels; empty: float
    int tile = 0;                          ///< side of tiles; 0: scanlines
    std::string compression = "zip", view; ///< view: of a stereo file
};

inline OIIO::ImageSpec exr_spec(const ExrPart& part) {
    OIIO::ImageSpec spec(part.width, part.height, static_cast<int>(part.channels.size()), OIIO::TypeDesc::FLOAT);
    spec.channelnames = part.channels;
    spec.channelformats = part.types;
    spec.x = part.x;
    spec.y = part.y;
    spec.full_width = part.full_width > 0 ? part.full_width : part.width;
    spec.full_height = part.full_height > 0 ? part.full_height : part.height;
    spec.tile_width = spec.tile_height = part.tile;
    spec.attribute("compression", part.compression);
    if (!part.name.empty()) spec.attribute("oiio:subimagename", part.name);
    if (!part.view.empty()) spec.attribute("view", part.view);
    return spec;
}

/// The values as the file's types have them, pixel by pixel; unsigned integers as they are.
inline std::vector<std::byte> native_pixels(const ExrPart& part, const OIIO::ImageSpec& spec) {
    std::vector<std::byte> bytes;
    for (std::size_t i = 0; i < part.values.size(); ++i) {
        const OIIO::TypeDesc type = spec.channelformat(static_cast<int>(i % part.channels.size()));
        std::byte value[4];
        const auto whole = static_cast<std::uint32_t>(part.values[i] > 0.0f ? part.values[i] : 0.0f);
        if (type == OIIO::TypeDesc::UINT32)
            std::memcpy(value, &whole, 4);
        else
            OIIO::convert_types(OIIO::TypeDesc::FLOAT, &part.values[i], type, value, 1);
        bytes.insert(bytes.end(), value, value + type.size());
    }
    return bytes;
}

/// Writes the parts; more than one make a multi-part file.
inline void write_exr_parts(const std::filesystem::path& file, const std::vector<ExrPart>& parts) {
    const auto output = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(output);
    std::vector<OIIO::ImageSpec> specs;
    for (const ExrPart& part : parts) {
        ASSERT_EQ(part.values.size(), part.channels.size() * std::size_t(part.width) * std::size_t(part.height));
        specs.push_back(exr_spec(part));
    }
    ASSERT_TRUE(output->open(file.string(), static_cast<int>(specs.size()), specs.data())) << output->geterror();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i > 0) {
            ASSERT_TRUE(output->open(file.string(), specs[i], OIIO::ImageOutput::AppendSubimage)) << output->geterror();
        }
        const std::vector<std::byte> pixels = native_pixels(parts[i], specs[i]);
        const OIIO::TypeDesc type = specs[i].channelformats.empty() ? specs[i].format : OIIO::TypeDesc::UNKNOWN;
        ASSERT_TRUE(output->write_image(type, pixels.data())) << output->geterror();
    }
    ASSERT_TRUE(output->close()) << output->geterror();
}

} // namespace hachure::test
