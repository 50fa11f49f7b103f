#include "armtol/against/against.h"

#include "armtol/ask/arm_source.h"
#include "armtol/names/link_name.h"
#include "console/exit_code.h"
#include "console/message.h"

#include <stdlib.h>

bool against_is_asked(const cli_options *options)
{
    return options->against != NULL || options->deviations != NULL;
}

/* ---- the other arm ---- */

static int read_other(against *against)
{
    cli_options options = *against->request->options;
    options.arm = options.against;
    const int code = arm_source_read(&options, &against->model);
    if (code == EXIT_OK && !arm_model_convert(&against->model, against->request->units.arm)) {
        arm_model_free(&against->model);
        return EXIT_WRONG;
    }
    return code;
}

static bool read_deviations(const request *request, double deviations[])
{
    const parameter_table table = {.value = "deviation", .signed_allowed = true};
    return request_read_parameters(request, "--deviations: ", request->options->deviations, table, deviations);
}

/* The links of the arm, off by that. */
static void deviate(const request *request, const double deviations[], armtol_link links[])
{
    for (size_t k = 0; k < request->n_columns; k++) {
        const armtol_column column = request->columns[k];
        const bool is_length = armtol_parameter_is_length(column.parameter);
        *armtol_link_parameter(&links[column.link], column.parameter) +=
            units_taken(&request->units, is_length, deviations[k]);
    }
}

/* The same arm with what is said of its parameters. */
static int make_other(against *against, const arm_model *model)
{
    const request *request = against->request;
    double *deviations = calloc(request->n_columns + 1, sizeof *deviations);
    armtol_link *links = calloc(request->arm.n_links, sizeof *links);
    armtol_arm arm = model->arm;
    int code = EXIT_FAILED;
    if (deviations == NULL || links == NULL) {
        out_of_memory();
    } else if (!read_deviations(request, deviations)) {
        code = EXIT_WRONG;
    } else {
        for (size_t i = 0; i < arm.n_links; i++) {
            links[i] = model->arm.links[i];
        }
        deviate(request, deviations, links);
        arm.links = links;
        code = arm_model_make(&against->model, &arm, model->angle_unit) ? EXIT_OK : EXIT_FAILED;
    }
    free(deviations);
    free(links);
    return code;
}

/* ---- what differs ---- */

static size_t first_joint_apart(const armtol_arm *meant, const armtol_arm *other)
{
    size_t i = 0;
    while (i + 1 < meant->n_links && meant->links[i].joint == other->links[i].joint) {
        i++;
    }
    return i;
}

static bool say_unlike(const against *against, armtol_status status)
{
    const armtol_arm *meant = &against->request->arm, *other = &against->model.arm;
    if (status == ARMTOL_WRONG_SIZE) {
        message("--against: %s has %zu links, and %s has %zu; expected the same number", against->other, other->n_links,
                meant->name, meant->n_links);
    } else if (status == ARMTOL_BAD_JOINT) {
        const size_t link = first_joint_apart(meant, other);
        message(meant->links[link].joint != other->links[link].joint
                    ? "--against: %s: the joint of %s is not of the same kind as that of %s"
                    : "--against: %s: the joint of %s, or one behind it, does not move as that of %s: another "
                      "sign, or coupled",
                against->other, link_words(meant, link, &(link_text){""}), meant->name);
    } else {
        message("--against: %s: %s", against->other, armtol_status_text(status));
    }
    return false;
}

static bool find_differences(against *against)
{
    const size_t n_links = against->request->arm.n_links;
    against->work = calloc(n_links, sizeof *against->work);
    against->differences = calloc(n_links, ARMTOL_PARAMETER_COUNT * sizeof *against->differences);
    against->explained = calloc(n_links, 6 * ARMTOL_PARAMETER_COUNT * sizeof *against->explained);
    if (against->work == NULL || against->differences == NULL || against->explained == NULL) {
        out_of_memory();
        return false;
    }
    const armtol_arm *meant = &against->request->arm, *other = &against->model.arm;
    const armtol_status status = armtol_arm_differences(meant, other, against->differences, &against->n_differences);
    return status == ARMTOL_OK || say_unlike(against, status);
}

void against_pose(against *against, size_t pose, double error[6])
{
    const armtol_question *question = &against->request->question;
    const size_t n_joints = armtol_arm_joint_count(question->arm);
    armtol_arm_compare(question->arm, &against->model.arm, question->q + pose * n_joints, n_joints, &question->tool,
                       against->differences, against->n_differences, against->work, error, against->explained);
}

/* A pose that overflows in either arm is found before anything is printed. */
static bool check_poses(against *against)
{
    const armtol_question *question = &against->request->question;
    const size_t n_joints = armtol_arm_joint_count(question->arm);
    armtol_status status = ARMTOL_OK;
    for (size_t pose = 0; pose < question->n_poses && status == ARMTOL_OK; pose++) {
        const double *const q = question->q + pose * n_joints;
        status = armtol_arm_place(question->arm, q, n_joints, against->work);
        status = status == ARMTOL_OK ? armtol_arm_place(&against->model.arm, q, n_joints, against->work) : status;
        if (status != ARMTOL_OK) {
            message("--against: %s, pose %zu: %s", against->other, pose + 1, armtol_status_text(status));
        }
    }
    return status == ARMTOL_OK;
}

static int tell(against *against)
{
    against_summary summary;
    bool fine = against_summarise(against, &summary);
    if (fine && against->request->options->format == OUTPUT_JSON) {
        against_json(against, &summary);
    } else if (fine) {
        fine = against_text(against, &summary);
    }
    free(summary.shares);
    return fine ? EXIT_OK : EXIT_FAILED;
}

int against_run(const request *request, const arm_model *model)
{
    const cli_options *options = request->options;
    against against = {.request = request, .other = options->against != NULL ? options->against : options->deviations};
    int code = options->against != NULL ? read_other(&against) : make_other(&against, model);
    if (code != EXIT_OK) {
        return code;
    }
    code = find_differences(&against) && check_poses(&against) ? tell(&against) : EXIT_WRONG;
    free(against.work);
    free(against.differences);
    free(against.explained);
    arm_model_free(&against.model);
    return code;
}
