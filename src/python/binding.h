#ifndef ARMTOL_PYTHON_BINDING_H
#define ARMTOL_PYTHON_BINDING_H

#include "1987/analysis.h"
#include "1987/program.h"
#include "armtol/arm.h"
#include "armtol/question.h"
#include "armtol/region.h"
#include "armtol/tables/arm_model.h"
#include "armtol/wish/accuracy.h"

#include <stdbool.h>
#include <stddef.h>

/*
 * What Python asks beside the library's public headers. Lengths are in the arm's unit, angles in radians. What a
 * routine returns has a routine that frees it, which takes NULL.
 */

/*
 * What reads says in messages what is wrong. They are kept from binding_listen to binding_said, which belong around
 * each call that is marked "messages"; one thread at a time.
 */
void binding_listen(void);

/* What was said since, a line each; it stays until the next binding_listen. */
const char *binding_said(void);

/*
 * Read an arm. Messages.
 *
 * Given:
 *    path           of a file, or a built-in arm's name; of a table in memory its name in messages
 *    text, length   a table in memory, of length > 0; NULL: the file is read
 *    base, tip      links of a URDF, NULL for those that nobody chose
 *    snap           of a URDF (armtol_links_of_axes)
 *    as_is          the frames of a table stay where they are
 *
 * Returned (function value):
 *    the arm; NULL after a message
 */
arm_model *binding_arm_read(const char *path, char *text, size_t length, const char *base, const char *tip, double snap,
                            bool as_is);
void binding_arm_free(arm_model *model);

/* The table of an arm, in radians, as --show writes it; NULL after a message. Messages. */
char *binding_arm_table(const armtol_arm *arm, bool craig);
void binding_text_free(char *text);

/*
 * The lists of --weights, --given, --tolerances and --drives: one value a column of A, or a link. False after a
 * message. Messages, as accuracy_parse has.
 */
bool binding_weights(const armtol_arm *arm, const char *text, double weights[]);
bool binding_given(const armtol_arm *arm, const char *text, double least[], double largest[]);
bool binding_tolerances(const armtol_arm *arm, const char *text, double tolerances[]);
bool binding_drives(const armtol_arm *arm, const char *text, armtol_drive drives[]);

/*
 * A region as --region has it: words, or a file of them.
 *
 * Returned (function value):
 *    the region; NULL after a message. Messages.
 */
typedef struct binding_region binding_region;
binding_region *binding_region_read(const armtol_arm *arm, const char *text, bool ignore_limits);
const armtol_region *binding_region_of(const binding_region *region);
void binding_region_free(binding_region *region);

/*
 * Say by how much drives and given tolerances exceed the accuracy, after ARMTOL_NOTHING_LEFT in `fault`. q and least
 * are those of the question, which has both. Messages.
 */
void binding_say_nothing_left(const armtol_question *question, double q[], double least[], bool is_given,
                              const armtol_fault *fault);

/*
 * Where the tool is in each pose.
 *
 * Given:
 *    tool         its frame is not looked at
 *    q, n_poses   n_poses x armtol_arm_joint_count
 *
 * Returned:
 *    frames       n_poses x 4 x 4, row-major
 *    *failed      the pose that the status is about
 *
 * Errors:
 *    those of armtol_arm_place; ARMTOL_NO_MEMORY
 */
armtol_status binding_forward(const armtol_arm *arm, const armtol_tool_point *tool, const double q[], size_t n_poses,
                              double frames[], size_t *failed);

/*
 * A of each pose: to the bit that of armtol_tool_matrix for the placed links.
 *
 * Given:
 *    q, n_poses   n_poses x armtol_arm_joint_count
 *
 * Returned:
 *    matrices     n_poses x 6 x n_columns, row-major
 *    *failed      the pose that the status is about
 *
 * Errors:
 *    those of armtol_arm_check
 *    ARMTOL_NOT_FINITE   a joint value, or the tool's offset; an A that overflows
 *    ARMTOL_NO_MEMORY
 */
armtol_status binding_matrices(const armtol_arm *arm, const armtol_tool_point *tool, const double q[], size_t n_poses,
                               double matrices[], size_t *failed);

/*
 * A run of intella or adpta, whose input is stored as theirs was.
 *
 * Given:
 *    wish                   program->robot->n_wish numbers
 *    accuracy, delta        as of analysis_tolerances
 *    residue                the words on the stack; NULL: those that the library works out
 *
 * Returned:
 *    *status                that of the step that failed
 *
 * Returned (function value):
 *    the run, with any status; NULL with ARMTOL_NO_MEMORY
 */
analysis *binding_run(const program *program, const double wish[], const double accuracy[6], double delta,
                      const armtol_errata *errata, const double residue[3], armtol_status *status);
void binding_run_free(analysis *run);

/* What one of the run's files says, 0 to 3 in their order (1987/report.h); NULL where memory is short. */
char *binding_run_file(const program *program, const analysis *run, int file);

#endif
