#include <hachure/editor/frame_stats.h>
#include <hachure/editor/interrupt.h>
#include <hachure/editor/play/play_pool.h>
#include <hachure/editor/play/play_result_json.h>
#include <hachure/editor/play/play_runner.h>
#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/error.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <list>
#include <memory>
#include <optional>
#include <thread>

namespace hachure::play {
namespace {

constexpr std::size_t max_log_lines = 1000;
constexpr std::chrono::milliseconds poll_interval{3};

std::vector<std::string> lines_of(const std::filesystem::path& file) {
    std::vector<std::string> lines;
    std::ifstream stream(file);
    for (std::string line; lines.size() < max_log_lines && std::getline(stream, line);)
        lines.push_back(std::move(line));
    return lines;
}

/// A test in a process of its own.
class Worker {
public:
    Worker(std::size_t index, const std::filesystem::path& file, const PoolOptions& options)
        : index_(index), file_(file), result_(options.folder / fmt::format("{}.json", index)),
          log_(options.folder / fmt::format("{}.log", index)) {
        std::vector<std::string> command{"hachure", "play", "--worker", result_.string()};
        if (options.evidence) {
            const std::filesystem::path evidence = options.folder / std::to_string(index);
            std::filesystem::create_directories(evidence);
            command.insert(command.end(), {"--evidence", evidence.string()});
        }
        command.insert(command.end(), options.options.begin(), options.options.end());
        command.insert(command.end(), {"--", file.string()});
        start(command);
    }

    ~Worker() {
        if (pid_ <= 0) return;
        ::kill(pid_, SIGKILL);
        while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    [[nodiscard]] std::size_t index() const { return index_; }

    /// The result, when the process has ended or has had its time.
    std::optional<PlayResult> poll(double limit_s) {
        int status = 0;
        const pid_t ended = ::waitpid(pid_, &status, WNOHANG);
        if (ended == pid_) {
            pid_ = -1;
            return finished(status);
        }
        if (1e-3 * clock_.milliseconds() < limit_s) return std::nullopt;
        ::kill(pid_, SIGKILL);
        while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
        }
        pid_ = -1;
        return failed(fmt::format("it had not ended after {:.4g} s and was stopped", limit_s));
    }

private:
    void start(const std::vector<std::string>& command) {
        std::vector<char*> arguments;
        for (const std::string& text : command) arguments.push_back(const_cast<char*>(text.c_str()));
        arguments.push_back(nullptr);
        const std::string log = log_.string();
        pid_ = ::fork();
        if (pid_ < 0) throw Error(file_.string(), "no process could be started", std::strerror(errno));
        if (pid_ == 0) become(arguments, log.c_str());
    }

    /// In the new process: nothing but system calls.
    [[noreturn]] static void become(const std::vector<char*>& arguments, const char* log) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        const int out = ::open(log, O_WRONLY | O_CREAT | O_TRUNC, 0600), in = ::open("/dev/null", O_RDONLY);
        ::dup2(in, STDIN_FILENO);
        ::dup2(out, STDOUT_FILENO);
        ::dup2(out, STDERR_FILENO);
        ::execv("/proc/self/exe", arguments.data());
        ::_exit(127);
    }

    PlayResult finished(int status) {
        if (WIFSIGNALED(status)) return failed(fmt::format("it crashed: {}", ::strsignal(WTERMSIG(status))));
        try {
            std::ifstream stream(result_);
            PlayResult result = result_from_json(nlohmann::json::parse(stream));
            result.log = lines_of(log_);
            return result;
        } catch (const nlohmann::json::exception&) {
            return failed(fmt::format("its process ended with {} and no result", WEXITSTATUS(status)));
        }
    }

    /// With the last words of the process.
    PlayResult failed(std::string reason) {
        PlayResult result;
        result.file = file_;
        result.seconds = 1e-3 * clock_.milliseconds();
        result.log = lines_of(log_);
        if (!result.log.empty()) reason += "; it last said: " + result.log.back();
        result.error = std::move(reason);
        result.replay = "hachure play " + std::filesystem::absolute(file_).string();
        return result;
    }

    std::size_t index_;
    std::filesystem::path file_, result_, log_;
    FrameClock clock_;
    pid_t pid_ = -1;
};

} // namespace

std::vector<PlayResult> play_in_processes(std::span<const std::filesystem::path> files, const PoolOptions& options,
                                          const std::function<void(const PlayResult&)>& done) {
    std::vector<std::optional<PlayResult>> results(files.size());
    std::list<Worker> workers;
    std::size_t started = 0, told = 0;
    while (told < files.size()) {
        stop_when_interrupted();
        while (started < files.size() && workers.size() < static_cast<std::size_t>(options.jobs)) {
            workers.emplace_back(started, files[started], options);
            ++started;
        }
        workers.remove_if([&](Worker& worker) {
            std::optional<PlayResult> result = worker.poll(options.limit_s);
            if (!result) return false;
            results[worker.index()] = std::move(result);
            return true;
        });
        for (; told < files.size() && results[told]; ++told) done(*results[told]);
        if (told < files.size()) std::this_thread::sleep_for(poll_interval);
    }
    std::vector<PlayResult> all;
    for (std::optional<PlayResult>& result : results) all.push_back(std::move(*result));
    return all;
}

void play_as_worker(const std::filesystem::path& file, const PlayOptions& options,
                    const std::filesystem::path& result_file) {
    // Text of files and drivers may be no UTF-8.
    const std::string text =
        to_json(run_play(file, options)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    assets::write_file_atomically(result_file, std::as_bytes(std::span(text.data(), text.size())));
}

} // namespace hachure::play
