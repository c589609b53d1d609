// SPDX-License-Identifier: MIT
// Zip files, by minizip. It reads from memory: its own way to a file knows no wide names.
#include "daemon/control/archive.h"
#include "daemon/core/files.h"
#include "daemon/core/plugin.h"

#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

namespace hyrax {
namespace {

// Beside what a plugin may hold, names and headers.
constexpr std::size_t most_zip_bytes = most_plugin_bytes + (std::size_t{1} << 20U);

// A file as minizip wants to see it.
struct Memory {
    std::vector<std::byte> bytes;
    std::size_t at = 0;
};

Memory& memory_of(void* opaque) {
    return *static_cast<Memory*>(opaque);
}

uLong read_some(void* opaque, void*, void* to, uLong wanted) {
    Memory& memory = memory_of(opaque);
    const std::size_t size = std::min<std::size_t>(wanted, memory.bytes.size() - memory.at);
    if (size > 0) {
        std::memcpy(to, memory.bytes.data() + memory.at, size);
    }
    memory.at += size;
    return static_cast<uLong>(size);
}

long seek(void* opaque, void*, ZPOS64_T offset, int origin) {
    Memory& memory = memory_of(opaque);
    const std::size_t from = origin == ZLIB_FILEFUNC_SEEK_END   ? memory.bytes.size()
                             : origin == ZLIB_FILEFUNC_SEEK_CUR ? memory.at
                                                                : 0;
    if (offset > memory.bytes.size() - from) {
        return -1;
    }
    memory.at = from + offset;
    return 0;
}

zlib_filefunc64_def functions_for(Memory& memory) {
    return {
        .zopen64_file = [](void* opaque, const void*, int) { return opaque; },
        .zread_file = read_some,
        .zwrite_file = nullptr,
        .ztell64_file = [](void* opaque, void*) -> ZPOS64_T { return memory_of(opaque).at; },
        .zseek64_file = seek,
        .zclose_file = [](void*, void*) { return 0; },
        .zerror_file = [](void*, void*) { return 0; },
        .opaque = &memory,
    };
}

class ZipArchive final : public Archive {
public:
    explicit ZipArchive(std::vector<std::byte> bytes) : memory_{std::move(bytes)} {
        zlib_filefunc64_def functions = functions_for(memory_);
        file_ = unzOpen2_64("", &functions);
    }
    ~ZipArchive() override {
        if (is_open()) {
            unzClose(file_);
        }
    }
    bool is_open() const { return file_ != nullptr; }

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
        constexpr uLong kind_mask = 0170000;
        constexpr uLong link_kind = 0120000;
        entry.is_link = ((info.external_fa >> 16U) & kind_mask) == link_kind;
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

    Memory memory_;
    unzFile file_ = nullptr;
    bool fresh_ = true;
};

}  // namespace

Result<std::unique_ptr<Archive>> open_archive(const std::filesystem::path& file) {
    Result<std::vector<std::byte>> bytes = read_binary_file(file, most_zip_bytes);
    if (!bytes) {
        return std::unexpected(bytes.error());
    }
    auto archive = std::make_unique<ZipArchive>(*std::move(bytes));
    if (!archive->is_open()) {
        return failure(utf8_from_path(file) + ": is neither a folder nor a zip file");
    }
    return archive;
}

}  // namespace hyrax
