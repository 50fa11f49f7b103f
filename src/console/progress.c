#include "console/progress.h"

#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

void progress_start(progress *progress, const char *what, uint64_t total)
{
    *progress = (struct progress){
        .terminal = isatty(STDERR_FILENO) == 1,
        .what = what,
        .total = total,
        .started = now(),
    };
    progress->shown = progress->started + 0.9; /* the first bar comes a tenth of a second later */
}

/* In the largest unit of which there are two. */
static void time_left(double seconds, char text[24])
{
    static const struct {
        const char *name;
        double seconds;
    } units[] = {{"d", 86400}, {"h", 3600}, {"min", 60}, {"s", 1}};
    size_t i = 0;
    while (units[i].seconds > 1 && seconds < 2 * units[i].seconds) {
        i++;
    }
    snprintf(text, 24, "%.0f %s left", seconds / units[i].seconds, units[i].name);
}

static void put_line(progress *progress, const char *line)
{
    const int width = (int)strlen(line);
    /* blanks over what a longer line before left */
    fprintf(stderr, "\r%s%*s", line, progress->width > width ? progress->width - width : 0, "");
    fflush(stderr);
    progress->width = progress->width > width ? progress->width : width;
}

static void draw(progress *progress, uint64_t done, double elapsed)
{
    enum { BAR = 20 };
    static const char full[] = "####################", empty[] = "....................";
    const double share = (double)done / (double)progress->total;
    const int cells = (int)(share * BAR);
    char left[24], line[160];
    time_left(elapsed * (1 - share) / share, left);
    snprintf(line, sizeof line, "[%.*s%.*s] %3d %%  %llu of %llu %s, %s", cells, full,
                               BAR - cells, empty, (int)(share * 100), (unsigned long long)done,
                               (unsigned long long)progress->total, progress->what, left);
    put_line(progress, line);
}

void progress_show(progress *progress, uint64_t done)
{
    if (!progress->terminal || done == 0) {
        return;
    }
    const double time = now();
    if (time >= progress->shown + 0.1) {
        progress->shown = time;
        draw(progress, done, time - progress->started);
    }
}

void progress_say(progress *progress, const char *text)
{
    const double time = progress->terminal ? now() : 0;
    if (progress->terminal && time >= progress->shown + 0.1) {
        progress->shown = time;
        put_line(progress, text);
    }
}

void progress_end(progress *progress)
{
    enum { ECHOED = 2 }; /* what the terminal puts behind the bar for Ctrl-C */
    if (progress->width > 0) {
        fprintf(stderr, "\r%*s\r", progress->width + ECHOED, "");
        fflush(stderr);
    }
    progress->width = 0;
}
