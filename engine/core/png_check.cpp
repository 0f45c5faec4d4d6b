#include "core/png_check.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace lampyris::core {
namespace {

constexpr std::array<uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr size_t kAround = 12;  // bytes of a chunk beside its data: length, name, checksum

uint32_t bigEndian(std::span<const uint8_t> bytes) {
    return uint32_t{bytes[0]} << 24 | uint32_t{bytes[1]} << 16 | uint32_t{bytes[2]} << 8 |
           uint32_t{bytes[3]};
}

/// CRC-32 as PNG's annex D defines it.
uint32_t checksum(std::span<const uint8_t> bytes) {
    static const auto kTable = [] {
        std::array<uint32_t, 256> table{};
        for (uint32_t n = 0; n < table.size(); ++n) {
            table[n] = n;
            for (int bit = 0; bit < 8; ++bit)
                table[n] = (table[n] & 1u) != 0 ? 0xedb88320u ^ (table[n] >> 1) : table[n] >> 1;
        }
        return table;
    }();
    uint32_t sum = 0xffffffffu;
    for (const uint8_t byte : bytes) sum = kTable[(sum ^ byte) & 0xffu] ^ (sum >> 8);
    return ~sum;
}

}  // namespace

Result<void> checkPng(std::span<const uint8_t> bytes) {
    if (bytes.size() < kSignature.size() ||
        !std::equal(kSignature.begin(), kSignature.end(), bytes.begin()))
        return error("is no PNG file, or was cut off in its first bytes");
    for (auto rest = bytes.subspan(kSignature.size());;) {
        if (rest.size() < kAround || rest.size() - kAround < bigEndian(rest))
            return error("cut off after {} bytes", bytes.size());
        const size_t length = bigEndian(rest);
        const auto chunk = rest.subspan(4, 4 + length);
        const std::string_view name(reinterpret_cast<const char*>(chunk.data()), 4);
        if (checksum(chunk) != bigEndian(rest.subspan(8 + length)))
            return error("damaged: the checksum of a chunk at byte {} is wrong",
                         bytes.size() - rest.size());
        if (name == "IEND") return {};
        rest = rest.subspan(kAround + length);
    }
}

}  // namespace lampyris::core
