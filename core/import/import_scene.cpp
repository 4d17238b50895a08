#include "core/import/import_scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>

#include "core/base/child_program.h"
#include "core/base/realtime.h"
#include "core/base/text.h"
#include "core/files/source.h"
#include "core/import/scene_transfer.h"
#include "core/import/wire.h"
#include "core/import/worker_process.h"

namespace tactum {
namespace {

using Clock = std::chrono::steady_clock;
using Answer = Result<LoadedScene>;

/// One conversation with one import process.
class Import {
public:
    Import(const std::filesystem::path& file, const Progress& progress, const ImportLimits& limits)
        : name_(shownPath(file)), progress_(progress), limits_(limits) {}

    Answer run(WorkerProcess process) {
        const auto end = Clock::now() + limits_.patience;
        std::string packet;
        while (true) {
            const auto heard = process.listen(packet);
            if (progress_.isCancelled()) return cancelledError();
            if (heard == WorkerProcess::Heard::Silence) return stopped(process.whyItStopped());
            if (heard == WorkerProcess::Heard::Packet)
                if (auto answer = understand(packet, process)) return std::move(*answer);
            if (Clock::now() > end)
                return stopped("did not end within " + std::to_string(limits_.patience.count()) + " s");
        }
    }

private:
    Answer stopped(const std::string& why) const {
        return inputError(name_ + ": the reader stopped (" + why +
                          "); the file may be damaged: export it again, or simplify it");
    }

    /// Nothing as long as it is not the last word.
    std::optional<Answer> understand(std::string_view packet, WorkerProcess& process) {
        const auto word = wire::Word(packet.front());
        packet.remove_prefix(1);
        if (word == wire::Word::Progress && packet.size() == sizeof(double))
            report(0.9 * numberIn<double>(packet));
        else if (word == wire::Word::Lacks)
            lacks_ += (lacks_.empty() ? "" : " and ") + printable(packet, 100);
        else if (word == wire::Word::Fault && packet.size() > 1)
            return tl::unexpected<Error>(faultOf(packet));
        else if (word == wire::Word::Done && packet.size() == sizeof(std::uint64_t))
            return received(process, numberIn<std::uint64_t>(packet));
        else
            return stopped("said what makes no sense");
        return std::nullopt;
    }

    template <class T> static T numberIn(std::string_view bytes) {
        T number{};
        std::memcpy(&number, bytes.data(), sizeof number);
        return number;
    }

    static Error faultOf(std::string_view packet) {
        const bool machine = packet.front() == char(Error::Kind::Machine);
        return {machine ? Error::Kind::Machine : Error::Kind::Input, printable(packet.substr(1), 4000)};
    }

    void report(double fraction) {
        if (!progress_.report || !(fraction > reported_ && fraction <= 1)) return;
        reported_ = fraction;
        progress_.report(fraction);
    }

    Answer received(WorkerProcess& process, std::uint64_t size) {
        const std::string_view bytes = process.scene(size);
        if (bytes.empty()) return stopped("gave no scene");
        try {
            LoadedScene loaded = readTransfer(bytes);
            if (loaded.scene.objects.empty() && loaded.scene.mechanics.bodies.empty())
                return stopped("gave an empty scene");
            if (!lacks_.empty()) loaded.findings.push_back(lackOf(lacks_));
            report(1);
            return loaded;
        } catch (const ByteFault& fault) {
            return tl::unexpected<Error>({Error::Kind::Input, name_ + ": " + fault.error.text});
        }
    }

    static Finding lackOf(const std::string& protection) {
        return {Finding::Severity::Note, "",
                "was read without the protection of " + protection + ", which this machine does not have",
                "its memory and time were limited all the same; open files from strangers elsewhere"};
    }

    std::string name_, lacks_;
    const Progress& progress_;
    ImportLimits limits_;
    double reported_ = -1;
};

std::uint64_t sizeOf(const std::filesystem::path& file) {
    std::error_code fault;
    const auto size = std::filesystem::file_size(file, fault);
    return fault ? 0 : size;
}

/// What has neither large files beside it nor is packed needs no more than twelve times itself and a little.
ImportLimits limitsOf(const std::filesystem::path& file) {
    constexpr std::uint64_t kLittle = std::uint64_t(1) << 30;
    const std::uint64_t size = sizeOf(file);
    ImportLimits limits = limitsFor(size);
    const std::string ending = lowerCase(file.extension().string());
    constexpr std::string_view kHoldMore[] = {".gltf", ".glb", ".obj", ".zip", ".tactum", ".3mf"};
    const bool holdsMore = std::ranges::find(kHoldMore, ending) != std::end(kHoldMore);
    if (!holdsMore) limits.memory = std::max(kLittle, std::min(limits.memory, kLittle + 12 * size));
    return limits;
}

} // namespace

ImportLimits limitsFor(std::uint64_t fileBytes) {
    ImportLimits limits;
    constexpr std::uint64_t kMax = std::uint64_t(1) << 40;
    limits.memory = std::max(limits.memory, 12 * std::min(fileBytes, kMax));
    limits.processor += std::chrono::seconds(std::min(fileBytes, kMax) >> 22);
    limits.patience = 5 * limits.processor;
    return limits;
}

std::filesystem::path importWorker() {
    const auto worker = programBeside("tactum-import");
    return worker.empty() ? std::filesystem::path(TACTUM_IMPORT_WORKER) : worker;
}

Result<LoadedScene> importScene(const std::filesystem::path& file, const Progress& progress,
                                const ImportOptions& options) {
    assertNotRealtime();
    const ImportLimits limits = options.limits ? *options.limits : limitsOf(file);
    const auto worker = options.worker.empty() ? importWorker() : options.worker;
    try {
        auto process = WorkerProcess::start(worker, file, limits);
        if (!process) return tl::unexpected(process.error());
        return Import(file, progress, limits).run(std::move(*process));
    } catch (const std::bad_alloc&) {
        return machineError(shownPath(file) + ": not enough memory to open it; close other programs");
    }
}

} // namespace tactum
