#pragma once

#include <hachure/tests/support/process.h>
#include <hachure/tests/support/temp_folder.h>

#include <netinet/in.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace hachure::test {

/// A cluster of one node with a configuration of its own, in a temporary folder: a controller and a node's daemon that
/// live as long as this does. It needs root and Slurm's programs; `ready` says whether it came to work.
class SlurmCluster {
public:
    SlurmCluster() {
        if (::geteuid() != 0) fail("needs root");
        for (const char* program : {"slurmctld", "slurmd", "sbatch", "sinfo", "squeue"})
            if (run_process({"/bin/sh", "-c", std::string("command -v ") + program}).exit_code != 0)
                fail(std::string(program) + " is not installed");
        if (ready()) begin();
    }
    ~SlurmCluster() {
        stop(node_);
        stop(controller_);
        ::unsetenv("SLURM_CONF");
    }
    SlurmCluster(const SlurmCluster&) = delete;
    SlurmCluster& operator=(const SlurmCluster&) = delete;

    /// Programs that ask for the cluster find it while it lives.
    [[nodiscard]] bool ready() const { return reason_.empty(); }

    /// Why it is not ready.
    [[nodiscard]] const std::string& reason() const { return reason_; }

    /// Waits until no job is left; false after half a minute. (`sbatch --wait` looks only every few seconds.)
    [[nodiscard]] bool finish() const {
        for (int i = 0; i < 300; ++i) {
            if (run_process({"/usr/bin/env", "squeue", "-h"}).out.empty()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        return false;
    }

private:
    void fail(std::string reason) { reason_ = std::move(reason); }

    void begin() {
        write_configuration();
        ::setenv("SLURM_CONF", (folder_ / "slurm.conf").c_str(), 1);
        controller_ = start({"slurmctld", "-D", "-c"});
        node_ = start({"slurmd", "-D", "-N", "node"});
        wait_until_idle();
    }

    /// A port that nobody listens on now.
    static std::string free_port() {
        const int handle = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof(address);
        ::bind(handle, reinterpret_cast<sockaddr*>(&address), size);
        ::getsockname(handle, reinterpret_cast<sockaddr*>(&address), &size);
        ::close(handle);
        return std::to_string(ntohs(address.sin_port));
    }

    /// Everything below the folder; no other daemon (munge, a database) takes part.
    void write_configuration() const {
        char host[256] = {};
        ::gethostname(host, sizeof(host) - 1);
        const std::string name = std::string(host).substr(0, std::string(host).find('.'));
        const std::string at = folder_.path().string();
        std::filesystem::create_directory(folder_ / "state");
        std::filesystem::create_directory(folder_ / "spool");
        folder_.write("slurm.conf", "ClusterName=test\nSlurmctldHost=" + name + "(127.0.0.1)\n" +
                                        "SlurmUser=root\nSlurmdUser=root\nAuthType=auth/none\nCredType=cred/none\n" +
                                        "SlurmctldPort=" + free_port() + "\nSlurmdPort=" + free_port() + "\n" +
                                        "SlurmctldPidFile=" + at + "/controller.pid\nSlurmdPidFile=" + at +
                                        "/node.pid\nStateSaveLocation=" + at + "/state\nSlurmdSpoolDir=" + at +
                                        "/spool\nProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\n" +
                                        "JobAcctGatherType=jobacct_gather/none\nMpiDefault=none\nReturnToService=2\n" +
                                        "SelectType=select/cons_tres\nSelectTypeParameters=CR_CPU\n" +
                                        "SchedulerParameters=sched_interval=1,batch_sched_delay=0\n" +
                                        "SlurmdParameters=config_overrides\n" + "NodeName=node NodeHostname=" + name +
                                        " NodeAddr=127.0.0.1 CPUs=4\nPartitionName=all Nodes=ALL Default=YES\n");
    }

    pid_t start(const std::vector<std::string>& command) {
        const std::string log = folder_ / (command[0] + ".log");
        const pid_t parent = ::getpid();
        const pid_t child = ::fork();
        if (child != 0) return child;
        ::prctl(PR_SET_PDEATHSIG, SIGTERM); // not even a crash of the test leaves it behind
        if (::getppid() != parent || !std::freopen(log.c_str(), "w", stdout) || ::dup2(1, 2) < 0) ::_exit(127);
        ::execvp(command[0].c_str(), argument_pointers(command).data());
        ::_exit(127);
    }

    static void stop(pid_t process) {
        if (process <= 0) return;
        ::kill(process, SIGTERM);
        for (int i = 0; i < 500; ++i) {
            if (::waitpid(process, nullptr, WNOHANG) != 0) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        ::kill(process, SIGKILL);
        ::waitpid(process, nullptr, 0);
    }

    /// Whether it has ended by itself, as where the kernel or a container denies what it needs.
    static bool has_ended(pid_t& process) {
        if (::waitpid(process, nullptr, WNOHANG) == 0) return false;
        process = -1;
        return true;
    }

    void wait_until_idle() {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(15);
        std::string state;
        while (std::chrono::steady_clock::now() < end && !has_ended(controller_) && !has_ended(node_)) {
            state = run_process({"/usr/bin/timeout", "5", "sinfo", "-h", "-o", "%T"}).out;
            if (state == "idle\n") return;
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        fail("the node does not come up here: it is '" + state + "'\n" + file_text(folder_ / "slurmctld.log") +
             file_text(folder_ / "slurmd.log"));
    }

    TempFolder folder_;
    std::string reason_;
    pid_t controller_ = -1, node_ = -1;
};

} // namespace hachure::test
