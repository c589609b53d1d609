// SPDX-License-Identifier: MIT
#include "daemon/core/statistics.h"

#include "daemon/core/files.h"

#include <fmt/format.h>

#include <chrono>
#include <fstream>

namespace hyrax {

std::string json_line(const Statistics& statistics, double unix_time) {
    const DesktopCounters& desktop = statistics.desktop;
    const OverlayCounters& overlay = desktop.overlay;
    const ProcessUse& process = statistics.process;
    const bool shown = desktop.first_frame != never;
    const double first = unix_time - to_seconds(shown ? statistics.now - desktop.first_frame : 0);
    // Numbers alone: nothing to escape.
    return fmt::format(
        R"({{"time": {:.6f}, "first_frame": {}, "pets": {}, "moving": {}, "frames": {}, )"
        R"("presents": {}, "presented_bytes": {}, "resizes": {}, "failures": {}, "wakeups": {}, )"
        R"("timer_wakeups": {}, "gdi_objects": {}, "user_objects": {}, "handles": {}, )"
        R"("private_bytes": {}, "resident_bytes": {}}})"
        "\n",
        unix_time,
        shown ? fmt::format("{:.6f}", first) : "null",
        statistics.pets,
        statistics.moving,
        overlay.frames,
        overlay.presents,
        overlay.bytes,
        overlay.resizes,
        overlay.failures,
        desktop.wakeups,
        desktop.timer_wakeups,
        process.gdi_objects,
        process.user_objects,
        process.handles,
        process.private_bytes,
        process.resident_bytes
    );
}

Result<void> append_statistics(const std::filesystem::path& file, const Statistics& statistics) {
    const std::chrono::duration<double> since_1970 =
        std::chrono::system_clock::now().time_since_epoch();
    std::ofstream out(file, std::ios::binary | std::ios::app);
    out << json_line(statistics, since_1970.count());
    out.close();
    if (!out) {
        return failure(fmt::format("{}: cannot be written", utf8_from_path(file)));
    }
    return {};
}

}  // namespace hyrax
