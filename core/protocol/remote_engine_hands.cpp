// The hands of a server, each by its number.
#include "core/protocol/remote_engine_impl.h"

namespace tactum {
namespace {

using Order = v1::OrderRequest;

v1::Workspace written(const Workspace& workspace) {
    v1::Workspace to;
    to.set_scale(workspace.scale);
    for (const auto axis : workspace.axes)
        to.add_axis(axis);
    to.mutable_offset()->set_x(workspace.offset.x());
    to.mutable_offset()->set_y(workspace.offset.y());
    to.mutable_offset()->set_z(workspace.offset.z());
    to.set_clutch(workspace.clutch);
    to.set_bump(workspace.bump);
    to.set_centring(workspace.centring);
    to.set_reach(std::uint32_t(workspace.reach.mode));
    to.set_shell(workspace.reach.shell);
    return to;
}

} // namespace

std::size_t RemoteEngine::hands() const {
    return impl_->shown.hands.size();
}
void RemoteEngine::speakOf(std::size_t hand) {
    impl_->spoken = hand;
    impl_->session.dropTrace(hand);
    impl_->last = {.t = impl_->last.t};
    impl_->join();
}
std::size_t RemoteEngine::spokenOf() const {
    return impl_->spoken;
}
const HandReport& RemoteEngine::told(std::size_t hand) const {
    return impl_->shown.hands[hand];
}

Result<void> RemoteEngine::setWorkspaceOf(std::size_t hand, const Workspace& workspace) {
    if (Result<void> possible = checkWorkspace(workspace); !possible) return possible;
    impl_->wishes[hand].workspace.set(workspace);
    impl_->shown.hands[hand].workspace = workspace;
    Order order;
    *order.mutable_workspace() = written(workspace);
    impl_->order(std::move(order), hand, true);
    return {};
}

void RemoteEngine::setGraspedOf(std::size_t hand, bool on) {
    Order order;
    order.set_grasped(on);
    impl_->order(std::move(order), hand, true);
}

void RemoteEngine::restartProxyOf(std::size_t hand) {
    if (!holdsPen()) return;
    Order order;
    order.mutable_restart();
    impl_->order(std::move(order), hand);
}

void RemoteEngine::setArmedOf(std::size_t hand, bool armed) {
    if (!armed && !holdsPen()) return;
    impl_->wishArmed(hand, armed);
    Order order;
    order.set_arm(armed);
    impl_->order(std::move(order), hand);
}
void RemoteEngine::setAllArmed(bool armed) {
    if (armed) {
        for (std::size_t hand = 0; hand < hands(); ++hand)
            setArmedOf(hand, true);
        return;
    }
    impl_->wishArmed(false);
    Order order;
    order.mutable_stop();
    impl_->session.order(std::move(order));
}

} // namespace tactum
