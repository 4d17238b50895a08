// Whoever is led by the window through a self-test: reads what it says, does it, and presses its buttons.
#pragma once

#include <functional>
#include <optional>

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTest>

#include "core/self_test/trial_bench.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/controllers/self_test_controller.h"
#include "ui/panels/self_test_dialog.h"

namespace tactum {

class SelfTestPerson {
public:
    /// `does`: with the handle, what is asked for; false leaves it out.
    SelfTestPerson(TouchedWindow& program, std::function<bool(TrialAsk)> does)
        : program_(program), does_(std::move(does)) {}

    /// In a hurry: the figures are worth little then.
    void hurry(const SelfTestPace& pace) { program_.window->findChild<SelfTestController*>()->setPace(pace); }
    void open() {
        QTRY_VERIFY_WITH_TIMEOUT(program_.command("self-test").isEnabled(), kPatience);
        program_.command("self-test").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(dialog() && dialog()->isVisible(), kPatience);
    }
    SelfTestDialog* dialog() { return program_.window->findChild<SelfTestDialog*>(); }
    template <class Kind> Kind& widget(const char* name) {
        auto* found = dialog() ? dialog()->findChild<Kind*>(QString::fromLatin1(name)) : nullptr;
        if (!found) qFatal("no %s in the dialog", name);
        return *found;
    }
    QString text(const char* label) { return widget<QLabel>(label).text(); }
    void click(const char* button) { QTest::mouseClick(&widget<QPushButton>(button), Qt::LeftButton); }
    bool shown(const char* name) { return dialog() && widget<QWidget>(name).isVisible(); }
    bool over() { return shown("self-test-verdict") || shown("self-test-failure"); }
    bool asked() {
        return shown("self-test-continue") && widget<QPushButton>("self-test-continue").isEnabled();
    }

    /// What the words on the page ask for, in the language that is on; nullopt: the mass.
    std::optional<TrialAsk> ask() {
        using namespace trial_words;
        const QString words = text("self-test-words");
        const auto ways = {std::pair(kToTheRight, TrialAsk::Right), std::pair(kUpwards, TrialAsk::Up),
                           std::pair(kTowardYou, TrialAsk::Toward)};
        for (const auto& [way, ask] : ways) {
            if (words == trialText({kLeadAlong, {way}})) return ask;
            if (words == trialText({kHoldZero, {way}})) return TrialAsk::Zero;
        }
        if (words.startsWith(trialText(kPress).section(u'%', 0, 0))) return TrialAsk::Press;
        if (shown("self-test-mass")) return std::nullopt;
        if (words == trialText(kHang)) return TrialAsk::Hang;
        return TrialAsk::LetGo;
    }
    /// Does what is asked for and goes on, until it is over or `enough`. False when nothing moves on any
    /// more.
    bool goThrough(const std::function<bool()>& enough = [] { return false; }) {
        for (;;) {
            const int before = progress();
            const bool went = test::waitFor(
                [&] { return over() || enough() || asked() || (progress() != before && shown(kProgress)); });
            if (!went || over() || enough()) return went;
            if (asked()) answer();
        }
    }

private:
    static constexpr const char* kProgress = "self-test-progress";

    int progress() { return dialog() ? widget<QProgressBar>(kProgress).value() : 0; }
    void answer() {
        const auto what = ask();
        if (!what || !does_(*what)) return click("self-test-skip");
        program_.frames(3); // so that the page knows where the handle is
        click("self-test-continue");
    }

    TouchedWindow& program_;
    std::function<bool(TrialAsk)> does_;
};

} // namespace tactum
