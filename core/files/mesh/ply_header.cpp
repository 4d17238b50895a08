#include "core/files/mesh/ply_header.h"

#include <algorithm>

#include "core/base/text.h"

namespace tactum {
namespace {

constexpr std::size_t kMaxProperties = 4096; // of all elements together

class HeaderReader {
public:
    explicit HeaderReader(const Source& source) : source_(source), lines_(source.bytes()) {}

    PlyHeader read() {
        std::string_view line;
        if (!lines_.next(line) || trimmed(line) != "ply")
            source_.failAtLine(1, "does not start with \"ply\"; it is no PLY file");
        bool hasFormat = false;
        while (lines_.next(line)) {
            Fields fields(line);
            const std::string_view word = fields.next();
            if (word == "end_header") return finish(hasFormat);
            if (word == "format")
                hasFormat = readFormat(fields);
            else if (word == "element")
                readElement(fields);
            else if (word == "property")
                readProperty(fields);
            else if (word != "comment" && word != "obj_info" && !word.empty())
                fail("unknown header word " + inQuotes(word) + "; re-export the file");
        }
        fail("the header has no end_header; the file was cut short, copy it again");
    }

private:
    PlyHeader finish(bool hasFormat);
    bool readFormat(Fields& fields);
    void readElement(Fields& fields);
    void readProperty(Fields& fields);
    PlyType type(std::string_view word) const;
    void demandEnoughBytes() const;
    [[noreturn]] void fail(const std::string& text) const { source_.failAtLine(lines_.number(), text); }

    const Source& source_;
    Lines lines_;
    PlyHeader header_;
    std::size_t properties_ = 0;
};

bool HeaderReader::readFormat(Fields& fields) {
    using Encoding = PlyHeader::Encoding;
    const std::string_view word = fields.next();
    if (word == "ascii")
        header_.encoding = Encoding::Ascii;
    else if (word == "binary_little_endian")
        header_.encoding = Encoding::LittleEndian;
    else if (word == "binary_big_endian")
        header_.encoding = Encoding::BigEndian;
    else
        fail("unknown format " + inQuotes(word) + "; export it as ascii or binary_little_endian");
    return true;
}

void HeaderReader::readElement(Fields& fields) {
    PlyElement element;
    element.name = fields.next();
    std::int64_t count = 0;
    const std::string_view word = fields.next();
    if (!parseNumber(word, count) || count < 0)
        fail("element needs a count where " + inQuotes(word) + " is; re-export the file");
    element.count = std::uint64_t(count);
    if (header_.elements.size() == kMaxProperties) fail("too many elements; re-export the file");
    // The vertices' values go into columns of one length, which a second list of them need not have.
    if (std::ranges::find(header_.elements, element.name, &PlyElement::name) != header_.elements.end())
        fail("a second element " + inQuotes(element.name) + "; re-export the file");
    header_.elements.push_back(std::move(element));
}

void HeaderReader::readProperty(Fields& fields) {
    if (header_.elements.empty()) fail("property before any element; re-export the file");
    if (++properties_ > kMaxProperties) fail("too many properties; re-export the file");
    PlyProperty property;
    std::string_view word = fields.next();
    if (word == "list") {
        property.countType = type(fields.next());
        if (!isInteger(*property.countType)) fail("list is counted by a fraction; re-export the file");
        word = fields.next();
    }
    property.type = type(word);
    property.name = fields.next();
    header_.elements.back().properties.push_back(std::move(property));
}

PlyType HeaderReader::type(std::string_view word) const {
    static constexpr std::pair<std::string_view, PlyType> kTypes[] = {
        {"char", PlyType::Int8},      {"int8", PlyType::Int8},       {"uchar", PlyType::Uint8},
        {"uint8", PlyType::Uint8},    {"short", PlyType::Int16},     {"int16", PlyType::Int16},
        {"ushort", PlyType::Uint16},  {"uint16", PlyType::Uint16},   {"int", PlyType::Int32},
        {"int32", PlyType::Int32},    {"uint", PlyType::Uint32},     {"uint32", PlyType::Uint32},
        {"float", PlyType::Float32},  {"float32", PlyType::Float32}, {"double", PlyType::Float64},
        {"float64", PlyType::Float64}};
    const auto* found = std::ranges::find(kTypes, word, &std::pair<std::string_view, PlyType>::first);
    if (found == std::end(kTypes) && header_.encoding == PlyHeader::Encoding::Ascii) return PlyType::Unknown;
    if (found == std::end(kTypes)) fail("unknown type " + inQuotes(word) + "; re-export the file");
    return found->second;
}

PlyHeader HeaderReader::finish(bool hasFormat) {
    if (!hasFormat) fail("the header names no format; re-export the file");
    header_.bodyOffset = lines_.offset();
    demandEnoughBytes();
    return std::move(header_);
}

/// Before anybody allocates by these counts.
void HeaderReader::demandEnoughBytes() const {
    const bool ascii = header_.encoding == PlyHeader::Encoding::Ascii;
    std::uint64_t left =
        source_.bytes().size() - header_.bodyOffset + (ascii ? 1 : 0); // no blank after the last
    for (const PlyElement& element : header_.elements) {
        const std::uint64_t size = element.leastSize(ascii);
        if (size > 0 && element.count > left / size)
            source_.fail("promises " + std::to_string(element.count) + " of \"" + printable(element.name) +
                         "\", but is too short for them; it was cut short, copy it again");
        left -= element.count * size;
    }
}

} // namespace

std::optional<std::size_t> PlyElement::find(std::initializer_list<std::string_view> names) const {
    for (std::string_view wanted : names)
        for (std::size_t i = 0; i < properties.size(); ++i)
            if (properties[i].name == wanted) return i;
    return std::nullopt;
}

std::uint64_t PlyElement::leastSize(bool ascii) const {
    std::uint64_t size = 0;
    for (const PlyProperty& property : properties)
        size += ascii ? 2 : sizeOf(property.countType.value_or(property.type)); // a digit and a blank
    return size;
}

PlyHeader readPlyHeader(const Source& source) {
    return HeaderReader(source).read();
}

} // namespace tactum
