// The import process: reads one file behind bars and hands the scene over.
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <sys/prctl.h>
#include <unistd.h>

#include "core/import/scene_transfer.h"
#include "core/import/wire.h"
#include "core/import/worker/sandbox.h"

namespace tactum {
namespace {

using wire::Word;

void say(Word word, std::string_view what) {
    std::string packet(1, char(word));
    packet += what.substr(0, wire::kLongest - 1);
    // Nobody there any more: nothing to do here either.
    if (write(wire::kTalk, packet.data(), packet.size()) < 0) _exit(1);
}

template <class T> void sayNumber(Word word, T number) {
    say(word, {reinterpret_cast<const char*>(&number), sizeof number});
}

void sayFault(const Error& error) {
    say(Word::Fault, std::string(1, char(error.kind)) + error.text);
}

/// Into the memory that the program has given us; what is small is gathered first.
class SceneMemory final : public ByteOut {
public:
    void append(const void* from, std::size_t count) override {
        const char* bytes = static_cast<const char*>(from);
        if (count < kBlock)
            gathered_.append(bytes, count);
        else
            flush(), put(bytes, count);
        if (gathered_.size() >= kBlock) flush();
    }
    std::uint64_t finish() {
        flush();
        return size_;
    }

private:
    static constexpr std::size_t kBlock = 1 << 16;

    void flush() {
        put(gathered_.data(), gathered_.size());
        gathered_.clear();
    }
    void put(const char* bytes, std::size_t count) {
        while (count > 0) {
            const ssize_t written = write(wire::kSceneMemory, bytes, count);
            if (written <= 0) throw std::bad_alloc();
            bytes += written;
            count -= std::size_t(written);
            size_ += std::uint64_t(written);
        }
    }

    std::string gathered_;
    std::uint64_t size_ = 0;
};

[[noreturn]] void noMemory() {
    _exit(wire::kOutOfMemory);
}

/// Says where it is no more than a hundred times.
Progress spokenProgress() {
    Progress progress;
    progress.report = [last = -1.0](double fraction) mutable {
        if (fraction < last + 0.01 && fraction < 1) return;
        sayNumber(Word::Progress, last = fraction);
    };
    return progress;
}

void import(const std::filesystem::path& file) {
    const auto loaded = loadScene(file, spokenProgress());
    if (!loaded) return sayFault(loaded.error());
    SceneMemory memory;
    writeTransfer(memory, *loaded);
    sayNumber(Word::Done, memory.finish());
}

void run(const std::filesystem::path& file) {
    prctl(PR_SET_PDEATHSIG, SIGKILL); // nobody would want the scene any more
    char go = 0;
    if (read(wire::kTalk, &go, 1) != 1 || go != char(Word::Go)) return;
    for (const std::string& protection : enterSandbox(file))
        say(Word::Lacks, protection);
    std::set_new_handler(noMemory);
    try {
        import(file);
    } catch (const std::bad_alloc&) {
        noMemory();
    } catch (const std::exception& fault) {
        sayFault({Error::Kind::Input, file.string() + ": the reader failed (" + fault.what() +
                                          "); the file may be damaged: export it again"});
    }
}

} // namespace
} // namespace tactum

int main(int argc, char** argv) {
    if (argc == 2) tactum::run(argv[1]);
    _exit(0); // the machine is quicker at taking the memory back
}
