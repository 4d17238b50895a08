// Between the devices that there are and the engine: lists them, makes the chosen one ready, brings it back.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>

#include "core/port/device_catalogue.h"
#include "core/port/stop_button.h"
#include "core/runtime/hands.h"

namespace tactum {

/// The device that everyone has, as every catalogue names it.
inline const QString kSimulatedDevice = QStringLiteral("simulated");

/// Held to the largest force that the person prefers (Preferred::LargestForce), if any. Thread: ui.
std::unique_ptr<HapticDevice> withOwnLimit(std::unique_ptr<HapticDevice> device);

enum class StepState { Waiting, Doing, Done, Failed };

/// A device on its way into the engine, as far as a person wants to know.
struct Preparation {
    enum class State { None, Running, GivenUp, Failed, Done };
    struct Step {
        QString name;
        StepState state = StepState::Waiting;
    };
    State state = State::None;
    bool beside = false; ///< as one more hand, and not in the place of the first
    QString id, name;
    std::vector<Step> steps;
    QString request;       ///< what the person has to do now
    double progress = 0;   ///< of the step that is being done, 0 to 1
    bool givingUp = false; ///< the person gave up, and the device has not ended yet
    QString failure;       ///< the device's sentence
};

/// The engine always has a device that works: a simulated one stands in while the chosen one is made ready,
/// cannot be started or was lost. The choice is remembered. A chosen device that comes back, or is there
/// when the program starts, is made ready by itself; the forces are off then, and a person switches them on.
/// Without a catalogue it does nothing.
/// That is the first hand. Others are added beside it, each with its device, and are remembered and brought
/// back as well, once no device has force. One whose device is lost goes; as long as another hand has force
/// it stays without a device, because to take it out of the engine would take the force from all. Thread: ui.
class DeviceLink : public QObject {
    Q_OBJECT
public:
    explicit DeviceLink(Engine& engine, QObject* parent = nullptr);
    /// Gives up what is under way and waits for its end.
    ~DeviceLink() override;

    /// Must outlive the link. Looks once a second from now on.
    void setCatalogue(DeviceCatalogue& catalogue);
    bool hasCatalogue() const { return catalogue_ != nullptr; }
    const std::vector<DeviceListing>& devices() const { return devices_; }
    const DeviceListing* find(const QString& id) const;
    /// Of the device that the first hand has.
    const QString& current() const { return used_[0].id; }
    /// Whether that is another one than the simulated device.
    bool connected() const { return leadsItself(0); }
    /// Each hand that there is; below: `hand` < hands().count().
    Hands& hands() { return hands_; }
    const QString& idOf(std::size_t hand) const { return used_[hand].id; }
    /// Whether its device is another one than the simulated.
    bool leadsItself(std::size_t hand) const { return used_[hand].id != kSimulatedDevice; }
    /// The device was lost, and the hand goes when no other has force.
    bool gone(std::size_t hand) const { return used_[hand].gone; }
    /// Which of them the mouse leads, if any.
    std::optional<std::size_t> simulatedHand() const;
    /// Whether a hand has this device.
    bool uses(const QString& id) const;
    /// What the person wants; another one than the current while it is not there.
    const QString& wanted() const { return wanted_; }
    /// The chosen device went away, and has not come back.
    bool lost() const { return !lostName_.isEmpty(); }
    bool preparing() const { return preparation_.state == Preparation::State::Running; }
    const Preparation& preparation() const { return preparation_; }

