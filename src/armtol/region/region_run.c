#include "armtol/region/region_run.h"

#include "armtol/region/region_words.h"
#include "console/exit_code.h"
#include "console/interrupt.h"
#include "console/message.h"
#include "console/progress.h"

#include <stdio.h>

static bool look_on(void *context, double open, uint64_t boxes)
{
    char text[80];
    snprintf(text, sizeof text, "gap %.2f %%, %llu boxes", 100 * open, (unsigned long long)boxes);
    progress_say(context, text);
    return !interrupt_came();
}

/* ---- what is wrong ---- */

static int failed_for(armtol_region_fault why, const request *request, const armtol_fault *fault)
{
    static const char *const shapes[] = {"box", "cylinder", "path", "direction"};
    const char *arm = request->arm.name;
    switch (why) {
    case ARMTOL_REGION_EMPTY:
        message("--region: no pose of %s is in it: its tool is nowhere there within these ranges of the joints", arm);
        break;
    case ARMTOL_REGION_NOT_FOUND:
        message("--region: no pose of %s was found in it; --most has the boxes to look for one", arm);
        return EXIT_FAILED;
    case ARMTOL_REGION_METHOD:
        message("--method sphere is for poses; expected worst or rss with --region");
        break;
    case ARMTOL_REGION_DISCS:
        message("--region: alpha and beta of a drawing move in a disc, which is not bounded over a region; expected "
                "poses, or the two in --given or --tolerances, as a square");
        break;
    case ARMTOL_REGION_SHAPE:
        message("--region: the %s is none", shapes[fault->number]);
        break;
    default:
        message("--region: joint %zu has no range", fault->number + 1);
    }
    return EXIT_WRONG;
}

static int failed(const request *request, const armtol_fault *fault, armtol_region_fault why)
{
    if (why != ARMTOL_REGION_FINE) {
        return failed_for(why, request, fault);
    }
    if (fault->status == ARMTOL_NOTHING_LEFT) {
        message("no tolerances: in some pose of the region %s", armtol_status_text(fault->status));
        return EXIT_WRONG;
    }
    if (fault->status == ARMTOL_UNBOUNDED) {
        message("--region: %s of what is asked there", armtol_status_text(fault->status));
        return EXIT_WRONG;
    }
    return request_failed(request, fault);
}

/* ---- the answer ---- */

static armtol_status answer_watched(const request *request, const armtol_region *region, armtol_region_answer **answer,
                                    armtol_fault *fault, armtol_region_fault *why)
{
    progress bar;
    struct sigaction before;
    const cli_options *options = request->options;
    const armtol_enclosing how = {.gap = options->gap, .most = options->most, .progress = look_on, .context = &bar};
    progress_start(&bar, "boxes", 1);
    interrupt_watch(&before);
    const armtol_status status = armtol_region_answer_create(&request->question, region, &how, answer, fault, why);
    interrupt_restore(&before);
    progress_end(&bar);
    return status;
}

int region_run(request *request, armtol_region_answer **answer)
{
    region_words words;
    armtol_fault fault;
    armtol_region_fault why;
    const cli_options *options = request->options;
    int code = EXIT_WRONG;
    if (region_words_take(options->region, &request->arm, &request->units, options->ignore_limits, &words)) {
        const bool fine = answer_watched(request, &words.region, answer, &fault, &why) == ARMTOL_OK;
        code = fine ? EXIT_OK : failed(request, &fault, why);
    }
    region_words_free(&words);
    if (code == EXIT_OK) {
        request->q = (*answer)->q;
        (*answer)->q = NULL;
        request->question.q = request->q;
        request->question.n_poses = (*answer)->n_poses;
    }
    return code;
}

int region_exit_code(const request *request, const armtol_region_answer *answer)
{
    const double gap = 100 * request->options->gap;
    switch (answer->ended) {
    case ARMTOL_ENDED_MOST:
        message("--most: %llu boxes were not enough for a gap of %g %%; what is proved is told",
                (unsigned long long)request->options->most, gap);
        return EXIT_FAILED;
    case ARMTOL_ENDED_CALLER:
        message("interrupted before the gap was %g %%; what is proved is told", gap);
        return EXIT_FAILED;
    default:
        return EXIT_OK;
    }
}
