#include "tests/core/archive/raw_zip.h"

namespace tactum::test {

namespace {

struct Bytes {
    std::string text;
    Bytes& u16(std::uint32_t value) { return put(value, 2); }
    Bytes& u32(std::uint32_t value) { return put(value, 4); }
    Bytes& put(std::uint32_t value, int count) {
        for (int i = 0; i < count; ++i)
            text += char(value >> 8 * i);
        return *this;
    }
};

std::string local(const RawEntry& e) {
    const std::string& name = e.localName ? *e.localName : e.name;
    const auto packed = e.packedSize.value_or(std::uint32_t(e.packed.size()));
    const auto size = e.size.value_or(std::uint32_t(e.packed.size()));
    const bool isLeftOut = !e.descriptor.empty();
    Bytes out;
    out.u32(0x04034b50).u16(20).u16(e.flags).u16(e.localMethod.value_or(e.method)).u16(0).u16(33);
    out.u32(isLeftOut ? 0 : e.crc.value_or(crc32(e.packed))).u32(isLeftOut ? 0 : packed);
    out.u32(isLeftOut ? 0 : e.localSize.value_or(size));
    out.u16(std::uint32_t(name.size())).u16(std::uint32_t(e.localExtra.size()));
    return out.text + name + e.localExtra + e.packed + e.descriptor;
}

std::string central(const RawEntry& e, std::size_t begin) {
    Bytes out;
    out.u32(0x02014b50).u16(3 << 8 | 20).u16(20).u16(e.flags).u16(e.method).u16(0).u16(33);
    out.u32(e.crc.value_or(crc32(e.packed))).u32(e.packedSize.value_or(std::uint32_t(e.packed.size())));
    out.u32(e.size.value_or(std::uint32_t(e.packed.size())));
    out.u16(std::uint32_t(e.name.size())).u16(std::uint32_t(e.extra.size())).u16(0).u16(e.disk).u16(0);
    out.u32(e.attributes).u32(e.begin.value_or(std::uint32_t(begin)));
    return out.text + e.name + e.extra;
}

/// Lowest bit first, as deflate has them; codes of Huffman highest first.
struct Bits {
    std::string text;
    int used = 8;
    void bit(unsigned value) {
        if (used == 8) text += '\0', used = 0;
        text.back() = char(std::uint8_t(text.back()) | (value & 1) << used++);
    }
    void code(unsigned value, int count) {
        while (count-- > 0)
            bit(value >> count);
    }
};

} // namespace

std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t crc = ~0u;
    for (const char byte : bytes) {
        crc ^= std::uint8_t(byte);
        for (int i = 0; i < 8; ++i)
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

std::string rawZip(const std::vector<RawEntry>& entries, const RawEnd& end) {
    std::string files, directory;
    for (const RawEntry& entry : entries) {
        directory += central(entry, files.size());
        files += local(entry);
    }
    const auto count = end.entries.value_or(std::uint16_t(entries.size()));
    Bytes last;
    last.u32(0x06054b50).u16(end.disk).u16(end.disk).u16(count).u16(count);
    last.u32(end.size.value_or(std::uint32_t(directory.size())));
    last.u32(end.begin.value_or(std::uint32_t(files.size()))).u16(end.commentBytes);
    return files + directory + end.before + last.text + end.after;
}

std::string deflatedZeros(std::size_t count) {
    Bits out;
    out.bit(1);             // the last block
    out.bit(1), out.bit(0); // of fixed codes
    out.code(0x30, 8);      // a zero
    for (std::size_t done = 1; done < count; done += 258) {
        out.code(0xc5, 8); // 258 bytes again
        out.code(0, 5);    // from one byte before
    }
    out.code(0, 7); // the end
    return out.text;
}

} // namespace tactum::test
