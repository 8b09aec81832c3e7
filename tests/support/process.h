#pragma once

#include <hachure/tests/support/temp_folder.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace hachure::test {

/// How a process ended and what it used.
struct ProcessResult {
    int exit_code = -1; ///< -1 when a signal ended it
    int signal = 0;     ///< 0 when it ended by itself
    std::string out;
    std::string err;
    double cpu_seconds = 0.0;
    double max_rss_mib = 0.0;
};

/// Arguments as main() and execv() take them; the texts must outlive them.
inline std::vector<char*> argument_pointers(const std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
    pointers.push_back(nullptr);
    return pointers;
}

/// A process that runs `work` beside the test, in `folder`, and exits with what it returns. CPU time without end kills
/// it, so that a test fails and does not hang. The test must have one thread when it makes a process.
class Process {
public:
    explicit Process(const std::function<int()>& work, const std::filesystem::path& folder = ".") {
        const std::string out = output_ / "out", err = output_ / "err", where = folder.string();
        std::fflush(nullptr);
        pid_ = ::fork();
        if (pid_ < 0) throw std::runtime_error("can't fork");
        if (pid_ == 0) run_child(work, out.c_str(), err.c_str(), where.c_str());
    }
    ~Process() {
        if (pid_ > 0) static_cast<void>(wait());
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    [[nodiscard]] ProcessResult wait() {
        int status = 0;
        rusage usage{};
        while (::wait4(pid_, &status, 0, &usage) < 0 && errno == EINTR) {
        }
        pid_ = -1;
        ProcessResult result;
        if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
        if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
        result.out = file_text(output_ / "out");
        result.err = file_text(output_ / "err");
        result.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
        result.max_rss_mib = static_cast<double>(usage.ru_maxrss) / 1024.0;
        return result;
    }

private:
    static constexpr rlim_t cpu_limit_s = 60;

    static double seconds(const timeval& time) {
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
    }

    [[noreturn]] static void run_child(const std::function<int()>& work, const char* out, const char* err,
                                       const char* folder) {
        const rlimit cpu{cpu_limit_s, cpu_limit_s};
        ::setrlimit(RLIMIT_CPU, &cpu);
        ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
        ::dup2(::open(out, O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
        ::dup2(::open(err, O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
        const int code = ::chdir(folder) == 0 ? work() : 127;
        std::fflush(nullptr);
        ::_exit(code);
    }

    TempFolder output_;
    pid_t pid_ = -1;
};

/// Runs a program to its end.
inline ProcessResult run_process(const std::vector<std::string>& command, const std::filesystem::path& folder = ".") {
    const std::vector<char*> arguments = argument_pointers(command);
    return Process([&] { return ::execv(arguments[0], arguments.data()); }, folder).wait();
}

} // namespace hachure::test
