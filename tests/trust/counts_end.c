/*
 * Linked into the programs whose lines are counted: what counts (libgcov) writes its files when a program has ended,
 * and neither the faults that a test has set (tests/faults) nor a limit of files may hit that. Runs after main and
 * before libgcov, whose destructor has the priority 100.
 */

#define _GNU_SOURCE /* RTLD_DEFAULT, setenv */

#include "faults/fault.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <stddef.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

static void end_faults(void)
{
    static fault_outcome unseen;
    fault *plan = dlsym(RTLD_DEFAULT, "faulty_plan");
    fault_outcome **outcome = dlsym(RTLD_DEFAULT, "faulty_outcome");
    if (plan != NULL && outcome != NULL && *outcome != NULL) {
        *plan = (fault){0};
        *outcome = &unseen;
    }
}

/* Where that cannot be there is no place for this run's counts, and half of them would spoil those of other runs. */
static void end_limit(int resource, rlim_t enough)
{
    struct rlimit limit;
    if (getrlimit(resource, &limit) == 0 && limit.rlim_cur < enough) {
        limit.rlim_cur = limit.rlim_max;
        if (limit.rlim_max < enough || setrlimit(resource, &limit) != 0) {
            setenv("GCOV_PREFIX", "/dev/null", 1);
        }
    }
}

/* What libgcov has to say of counts that it cannot write is not the tested program's, which has said all it had to. */
static void end_messages(void)
{
    const int nowhere = open("/dev/null", O_WRONLY);
    if (nowhere >= 0) {
        dup2(nowhere, STDERR_FILENO);
    }
}

__attribute__((destructor)) static void end(void)
{
    end_messages();
    end_faults();
    end_limit(RLIMIT_FSIZE, RLIM_INFINITY);
    end_limit(RLIMIT_NOFILE, 64);
    end_limit(RLIMIT_AS, RLIM_INFINITY);
}
