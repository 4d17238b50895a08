#include "app/python/run_record.h"

#include "core/haptics/compile.h"

namespace tactum::python {

RunRecord::RunRecord() {
    run_.device.name = "a script in Python";
}

void RunRecord::begin(ProxyRow& row, SimState& state, const World& world) {
    row.time = time_;
    row.world = world.revision;
    if (!run_.sceneOf(world.revision)) run_.scenes.push_back({tactum::numbersOf(world), world.scene});
    if (time_ < stateDue_) return;
    stateDue_ = time_ + kStateEvery;
    row.flags |= ProxyRow::Forget;
    SimStateBytes& kept = run_.proxyStates.emplace_back();
    kept.row = run_.proxy.end();
    write(state, kept);
}

void RunRecord::end(const ProxyRow& row) {
    run_.proxy.rows.push_back(row);
    time_ += row.dt;
    if (time_ - run_.begin() > 2 * kRecorded) trim(run_);
}

Recording RunRecord::recording(const std::string& reason) const {
    Recording recording{run_, reason, {}};
    trim(recording.run);
    return recording;
}

} // namespace tactum::python
