// A stand-in for the import process that does what the name of its file says, and never what it should.
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

#include <unistd.h>

#include "core/import/scene_transfer.h"
#include "core/import/wire.h"

using namespace tactum;

namespace {

void say(wire::Word word, std::string_view what) {
    const std::string packet = char(word) + std::string(what);
    if (write(wire::kTalk, packet.data(), packet.size()) < 0) _exit(1);
}

void sayDone(std::uint64_t size) {
    say(wire::Word::Done, {reinterpret_cast<const char*>(&size), sizeof size});
}

void eat() {
    std::set_new_handler([] { _exit(wire::kOutOfMemory); });
    std::vector<std::vector<char>> eaten;
    while (true)
        eaten.emplace_back(std::size_t(16) << 20, 'x');
}

void fill() {
    const std::vector<char> block(1 << 20, 'x');
    while (write(wire::kSceneMemory, block.data(), block.size()) > 0) {
    }
    _exit(0);
}

void chatter() {
    for (double fraction = 0;; fraction += 1e-9)
        say(wire::Word::Progress, {reinterpret_cast<const char*>(&fraction), sizeof fraction});
}

void writeScene(const std::string& bytes) {
    if (write(wire::kSceneMemory, bytes.data(), bytes.size()) < 0) _exit(1);
}

} // namespace

int main(int, char** argv) {
    const std::string does = std::filesystem::path(argv[1]).stem().string();
    volatile bool always = true;
    if (does == "loops")
        while (always) {
        }
    if (does == "sleeps") pause();
    if (does == "mute") close(wire::kTalk), pause();
    if (does == "eats") eat();
    if (does == "fills") fill();
    if (does == "killed") raise(SIGKILL);
    if (does == "crashes") raise(SIGSEGV);
    if (does == "chatters") chatter();
    if (does == "babbles") say(wire::Word(7), "gibberish");
    if (does == "escapes") say(wire::Word::Fault, "\x01red \x1b[31m and\na second line");
    if (does == "nothing") sayDone(1000);
    if (does == "too-much") writeScene("little"), sayDone(~std::uint64_t(0));
    if (does == "lies") writeScene(std::string(4000, '\xff')), sayDone(4000);
    if (does == "zeros") writeScene(std::string(4000, '\0')), sayDone(4000);
    if (does == "no-objects") {
        StringOut nothing;
        writeTransfer(nothing, {});
        writeScene(nothing.bytes), sayDone(nothing.bytes.size());
    }
    if (does == "says-one-lives-on") sayDone(1), pause();
    return 0;
}
