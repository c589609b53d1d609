// SPDX-License-Identifier: MIT
#include "daemon/headless/process_use.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace hyrax {
namespace {

// A line such as "RssAnon:     1234 kB" as bytes; 0 if there is none.
std::uint64_t bytes_of(const std::string& status, const std::string& key) {
    const std::size_t at = status.find("\n" + key + ":");
    return at == std::string::npos ? 0 : std::stoull(status.substr(at + key.size() + 2)) * 1024;
}

}  // namespace

ProcessUse process_use() {
    std::ifstream file("/proc/self/status");
    const std::string status(std::istreambuf_iterator<char>(file), {});
    std::error_code error;
    const std::filesystem::directory_iterator descriptors("/proc/self/fd", error);
    return {
        .handles = static_cast<std::uint64_t>(std::distance(begin(descriptors), {})),
        .private_bytes = bytes_of(status, "RssAnon"),
        .resident_bytes = bytes_of(status, "VmRSS"),
    };
}

}  // namespace hyrax
