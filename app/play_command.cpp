#include <cstdio>
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/picture.h"
#include "app/results.h"
#include "core/recording/events.h"
#include "core/recording/player.h"
#include "core/recording/recording_file.h"
#include "core/video/video_file.h"

namespace tactum {

namespace {

constexpr double kStretch = 1; ///< s, played at once

TouchRow rowOf(const ReplayedStep& step, double begin) {
    return {.t = step.row->time - begin,
            .finger = vectorOf(step.row->finger),
            .proxy = step.output.proxy,
            .force = step.output.force,
            .contacts = step.output.contacts,
            .rounds = step.output.report.rounds};
}

/// Everything, with the touch where it is asked for.
TouchTrace play(Player& player, bool keep) {
    TouchTrace rows;
    const double begin = player.run().begin();
    for (double time = begin; !player.atEnd(); time += kStretch) {
        player.advanceTo(time + kStretch);
        player.takeTrace();
        for (const ReplayedStep& step : player.takeSteps())
            if (keep) rows.push_back(rowOf(step, begin));
    }
    return rows;
}

std::string sentenceOf(const ReplayCheck& check) {
    return std::to_string(check.proxySteps + check.servoSteps) + " steps, " + std::to_string(check.differ) +
           " differ";
}

void print(const Recording& recording, const std::vector<RecordedEvent>& events, const ReplayCheck& check) {
    const RecordedRun& run = recording.run;
    std::cout << sentenceOf(check) << '\n';
    if (check.differ > 0) std::cout << "the first: " << check.first << '\n';
    std::printf("%.3f s with %s; %s\n", run.end() - run.begin(), run.device.name.c_str(),
                recording.reason.c_str());
    for (const RecordedEvent& event : events)
        std::printf("%9.3f s  %s%s\n", event.time - run.begin(), event.fault ? "FAULT: " : "",
                    event.text.c_str());
}

nlohmann::ordered_json summaryOf(const Recording& recording, const std::vector<RecordedEvent>& events,
                                 const ReplayCheck& check) {
    const RecordedRun& run = recording.run;
    nlohmann::ordered_json json{{"reason", recording.reason},
                                {"device", run.device.name},
                                {"seconds", run.end() - run.begin()},
                                {"haptic_steps", check.proxySteps},
                                {"servo_ticks", check.servoSteps},
                                {"differ", check.differ},
                                {"first_difference", check.first},
                                {"scenes", run.scenes.size()},
                                {"events", nlohmann::ordered_json::array()}};
    for (const RecordedEvent& event : events)
        json["events"].push_back(
            {{"t", event.time - run.begin()}, {"fault", event.fault}, {"text", event.text}});
    return json;
}

constexpr int kVideoHeight = 720, kGifHeight = 360; // pixels

Result<void> writeVideoOf(const PlayOptions& options, const std::shared_ptr<const RecordedRun>& run) {
    const bool gif = options.video->extension() == std::string(".") + kGifEnding;
    const int height = options.videoHeight > 0 ? int(options.videoHeight) : gif ? kGifHeight : kVideoHeight;
    return writeVideo(run, *options.video, height, options.plot);
}

} // namespace

Result<int> runPlay(const PlayOptions& options) {
    auto recording = readRecording(options.recording);
    if (!recording) return tl::unexpected(recording.error());
    const auto run = std::make_shared<const RecordedRun>(recording->run);
    auto player = Player::open(run);
    if (!player) return tl::unexpected(player.error());
    const TouchTrace rows = play(*player, options.out.has_value());
    const std::vector<RecordedEvent> events = eventsOf(recording->run);
    const ReplayCheck& check = player->check();
    if (check.proxySteps + check.servoSteps == 0)
        return inputError(options.recording.filename().string() +
                          ": no step in it can be stepped through again; use another one");
    if (options.out)
        if (auto written = writeFile(*options.out, touchCsv(rows)); !written)
            return tl::unexpected(written.error());
    if (options.summary)
        if (auto written = writeFile(*options.summary, summaryOf(*recording, events, check).dump() + '\n');
            !written)
            return tl::unexpected(written.error());
    if (options.video)
        if (auto written = writeVideoOf(options, run); !written) return tl::unexpected(written.error());
    if (!isDash(options.out) && !isDash(options.summary)) print(*recording, events, check);
    return check.differ > 0 ? 1 : 0;
}

} // namespace tactum
