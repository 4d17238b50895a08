// An answer that is too long for one message: made by a worker, said in pieces. For this folder only.
#pragma once

#include <functional>
#include <new>
#include <string>
#include <utility>

#include "core/protocol/messages.h"
#include "core/protocol/workers.h"

namespace tactum {

/// `Reply` has set_bytes(). Deletes itself.
template <class Reply> class Pieces final : public grpc::ServerWriteReactor<Reply> {
public:
    explicit Pieces(const grpc::Status& refusal) { this->Finish(refusal); }
    /// `make`: all bytes, and what else the first piece says, into `first`.
    Pieces(Workers& workers, std::function<std::string(Reply& first)> make) {
        workers.run([this, make = std::move(make)] {
            try {
                bytes_ = make(piece_);
            } catch (const std::bad_alloc&) {
                return this->Finish(
                    {grpc::StatusCode::RESOURCE_EXHAUSTED,
                     "the server has not enough memory for this: close other programs there"});
            }
            next();
        });
    }
    void OnWriteDone(bool ok) override {
        if (!ok) return this->Finish(grpc::Status::CANCELLED);
        if (at_ >= bytes_.size()) return this->Finish(grpc::Status::OK);
        next();
    }
    void OnDone() override { delete this; }

private:
    static constexpr std::size_t kPiece = 1 << 18;

    void next() {
        piece_.set_bytes(bytes_.substr(at_, kPiece));
        at_ += kPiece;
        this->StartWrite(&piece_);
    }

    std::string bytes_;
    std::size_t at_ = 0;
    Reply piece_;
};

} // namespace tactum