    // Why not, one sentence for the person; empty: it may be done. An empty `id` is no device.
    /// Why choose() would not make it ready: another one than those of the hands, or one of these when it is
    /// in trouble.
    QString whyNotBegin(const QString& id) const;
    /// Why choosing the simulated device would change nothing.
    QString whyNotLetGo() const;
    /// Why add() would not make it ready: a hand has it, or there is no room for one more. The simulated one
    /// only beside a device that leads itself.
    QString whyNotAdd(const QString& id) const;
    bool mayBegin(const QString& id) const { return whyNotBegin(id).isEmpty(); }
    bool mayAdd(const QString& id) const { return whyNotAdd(id).isEmpty(); }
    /// Makes it ready as one more hand; the simulated one at once. Whoever asks has switched the forces off.
    void add(const QString& id);
    /// Without this hand, one beside the first, which is not brought back. Forces of all are off then.
    void remove(std::size_t hand);
    /// Takes out what is gone() although others have force, which is off then.
    void letGoOfLost();
    /// Makes it ready and gives it to the engine; the simulated one at once.
    void choose(QString id);
    /// The same once more, after it failed or was given up.
    void tryAgain();
    /// Gives a device the file that it lacks, and makes it ready where that was what failed.
    void supply(const QString& id, const QString& file);
    /// Ends the preparing soon.
    void giveUp();
    /// Why lend() has nothing to give: the first hand has no device but the simulated one, or is not alone.
    QString whyNotLend() const;
    /// Takes the first hand's device out of the engine and makes it anew for somebody else, to whom lent()
    /// gives it: held to the person's largest force, and with the button that ends all force. Nothing is
    /// brought back until takeBack().
    void lend();
    /// Whoever had it has let go of it: it is made ready again by itself, once it is there.
    void takeBack();
    /// Keeps measured figures for devices of this name, which the next one that is made has; figuresKept().
    void keepFigures(const QString& name, const std::string& profile);
    /// Lists now instead of within the next second.
    void look();
    /// Once a frame.
    void frame();
    /// Where the loops are at a server, hands come and go with it: once a frame, before anything asks of
    /// them.
    void follow();
    /// Of the hand's device, if this link put it there.
    StopSwitch& stop(std::size_t hand = 0) { return *used_[hand].stop; }

signals:
    /// By lend(): the device, or why there is none.
    void lent(const std::shared_ptr<std::unique_ptr<tactum::HapticDevice>>& device, const QString& failure);
    /// A sentence of where they are, or of why not.
    void figuresKept(const QString& sentence, bool kept);
    void listChanged();
    /// Its state, steps, what the person has to do, its progress.
    void preparationChanged();
    /// The engine's device is about to go, and its recorder with it.
    void letsGo();
    /// A server has other hands than before.
    void handsFollowed();
    /// The engine has other devices: the forces are off and it knows nothing of the person's settings.
    void exchanged();
    /// The chosen device runs. `back`: nobody asked for it just now.
    void ready(const QString& name, bool back);
    void failed(const QString& sentence);
    void supplied(const QString& sentence);
    /// Of the first hand. `others`: another goes on with its force.
    void wentAway(const QString& name, bool others);
    /// Of a hand beside it.
    void besideWentAway(const QString& name, bool others);
    /// When it has looked for the first time: devices that were hands last time.
    void missing(const QStringList& names);

private:
    struct Attempt {
        explicit Attempt(QString theId, bool isBack = false, bool isBeside = false)
            : id(std::move(theId)), back(isBack), beside(isBeside) {}

        QString id;
        bool back, beside;
        std::atomic<bool> cancelled{false};
    };
    /// The device of a hand.
    struct Used {
        QString id;
        std::shared_ptr<StopSwitch> stop = std::make_shared<StopSwitch>();
        std::uint64_t seenUnread = 0; ///< readings, when it was last looked at
        bool gone = false;
    };
    /// A hand beside the first, of which settings know.
    struct Remembered {
        QString id, name;
        bool tried = false; ///< since it appeared
    };
    class Watch;
    using Made = std::shared_ptr<std::unique_ptr<HapticDevice>>;

    static QString whyWhilePreparing();
    QString givenId(std::size_t hand) const;
    /// The hand beside the first that has a device and cannot go on with it.
    std::optional<std::size_t> besideInTrouble(const QString& id) const;
    void list();
    void listed(std::vector<DeviceListing> found, const Made& spare);
    bool isLost(std::size_t hand);
    bool unread(std::size_t hand);
    void lose(std::size_t hand);
    void takeOut(std::size_t hand);
    void drop(std::size_t hand);
    void bringBack();
    void bringBackBeside();
    void sayMissing();
    bool mayBringBack() const;
    void wait(const Made& device);
    void recall();
    void remember(const QString& id, const QString& name);
    void forget(const QString& id);
    void keep() const;
    void begin(const std::shared_ptr<Attempt>& attempt);
    void prepare(const std::shared_ptr<Attempt>& attempt);
    void knowSteps(const QString& name, const std::vector<std::string>& steps);
    void beginStep(const QString& step, const QString& request);
    void goOn(double part);
    void ended(const std::shared_ptr<Attempt>& attempt, const Made& device, const QString& failure);
    void adopt(const Attempt& attempt, std::unique_ptr<HapticDevice> device);
    Result<void> adoptBeside(const QString& id, std::unique_ptr<HapticDevice> device);
    void fail(const QString& sentence);
    void park();
    void finish(Preparation::State state);

    Engine& engine_;
    Hands hands_;
    DeviceCatalogue* catalogue_ = nullptr;
    std::mutex asking_; ///< the catalogue answers one at a time
    std::vector<DeviceListing> devices_;
    Made spare_;             ///< a simulated device at hand
    std::vector<Used> used_; ///< of each hand
    QString wanted_;
    std::vector<Remembered> beside_;
    QString lostName_;
    std::shared_ptr<Attempt> next_; ///< when the one that is given up has ended
    Made waiting_;                  ///< of the attempt: for the forces to be off
    bool wantedThere_ = false;      ///< when it was last looked for
    bool looked_ = false;           ///< for the first time
    bool lending_ = false;          ///< nothing is brought back
    bool listing_ = false, again_ = false;
    std::size_t troubled_ = 0; ///< hands whose device was in trouble when it was last looked
    Preparation preparation_;
    std::shared_ptr<Attempt> attempt_;
    QTimer timer_;
    QThreadPool pool_; ///< one thread lists, one prepares
};

} // namespace tactum
