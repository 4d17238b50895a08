// What a client orders beside edits: forces, the pen, the pace of bodies, what is of a hand.
#pragma once

#include "core/protocol/messages.h"
#include "core/session/stage.h"

namespace tactum {

/// Everything but stop, which is Stage::stop(). Errors: what cannot be, or who has no pen.
Result<void> obey(Stage& stage, ClientId who, const v1::OrderRequest& request);

} // namespace tactum
