#include "core/protocol/orders.h"

#include "core/protocol/edits.h"

namespace tactum {
namespace {

/// What is of a hand.
Result<void> obeyOf(Stage& stage, ClientId who, const v1::OrderRequest& request) {
    using Request = v1::OrderRequest;
    using Hand = LocalEngine::Hand;
    const std::size_t one = request.of(); // the first where none is named
    const Stage::OfHand all = request.has_of() ? Stage::OfHand(one) : std::nullopt;
    const auto done = [](auto order) {
        return [order](Hand hand) {
            order(hand);
            return Result<void>();
        };
    };
    switch (request.what_case()) {
    case Request::kArm:
        // Who names none may not see the others: nobody gets a force unseen.
        return stage.arm(who, request.arm(), request.arm() ? Stage::OfHand(one) : all);
    case Request::kRestart:
        return stage.order(who, one, done([](Hand& hand) { hand.restartProxy(); }));
    case Request::kFade:
        return stage.order(who, all, done([](Hand& hand) { hand.fade(); }));
    case Request::kDeadMan:
        return stage.order(who, all, done([&](Hand& hand) { hand.setDeadMan(request.dead_man()); }));
    case Request::kOverrideCeiling:
        return stage.order(who, one,
                           done([&](Hand& hand) { hand.setOverrideCeiling(request.override_ceiling()); }));
    case Request::kGrasped:
        return stage.order(who, one, done([&](Hand& hand) { hand.setGrasped(request.grasped()); }));
    case Request::kWorkspace: {
        const auto workspace = workspaceOf(request.workspace());
        if (!workspace) return tl::unexpected(workspace.error());
        return stage.order(who, one, [&](Hand hand) { return hand.setWorkspace(*workspace); });
    }
    case Request::kHand: {
        const auto to = vectorOf(request.hand());
        return to ? stage.leadHand(who, one, {.position = *to}) : Result<void>(tl::unexpected(to.error()));
    }
    default:
        return inputError("says nothing that this server knows: is the client newer?");
    }
}

} // namespace

Result<void> obey(Stage& stage, ClientId who, const v1::OrderRequest& request) {
    using Request = v1::OrderRequest;
    switch (request.what_case()) {
    case Request::kAsk:
        return stage.askForPen(who);
    case Request::kGive:
        return stage.passPen(who, request.give().to());
    case Request::kPace:
        if (!(request.pace() >= 0 && request.pace() <= 1)) return inputError("a pace is from 0 to 1");
        return stage.order(who, [&](Engine& engine) { engine.setPace(request.pace()); });
    case Request::kBegin:
        return stage.order(who, [](Engine& engine) { engine.beginBodies(); });
    case Request::kStep:
        return stage.order(who, [](Engine& engine) { engine.stepBodies(); });
    default:
        return obeyOf(stage, who, request);
    }
}

} // namespace tactum
