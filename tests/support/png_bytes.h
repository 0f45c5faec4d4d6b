/// \file PNG files made in memory, uncompressed: 8 or 16 bits a channel, RGBA.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace lampyris::test {

namespace detail {

inline void putBigEndian(std::vector<uint8_t>& out, uint32_t word) {
    for (int shift = 24; shift >= 0; shift -= 8)
        out.push_back(static_cast<uint8_t>(word >> static_cast<unsigned>(shift)));
}

inline uint32_t crc32(const std::vector<uint8_t>& bytes, size_t from) {
    uint32_t crc = 0xffffffffu;
    for (size_t i = from; i < bytes.size(); ++i) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1u ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

inline void putChunk(std::vector<uint8_t>& out, std::string_view type,
                     const std::vector<uint8_t>& data) {
    putBigEndian(out, static_cast<uint32_t>(data.size()));
    const size_t from = out.size();
    out.insert(out.end(), type.begin(), type.end());
    out.insert(out.end(), data.begin(), data.end());
    putBigEndian(out, crc32(out, from));
}

/// zlib with one stored block.
inline std::vector<uint8_t> storedZlib(const std::vector<uint8_t>& raw) {
    const auto size = static_cast<uint16_t>(raw.size());
    std::vector<uint8_t> out = {0x78,
                                0x01,
                                1,
                                static_cast<uint8_t>(size & 255u),
                                static_cast<uint8_t>(size >> 8u),
                                static_cast<uint8_t>(~size & 255u),
                                static_cast<uint8_t>(static_cast<uint16_t>(~size) >> 8u)};
    out.insert(out.end(), raw.begin(), raw.end());
    uint32_t a = 1;
    uint32_t b = 0;
    for (const uint8_t byte : raw) {
        a = (a + byte) % 65521u;
        b = (b + a) % 65521u;
    }
    putBigEndian(out, b << 16u | a);
    return out;
}

}  // namespace detail

/// `samples` holds width · height · 4 values of `bits` bits, row by row; under 64 KiB in all.
inline std::vector<uint8_t> pngBytes(uint32_t width, uint32_t height,
                                     const std::vector<uint16_t>& samples, uint8_t bits = 8) {
    std::vector<uint8_t> file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    std::vector<uint8_t> header;
    detail::putBigEndian(header, width);
    detail::putBigEndian(header, height);
    header.insert(header.end(), {bits, 6, 0, 0, 0});
    detail::putChunk(file, "IHDR", header);
    std::vector<uint8_t> raw;
    for (size_t i = 0; i < samples.size(); ++i) {
        if (i % (size_t{width} * 4) == 0) raw.push_back(0);
        if (bits == 16) raw.push_back(static_cast<uint8_t>(samples[i] >> 8u));
        raw.push_back(static_cast<uint8_t>(samples[i]));
    }
    detail::putChunk(file, "IDAT", detail::storedZlib(raw));
    detail::putChunk(file, "IEND", {});
    return file;
}

}  // namespace lampyris::test
