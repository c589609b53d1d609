// SPDX-License-Identifier: MIT
// Zip files, by minizip.
#include "daemon/control/archive.h"

#include <minizip/unzip.h>
#include <sys/stat.h>

#include <array>
#include <utility>

namespace hyrax {
namespace {

class ZipArchive final : public Archive {
public:
    explicit ZipArchive(unzFile file) : file_(file) {}
    ~ZipArchive() override { unzClose(file_); }

    Result<bool> next(ArchiveEntry& entry) override {
        const int moved =
            std::exchange(fresh_, false) ? unzGoToFirstFile(file_) : unzGoToNextFile(file_);
        if (moved == UNZ_END_OF_LIST_OF_FILE) {
            return false;
        }
        unz_file_info64 info{};
        std::array<char, 1024> name{};
        if (moved != UNZ_OK || unzGetCurrentFileInfo64(
                                   file_, &info, name.data(), name.size(), nullptr, 0, nullptr, 0
                               ) != UNZ_OK) {
            return broken();
        }
        if (info.size_filename >= name.size()) {
            return failure("a name is too long");
        }
        entry.name.assign(name.data(), info.size_filename);
        // What Unix says of the file is in the upper half.
        entry.is_link = S_ISLNK(static_cast<mode_t>(info.external_fa >> 16U));
        entry.is_encrypted = (info.flag & 1U) != 0;
        return true;
    }

    Result<void> read(const Sink& sink) override {
        if (unzOpenCurrentFile(file_) != UNZ_OK) {
            return broken();
        }
        std::array<char, 65536> piece{};
        Result<void> taken;
        int got = 0;
        while (taken && (got = unzReadCurrentFile(file_, piece.data(), piece.size())) > 0) {
            taken = sink({piece.data(), static_cast<std::size_t>(got)});
        }
        const int closed = unzCloseCurrentFile(file_);
        return taken && (got < 0 || closed != UNZ_OK) ? Result<void>(broken()) : taken;
    }

private:
    static std::unexpected<Error> broken() { return failure("the archive is broken"); }

    unzFile file_;
    bool fresh_ = true;
};

}  // namespace

Result<std::unique_ptr<Archive>> open_archive(const std::filesystem::path& file) {
    const unzFile opened = unzOpen64(file.c_str());
    if (opened == nullptr) {
        return failure(file.native() + ": is neither a folder nor a zip file");
    }
    return std::make_unique<ZipArchive>(opened);
}

}  // namespace hyrax
