// The proxy of this program is compiled with the name below in the place of sweepFrom: see CMakeLists.txt.
#include "tests/benchmarks/sweep_record.h"

#include "core/collision/sweep_memory.h"

namespace tactum {

std::vector<bench::RecordedSweep>* bench::sweepRecord = nullptr;

SweepHit recordedSweepFrom(SweepMemory& memory, const CollisionMesh& mesh, const SpherePath& path,
                           std::span<const Index> excluded) noexcept;

SweepHit recordedSweepFrom(SweepMemory& memory, const CollisionMesh& mesh, const SpherePath& path,
                           std::span<const Index> excluded) noexcept {
    if (bench::sweepRecord)
        bench::sweepRecord->push_back({path, std::vector<Index>(excluded.begin(), excluded.end())});
    return sweepFrom(memory, mesh, path, excluded);
}

} // namespace tactum
