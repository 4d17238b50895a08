#include "ui/controllers/edit_notice.h"

#include "ui/document/document.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

EditNotice::EditNotice(Document& document, NoticeBar& notice, QObject* parent)
    : QObject(parent), document_(document), notice_(notice) {
    connect(&document.history(), &QUndoStack::indexChanged, this, &EditNotice::follow);
}

void EditNotice::keep(const QString& sentence) {
    sentence_ = sentence;
    step_ = document_.history().index();
}

bool EditNotice::isLast() const {
    return document_.history().index() == step_;
}

void EditNotice::follow(int step) {
    if (step_ == 0 || step == step_) return;
    if (step > step_) return notice_.takeBackAlso(sentence_);
    step_ = 0;
    notice_.takeBack(sentence_);
    emit undone();
}

} // namespace tactum
