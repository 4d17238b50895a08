#include "core/files/source.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "core/base/text.h"

namespace tactum {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void tooLarge(const fs::path& file, std::uint64_t size, std::uint64_t limit) {
    throw ReadFault{{Error::Kind::Input, shownPath(file) + ": has " + std::to_string(size) +
                                             " bytes, more than the " + std::to_string(limit) +
                                             " that are read; split it"}};
}

std::uint64_t sizeOfRegular(const fs::path& file, std::uint64_t limit) {
    std::error_code fault;
    const fs::file_status status = fs::status(file, fault);
    if (status.type() == fs::file_type::not_found)
        throw ReadFault{{Error::Kind::Input, shownPath(file) + ": no such file; check the path"}};
    if (status.type() == fs::file_type::directory)
        throw ReadFault{{Error::Kind::Input, shownPath(file) + ": is a folder; name a file in it"}};
    if (status.type() != fs::file_type::regular)
        throw ReadFault{{Error::Kind::Input,
                         shownPath(file) + ": cannot be read as a file; check the path and its rights"}};
    const std::uint64_t size = fs::file_size(file, fault);
    if (fault) throw ReadFault{{Error::Kind::Machine, shownPath(file) + ": " + fault.message()}};
    if (size == 0) throw ReadFault{{Error::Kind::Input, shownPath(file) + ": is empty; export it again"}};
    if (size > limit) tooLarge(file, size, limit);
    return size;
}

using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Stream openStream(const fs::path& file) {
    Stream stream(std::fopen(file.c_str(), "rb"), &std::fclose);
    if (!stream)
        throw ReadFault{{Error::Kind::Input, shownPath(file) + ": cannot be opened (" +
                                                 std::generic_category().message(errno) +
                                                 "); check its rights"}};
    std::setvbuf(stream.get(), nullptr, _IONBF, 0);
    return stream;
}

bool isPipe(const fs::path& file) {
    std::error_code fault;
    const fs::file_type type = fs::status(file, fault).type();
    return type == fs::file_type::fifo || type == fs::file_type::socket;
}

} // namespace

std::string shownPath(const fs::path& file) {
    return printable(file.string(), 400);
}

Source::Source(const fs::path& file) : path_(file), name_(shownPath(file)) {}

Source Source::ofBytes(const fs::path& name, std::string_view bytes) {
    Source source(name);
    source.size_ = bytes.size();
    source.data_ = std::make_unique_for_overwrite<char[]>(bytes.size());
    std::ranges::copy(bytes, source.data_.get());
    return source;
}

Source Source::openFileOrPipe(const fs::path& file, std::uint64_t limit) {
    if (!isPipe(file)) return open(file, limit);
    const Stream stream = openStream(file);
    std::string bytes;
    std::array<char, 1 << 16> block;
    while (const std::size_t got = std::fread(block.data(), 1, block.size(), stream.get())) {
        bytes.append(block.data(), got);
        if (bytes.size() > limit) tooLarge(file, bytes.size(), limit);
    }
    if (bytes.empty())
        throw ReadFault{{Error::Kind::Input, shownPath(file) + ": nothing came through the pipe"}};
    return ofBytes(file, bytes);
}

Source Source::open(const fs::path& file, std::uint64_t limit, const Progress& progress) {
    Source source(file);
    source.size_ = sizeOfRegular(file, limit);
    const Stream stream = openStream(file);
    source.data_ = std::make_unique_for_overwrite<char[]>(source.size_);
    constexpr std::size_t kBlock = 8 << 20;
    ProgressMeter meter(progress, source.size_, kBlock);
    for (std::size_t at = 0; at < source.size_;) {
        const std::size_t wanted = std::min(kBlock, source.size_ - at);
        const std::size_t got = std::fread(source.data_.get() + at, 1, wanted, stream.get());
        if (got == 0)
            throw ReadFault{{Error::Kind::Machine, shownPath(file) + ": stopped being readable; try again"}};
        demandGoingOn(meter, at += got);
    }
    return source;
}

void Source::fail(const std::string& text) const {
    throw ReadFault{{Error::Kind::Input, name_ + ": " + text}};
}

void Source::failAtLine(std::size_t line, const std::string& text) const {
    throw ReadFault{{Error::Kind::Input, name_ + ":" + std::to_string(line) + ": " + text}};
}

void Source::failAtByte(std::size_t byte, const std::string& text) const {
    throw ReadFault{{Error::Kind::Input, name_ + ": byte " + std::to_string(byte) + ": " + text}};
}

std::size_t Source::lineAt(const char* place) const {
    return 1 + std::size_t(std::count(bytes().data(), std::min(place, bytes().data() + size_), '\n'));
}

void demandGoingOn(ProgressMeter& meter, std::size_t done) {
    if (!meter.goesOn(done)) throw ReadFault{cancelledError().value()};
}

fs::path insideFolder(const fs::path& folder, const std::string& reference) {
    std::error_code fault;
    if (reference.find('\0') != std::string::npos || fs::path(reference).is_absolute()) return {};
    const fs::path home = fs::canonical(folder.empty() ? "." : folder, fault);
    if (fault) return {};
    const fs::path file = fs::canonical(home / reference, fault);
    if (fault || !fs::is_regular_file(file, fault)) return {};
    const auto [end, rest] = std::mismatch(home.begin(), home.end(), file.begin(), file.end());
    return end == home.end() ? file : fs::path();
}

} // namespace tactum
