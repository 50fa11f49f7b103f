/*
 * System calls: a seccomp filter turns those of interest into SIGSYS, and the handler makes them, or does not. Unlike
 * a routine of the name write this also sees what libc calls by itself, as its streams do.
 */

#define _GNU_SOURCE /* ucontext's registers, syscall */

#include "faults/faulty.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <stddef.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <ucontext.h>
#include <unistd.h>

/* In a sixth argument, which none of these calls has, it says that the call is ours. */
#define OURS 0x5ca1ab1eL

#if defined __x86_64__
#define THIS_MACHINE AUDIT_ARCH_X86_64
static const int registers[5] = {REG_RDI, REG_RSI, REG_RDX, REG_R10, REG_R8};

static long argument_of(const ucontext_t *context, int i)
{
    return (long)context->uc_mcontext.gregs[registers[i]];
}

static void set_result(ucontext_t *context, long result)
{
    context->uc_mcontext.gregs[REG_RAX] = result;
}
#elif defined __aarch64__
#define THIS_MACHINE AUDIT_ARCH_AARCH64

static long argument_of(const ucontext_t *context, int i)
{
    return (long)context->uc_mcontext.regs[i];
}

static void set_result(ucontext_t *context, long result)
{
    context->uc_mcontext.regs[0] = (unsigned long)result;
}
#else
#error "where a system call's arguments are is not known for this machine"
#endif

long faulty_call(long number, const long arguments[5])
{
    const int before = errno;
    const long result = syscall(number, arguments[0], arguments[1], arguments[2], arguments[3], arguments[4], OURS);
    const long answer = result < 0 ? -errno : result;
    errno = before;
    return answer;
}

/* ---- what becomes of a call ---- */

static bool is_standard(long descriptor)
{
    return descriptor >= 0 && descriptor <= STDERR_FILENO;
}

/* How many bytes may be written; less than none where writing fails. */
static long allowed(long descriptor, long wanted)
{
    const bool output = descriptor == STDOUT_FILENO, file = !is_standard(descriptor);
    long room = wanted;
    if (output && faulty_plan.output_full) {
        room = faulty_plan.output_room;
    } else if (file && faulty_plan.disk_full) {
        room = faulty_plan.disk_room;
    }
    if (room == 0 && wanted > 0) {
        faulty_outcome->happened = true;
        return -ENOSPC;
    }
    const long most = faulty_plan.short_writes ? 1 : wanted;
    const long taken = room < most ? room : most;
    faulty_plan.output_room -= output ? taken : 0;
    faulty_plan.disk_room -= file ? taken : 0;
    return taken;
}

static long make_write(const long arguments[5])
{
    const long taken = allowed(arguments[0], arguments[2]);
    if (taken < 0) {
        return taken;
    }
    const long shorter[5] = {arguments[0], arguments[1], taken, 0, 0};
    const long written = faulty_call(SYS_write, shorter);
    if (written > 0 && !is_standard(arguments[0])) {
        faulty_outcome->bytes += written;
    }
    return written;
}

/* Only the first piece that holds something: it may always be less than all. */
static long make_writev(const long arguments[5])
{
    const struct iovec *pieces = (const struct iovec *)arguments[1];
    for (long i = 0; i < arguments[2]; i++) {
        if (pieces[i].iov_len > 0) {
            const long one[5] = {arguments[0], (long)pieces[i].iov_base, (long)pieces[i].iov_len, 0, 0};
            return make_write(one);
        }
    }
    return 0;
}

static long make(long number, const long arguments[5])
{
    switch (number) {
    case SYS_write:
        return make_write(arguments);
    case SYS_writev:
        return make_writev(arguments);
    case SYS_fsync:
        /* a disk takes long, and no machine stops here; drafts only are synchronised */
        faulty_outcome->low = faulty_outcome->low || is_standard(arguments[0]);
        return 0;
    default:
        return faulty_call(number, arguments);
    }
}

static void send_signal(int number)
{
    const long arguments[5] = {(long)getpid(), number, 0, 0, 0};
    faulty_call(SYS_kill, arguments);
}

static long fail_at_call(long number, const long arguments[5])
{
    faulty_outcome->happened = true;
    switch (faulty_plan.action) {
    case ACTION_HALF_KILL:
        if (number == SYS_write) {
            const long half[5] = {arguments[0], arguments[1], arguments[2] / 2, 0, 0};
            make_write(half);
        }
        send_signal(SIGKILL);
        return 0;
    case ACTION_KILL:
        send_signal(SIGKILL);
        return 0;
    case ACTION_SIGNAL:
        send_signal(faulty_plan.number);
        return make(number, arguments);
    default:
        return -faulty_plan.number;
    }
}

/* Opening to read and closing what was opened so changes nothing, but the latter cannot be told: it counts. */
static bool counts(long number, const long arguments[5])
{
    return number != SYS_openat || (arguments[2] & (O_WRONLY | O_RDWR)) != 0;
}

static void on_call(int signal_number, siginfo_t *info, void *context)
{
    const long number = info->si_syscall;
    long arguments[5], result;
    (void)signal_number;
    for (int i = 0; i < 5; i++) {
        arguments[i] = argument_of(context, i);
    }
    if (counts(number, arguments) && ++faulty_outcome->calls == faulty_plan.call) {
        result = fail_at_call(number, arguments);
    } else {
        result = make(number, arguments);
    }
    set_result(context, result);
}

/* ---- the filter ---- */

static const int of_interest[] = {
    SYS_write, SYS_writev, SYS_openat, SYS_close, SYS_fsync, SYS_fdatasync, SYS_ftruncate,
    SYS_linkat, SYS_unlinkat, SYS_renameat2,
#ifdef SYS_renameat
    SYS_renameat,
#endif
#ifdef SYS_open
    SYS_open, SYS_creat, SYS_rename, SYS_link, SYS_unlink,
#endif
};

enum { INTERESTS = sizeof of_interest / sizeof of_interest[0] };

#define LOAD(field) BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, field))
#define UNLESS(value, skipped) BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (value), 0, (skipped))
#define GIVE(answer) BPF_STMT(BPF_RET | BPF_K, (answer))

static void install(void)
{
    struct sock_filter filter[8 + 2 * INTERESTS];
    unsigned short n = 0;
    filter[n++] = (struct sock_filter)LOAD(arch);
    filter[n++] = (struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, THIS_MACHINE, 1, 0);
    filter[n++] = (struct sock_filter)GIVE(SECCOMP_RET_KILL_PROCESS);
    filter[n++] = (struct sock_filter)LOAD(args[5]);
    filter[n++] = (struct sock_filter)UNLESS(OURS, 1);
    filter[n++] = (struct sock_filter)GIVE(SECCOMP_RET_ALLOW);
    filter[n++] = (struct sock_filter)LOAD(nr);
    for (size_t i = 0; i < INTERESTS; i++) {
        filter[n++] = (struct sock_filter)UNLESS((unsigned)of_interest[i], 1);
        filter[n++] = (struct sock_filter)GIVE(SECCOMP_RET_TRAP);
    }
    filter[n++] = (struct sock_filter)GIVE(SECCOMP_RET_ALLOW);
    const struct sock_fprog program = {n, filter};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) < 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) < 0) {
        _exit(126);
    }
}

void faulty_calls_start(void)
{
    const struct sigaction handing = {.sa_sigaction = on_call, .sa_flags = SA_SIGINFO};
    sigaction(SIGSYS, &handing, NULL);
    install();
}
