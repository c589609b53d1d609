// SPDX-License-Identifier: MIT
#include "daemon/win32/confined_process.h"

#include "daemon/win32/text.h"

#include <array>
#include <memory>
#include <vector>

namespace hyrax::win32 {
namespace {

// Missing in the headers of mingw-w64 10 for this version of Windows.
constexpr DWORD_PTR child_process_policy = 0x2000E;  // PROC_THREAD_ATTRIBUTE_CHILD_PROCESS_POLICY
constexpr DWORD no_child_process = 1;                // PROCESS_CREATION_CHILD_PROCESS_RESTRICTED
constexpr DWORD_PTR job_list = 0x2000D;              // PROC_THREAD_ATTRIBUTE_JOB_LIST

std::unexpected<Error> failed(const char* what) {
    return std::unexpected(system_error(std::string("cannot start the script host: ") + what));
}

/// This process's token without privileges, without administrator's rights, of low integrity: it
/// may write next to nowhere.
Result<KernelObject> low_token() {
    HANDLE own = nullptr;
    constexpr DWORD access =
        TOKEN_DUPLICATE | TOKEN_ASSIGN_PRIMARY | TOKEN_QUERY | TOKEN_ADJUST_DEFAULT;
    if (::OpenProcessToken(::GetCurrentProcess(), access, &own) == 0) {
        return failed("OpenProcessToken");
    }
    const KernelObject owner(own);
    HANDLE restricted = nullptr;
    if (::CreateRestrictedToken(
            own, DISABLE_MAX_PRIVILEGE | LUA_TOKEN, 0, nullptr, 0, nullptr, 0, nullptr, &restricted
        ) == 0) {
        return failed("CreateRestrictedToken");
    }
    KernelObject token(restricted);
    SID low{SID_REVISION, 1, SECURITY_MANDATORY_LABEL_AUTHORITY, {SECURITY_MANDATORY_LOW_RID}};
    TOKEN_MANDATORY_LABEL label{{&low, SE_GROUP_INTEGRITY}};
    if (::SetTokenInformation(token.raw(), TokenIntegrityLevel, &label, sizeof label) == 0) {
        return failed("SetTokenInformation");
    }
    return token;
}

Result<KernelObject> closed_job(std::size_t most_memory) {
    KernelObject job(::CreateJobObjectW(nullptr, nullptr));
    if (!job) {
        return failed("CreateJobObject");
    }
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    limits.BasicLimitInformation.LimitFlags =
        JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE | JOB_OBJECT_LIMIT_ACTIVE_PROCESS |
        JOB_OBJECT_LIMIT_PROCESS_MEMORY | JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION;
    limits.BasicLimitInformation.ActiveProcessLimit = 1;
    limits.ProcessMemoryLimit = most_memory;
    if (::SetInformationJobObject(
            job.raw(), JobObjectExtendedLimitInformation, &limits, sizeof limits
        ) == 0) {
        return failed("SetInformationJobObject");
    }
    JOBOBJECT_BASIC_UI_RESTRICTIONS screen{
        JOB_OBJECT_UILIMIT_HANDLES | JOB_OBJECT_UILIMIT_READCLIPBOARD |
        JOB_OBJECT_UILIMIT_WRITECLIPBOARD | JOB_OBJECT_UILIMIT_SYSTEMPARAMETERS |
        JOB_OBJECT_UILIMIT_DISPLAYSETTINGS | JOB_OBJECT_UILIMIT_GLOBALATOMS |
        JOB_OBJECT_UILIMIT_DESKTOP | JOB_OBJECT_UILIMIT_EXITWINDOWS
    };
    if (::SetInformationJobObject(
            job.raw(), JobObjectBasicUIRestrictions, &screen, sizeof screen
        ) == 0) {
        return failed("SetInformationJobObject");
    }
    return job;
}

/// What CreateProcess is told apart from names.
class Attributes {
public:
    Attributes(std::span<HANDLE> inherited, HANDLE job) : job_(job) {
        constexpr DWORD most = 3;
        SIZE_T size = 0;
        ::InitializeProcThreadAttributeList(nullptr, most, 0, &size);
        memory_.resize(size);
        good_ = ::InitializeProcThreadAttributeList(list(), most, 0, &size) != 0 &&
                ::UpdateProcThreadAttribute(
                    list(),
                    0,
                    PROC_THREAD_ATTRIBUTE_HANDLE_LIST,
                    inherited.data(),
                    inherited.size_bytes(),
                    nullptr,
                    nullptr
                ) != 0;
        // Windows before 1703 does not know it; the job says the same.
        ::UpdateProcThreadAttribute(
            list(), 0, child_process_policy, &policy_, sizeof policy_, nullptr, nullptr
        );
        // Born inside its job, the process goes with the daemon at any moment. Where the system
        // does not know it, start_confined() puts the process there before it runs.
        ::UpdateProcThreadAttribute(list(), 0, job_list, &job_, sizeof job_, nullptr, nullptr);
    }
    Attributes(const Attributes&) = delete;
    Attributes& operator=(const Attributes&) = delete;
    ~Attributes() {
        if (good_) {
            ::DeleteProcThreadAttributeList(list());
        }
    }
    bool good() const { return good_; }
    LPPROC_THREAD_ATTRIBUTE_LIST list() {
        return reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(memory_.data());
    }

private:
    std::vector<std::byte> memory_;
    DWORD policy_ = no_child_process;
    HANDLE job_;
    bool good_ = false;
};

bool put_into(HANDLE job, HANDLE process) {
    BOOL inside = FALSE;
    return (::IsProcessInJob(process, job, &inside) != 0 && inside != FALSE) ||
           ::AssignProcessToJobObject(job, process) != 0;
}

}  // namespace

Result<ConfinedProcess> start_confined(const ConfinementPlan& plan) {
    Result<KernelObject> token = low_token();
    if (!token) {
        return std::unexpected(token.error());
    }
    Result<KernelObject> job = closed_job(plan.most_memory);
    if (!job) {
        return std::unexpected(job.error());
    }
    Attributes attributes(plan.inherited, job->raw());
    if (!attributes.good()) {
        return failed("UpdateProcThreadAttribute");
    }
    STARTUPINFOEXW startup{};
    startup.StartupInfo.cb = sizeof startup;
    startup.lpAttributeList = attributes.list();
    std::wstring line = L'"' + plan.program.wstring() + L"\" " + plan.arguments;
    std::array<wchar_t, MAX_PATH> folder{};
    ::GetSystemDirectoryW(folder.data(), static_cast<UINT>(folder.size()));
    PROCESS_INFORMATION started{};
    if (::CreateProcessAsUserW(
            token->raw(),
            plan.program.c_str(),
            line.data(),
            nullptr,
            nullptr,
            TRUE,
            CREATE_SUSPENDED | CREATE_NO_WINDOW | EXTENDED_STARTUPINFO_PRESENT,
            nullptr,
            folder.data(),
            &startup.StartupInfo,
            &started
        ) == 0) {
        return failed("CreateProcessAsUser");
    }
    KernelObject process(started.hProcess);
    const KernelObject thread(started.hThread);
    if (!put_into(job->raw(), process.raw())) {
        const auto error = failed("AssignProcessToJobObject");
        ::TerminateProcess(process.raw(), 1);
        return error;
    }
    ::ResumeThread(thread.raw());
    return ConfinedProcess{std::move(*job), std::move(process)};
}

}  // namespace hyrax::win32
