// SPDX-License-Identifier: MIT
// A folder for one test, gone with all it holds when the test ends.
#pragma once

#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace hyrax {

class TemporaryFolder {
public:
    TemporaryFolder() {
        static int count = 0;  // ctest runs executables side by side: the clock tells them apart
        const auto now = std::chrono::system_clock::now().time_since_epoch().count();
        path_ = std::filesystem::temp_directory_path() /
                ("hyrax_test_" + std::to_string(now) + "_" + std::to_string(++count));
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code code;
        std::filesystem::remove_all(path_, code);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Writes a file of this name and returns its path.
    std::filesystem::path write(std::string_view name, std::string_view content) const {
        const std::filesystem::path file = path_ / std::filesystem::path(name);
        std::ofstream stream(file, std::ios::binary);
        stream.write(content.data(), static_cast<std::streamsize>(content.size()));
        stream.close();
        REQUIRE(stream);
        return file;
    }

private:
    std::filesystem::path path_;
};

}  // namespace hyrax
