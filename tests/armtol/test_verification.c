/* Arms drawn and corners searched: closed forms, threads, interrupts, and the bar. */

#include "armtol/engine/verification_interrupt.h"
#include "armtol/engine/verification_tally.h"
#include "armtol/one_link.h"
#include "armtol/robots.h"
#include "armtol/sampler.h"
#include "armtol/tool_error.h"
#include "support/check.h"
#include "support/process.h"
#include "support/random.h"

#include "unity.h"

#include <math.h>
#include <signal.h>
#include <string.h>
#include <time.h>

static const double pi = 3.14159265358979323846;

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

static verification run(const verification_task *task)
{
    verification found;
    memset(&found, 0, sizeof found);
    TEST_ASSERT_TRUE(verification_run(task, &found));
    return found;
}

/* ---- tallies ---- */

static const tally_limits limits_of_one = {
    .range = {1, 1, 1, 1, 1, 1}, .accuracy = {1, 1, 1, 1, 1, 1}, .beyond = {2, 2, 2, 2, 2, 2}};
static tally counted, other;

/* Arms whose first component has these magnitudes and whose others are 0. */
static void add(tally *tally, const tally_limits *limits, uint64_t first, size_t count,
                const double first_component[])
{
    double magnitudes[6 * TALLY_MOST] = {0};
    memcpy(magnitudes, first_component, count * sizeof *magnitudes);
    tally_add(tally, limits, first, count, magnitudes);
}

static void test_quantiles_are_counted(void)
{
    double tenths[10];
    tally_start(&counted);
    check_same(0, tally_quantile(&counted, &limits_of_one, 0, 500), "of none");
    for (int i = 0; i < 10; i++) {
        tenths[i] = 0.1 * (i + 1) - 1e-9;
    }
    add(&counted, &limits_of_one, 0, 10, tenths);
    const double bin = 1.0 / TALLY_BINS;
    check_within(bin, 0.5 + bin / 2, tally_quantile(&counted, &limits_of_one, 0, 500), "median");
    check_within(bin, 0.6 + bin / 2, tally_quantile(&counted, &limits_of_one, 0, 501), "50.1 %%");
    check_same(tenths[9], tally_quantile(&counted, &limits_of_one, 0, 1000), "all");
    check_same(0, tally_quantile(&counted, &limits_of_one, 1, 500), "a component of zeros");
    TEST_ASSERT_TRUE(tally_quantile(&counted, &limits_of_one, 0, 500) >= tenths[4]);
}

static void test_what_is_within_and_what_beyond(void)
{
    const double magnitudes[7] = {0, 1, 1.5, 2, 2.5, NAN, INFINITY};
    tally_start(&counted);
    add(&counted, &limits_of_one, 0, 7, magnitudes);
    TEST_ASSERT_TRUE(counted.drawn == 7 && counted.within == 2 && counted.beyond == 3);
    tally_limits free_row = limits_of_one;
    free_row.accuracy[0] = free_row.beyond[0] = INFINITY;
    tally_start(&counted);
    add(&counted, &free_row, 0, 5, magnitudes);
    TEST_ASSERT_TRUE(counted.drawn == 5 && counted.within == 5 && counted.beyond == 0);
}

/* Rounding may take a magnitude beyond the range, and the range may be nothing. */
static void test_magnitudes_out_of_range(void)
{
    const double magnitudes[3] = {0, 0.5, 1 + 1e-15};
    tally_limits nothing = limits_of_one;
    nothing.range[0] = 0;
    tally_start(&counted);
    add(&counted, &limits_of_one, 0, 3, magnitudes);
    check_same(1 + 1e-15, tally_quantile(&counted, &limits_of_one, 0, 999), "beyond the range");
    tally_start(&counted);
    add(&counted, &nothing, 0, 3, magnitudes);
    check_same(1 + 1e-15, tally_quantile(&counted, &nothing, 0, 500), "no range");
}

static void test_the_first_of_the_worst_wins(void)
{
    const double late[3] = {0.5, 0.9, 0.9}, early[2] = {0.1, 0.9};
    for (int order = 0; order < 2; order++) {
        tally_start(&counted);
        tally_start(&other);
        add(&counted, &limits_of_one, 100, 3, late);
        add(&other, &limits_of_one, 7, 2, early);
        tally *into = order == 0 ? &counted : &other;
        tally_merge(into, order == 0 ? &other : &counted);
        TEST_ASSERT_TRUE(into->worst_arm[0] == 8 && into->worst_arm[1] == 7 && into->drawn == 5);
        check_same(0.9, into->worst[0], "worst");
        check_within(1.0 / TALLY_BINS, 0.5, tally_quantile(into, &limits_of_one, 0, 400), "both are counted");
    }
}

/* ---- closed forms ---- */

enum { DRAWS = 200000 };

static void check_share(double expected, const verification *found, const char *what)
{
    const double deviation = sqrt(expected * (1 - expected) / (double)found->drawn);
    check_within(5 * deviation, expected, (double)found->within / (double)found->drawn, "%s", what);
    const double width = found->share_high - found->share_low;
    TEST_ASSERT_TRUE(found->share_low <= expected + 5 * deviation);
    TEST_ASSERT_TRUE(found->share_high >= expected - 5 * deviation);
    TEST_ASSERT_TRUE(width > 0 && width < 5 * deviation);
}

/* The rotation about z is the error of theta, uniform within 0.004. */
static void test_one_uniform_error(void)
{
    one_link one;
    verification_task task = one_link_task(&one, DRAWS);
    const double accuracy[6] = {INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, 0.001};
    task.accuracy = accuracy;
    const verification found = run(&task);
    const verified_component *turn = &found.components[5];
    TEST_ASSERT_TRUE(found.drawn == DRAWS);
    check_share(0.25, &found, "a quarter of the tolerance");
    TEST_ASSERT_TRUE(found.beyond == found.drawn - found.within); /* a single turn has no remainder */
    check_same(0.004, turn->prediction, "prediction");
    check_within(1e-18, 0.004, turn->rss, "rss");
    check_same(0, turn->remainder, "remainder");
    check_within(1e-16, 0.004, turn->worst_corner, "worst corner");
    TEST_ASSERT_TRUE(turn->worst_drawn < 0.004 && turn->worst_drawn > 0.004 * (1 - 20.0 / DRAWS));
    for (int i = 0; i < VERIFICATION_QUANTILES; i++) {
        const double q = verification_quantiles[i];
        const double deviation = 0.004 * sqrt(q * (1 - q) / DRAWS);
        check_within(5 * deviation + 0.004 / 4096, 0.004 * q, turn->quantiles[i], "quantile %d", i);
    }
}

static double turn_of_arm(const verification_task *task, uint64_t arm)
{
    armtol_sampled_link prepared[1];
    armtol_sampler sampler;
    double errors[4];
    const armtol_status status =
        armtol_sampler_start(&sampler, prepared, task->poses, task->n_links, task->tolerances,
                             task->n_columns, &task->tool, task->seed);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, status);
    armtol_sampler_parameters(&sampler, arm, errors);
    return errors[0];
}

static void test_the_worst_arm_can_be_had_again(void)
{
    one_link one;
    const verification_task task = one_link_task(&one, 10000);
    const verification found = run(&task);
    const verified_component *turn = &found.components[5];
    TEST_ASSERT_TRUE(turn->worst_arm < 10000);
    check_within(1e-15, turn->worst_drawn, fabs(turn_of_arm(&task, turn->worst_arm)), "worst arm");
    for (uint64_t arm = 0; arm < turn->worst_arm; arm++) {
        TEST_ASSERT_TRUE(fabs(turn_of_arm(&task, arm)) < turn->worst_drawn);
    }
}

/* The sum of two uniform errors is within x of their 2 t with 1 - (1 - x)^2. */
static void test_two_uniform_errors(void)
{
    const armtol_link links[2] = {{ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 300},
                                  {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 200}};
    const double tolerances[8] = {[0] = 0.002, [4] = 0.002};
    const double accuracy[6] = {INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, 0.001};
    double matrix[6 * 8];
    one_link one;
    verification_task task = one_link_task(&one, DRAWS);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_error_matrix(links, 2, &armtol_errata_none, matrix, 8));
    task.poses = links;
    task.n_links = 2;
    task.matrices = matrix;
    task.tolerances = tolerances;
    task.n_columns = 8;
    task.accuracy = accuracy;
    const verification found = run(&task);
    check_share(1 - 0.75 * 0.75, &found, "of a triangle");
    for (int i = 0; i < 2; i++) {
        const double q = verification_quantiles[i], x = 1 - sqrt(1 - q), slope = 2 * (1 - x) / 0.004;
        const double deviation = sqrt(q * (1 - q) / DRAWS) / slope;
        const double tolerance = 5 * deviation + 0.004 / 4096;
        check_within(tolerance, 0.004 * x, found.components[5].quantiles[i], "quantile %d", i);
    }
}

/* Along the link the tool moves to first order not at all: that corner is climbed to. */
static void test_a_climb_leaves_the_first_order(void)
{
    one_link one;
    const verification_task task = one_link_task(&one, 1);
    const verification found = run(&task);
    check_same(0, found.components[0].prediction, "prediction along the link");
    check_within(1e-13, 400 * (1 - cos(0.004)), found.components[0].worst_corner, "along the link");
    check_within(1e-12, 400 * sin(0.004), found.components[1].worst_corner, "across");
}

/* The tool is on the axis: only a tilt and a turn together bring it to the side. */
static void test_a_climb_takes_two_errors_at_once(void)
{
    const armtol_link link[1] = {{ARMTOL_NPR, ARMTOL_REVOLUTE}};
    const double tolerances[4] = {0.002, 0, 0, 0.003}; /* theta d a alpha */
    one_link one;
    verification_task task = one_link_task(&one, 1);
    double matrix[6 * 4];
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_error_matrix(link, 1, &armtol_errata_none, matrix, 4));
    matrix[1 * 4 + 3] = -400; /* a tilt moves the tool point along -y, 400 off the axes' crossing */
    task.poses = link;
    task.matrices = matrix;
    task.tolerances = tolerances;
    task.tool.offset[2] = 400;
    const verification found = run(&task);
    check_within(1e-12, 400 * sin(0.002) * sin(0.003), found.components[0].worst_corner, "to the side");
}

/* What A leaves out may take an arm outside the accuracy, but not beyond the remainder. */
static void test_outside_is_not_yet_beyond(void)
{
    const double accuracy[6] = {0.001, 1.7, 1, 1, 1, 1};
    one_link one;
    verification_task task = one_link_task(&one, DRAWS);
    task.accuracy = accuracy;
    const verification found = run(&task);
    check_share(acos(1 - 0.001 / 400) / 0.004, &found, "along the link");
    TEST_ASSERT_TRUE(found.beyond == 0);
}

/* ---- poses, and what is not asked ---- */

/* The link along x and along y: what is across in one pose is along in the other. */
static void two_poses(one_link *one, armtol_link links[2], double matrices[2 * 24], verification_task *task)
{
    *task = one_link_task(one, DRAWS);
    links[0] = links[1] = one->link;
    links[1].theta = pi / 2;
    memcpy(matrices, one->matrix, sizeof one->matrix);
    armtol_error_matrix(&links[1], 1, &armtol_errata_none, matrices + 24, 4);
    task->poses = links;
    task->matrices = matrices;
    task->n_poses = 2;
}

static void test_an_arm_is_within_when_it_is_in_every_pose(void)
{
    const double accuracy[6] = {0.4, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY};
    one_link one;
    armtol_link links[2];
    double matrices[2 * 24];
    verification_task task;
    two_poses(&one, links, matrices, &task);
    task.accuracy = accuracy;
    const verification both = run(&task);
    check_share(asin(0.4 / 400) / 0.004, &both, "both poses");
    check_within(0.001, 400 * 0.004, both.components[0].worst_drawn, "x, the worse of the poses");
    check_within(0.001, 400 * 0.004, both.components[1].worst_drawn, "y, the worse of the poses");
    check_within(1e-12, 400 * 0.004, both.components[0].prediction, "prediction");
    check_within(1e-12, 400 * sin(0.004), both.components[0].worst_corner, "worst corner");
    task.n_poses = 1;
    const verification along = run(&task);
    TEST_ASSERT_TRUE(along.within == DRAWS && along.beyond == 0);
    check_within(1e-5, 400 * (1 - cos(0.004)), along.components[0].worst_drawn, "x in the first pose");
}

static void test_where_nothing_is_asked_all_are_within(void)
{
    one_link one;
    const verification_task task = one_link_task(&one, 5000);
    const verification found = run(&task);
    TEST_ASSERT_TRUE(found.within == 5000 && found.beyond == 0);
    check_same(1, found.share_high, "share");
}

static void check_unbounded(verified_component found)
{
    check_same(INFINITY, found.prediction, "prediction");
    check_same(INFINITY, found.rss, "root of the sum of squares");
    check_same(INFINITY, found.remainder, "remainder");
    for (int n = 0; n < VERIFICATION_QUANTILES; n++) {
        TEST_ASSERT_TRUE(isnan(found.quantiles[n]));
    }
    TEST_ASSERT_TRUE(isnan(found.worst_drawn) && isnan(found.worst_corner));
}

/* A link along x: alpha turns the tool about x, beta about y, and neither moves the end of the link. */
static void test_infinite_tolerances_are_not_drawn(void)
{
    static const bool depends[6] = {[3] = true, [4] = true};
    one_link one, wide;
    const verification_task task = one_link_task(&one, 5000);
    const verification_task unbounded = one_link_task(&wide, 5000);
    wide.tolerances[2] = wide.tolerances[3] = INFINITY;
    const verification found = run(&task);
    const verification without = run(&unbounded);
    TEST_ASSERT_TRUE(without.drawn == 5000 && without.within == 5000);
    for (int i = 0; i < 6; i++) {
        if (depends[i]) {
            check_unbounded(without.components[i]);
        } else {
            TEST_ASSERT_EQUAL_MEMORY(&found.components[i], &without.components[i], sizeof found.components[i]);
        }
    }
}

static void test_without_tolerances_nothing_moves(void)
{
    one_link one;
    const verification_task task = one_link_task(&one, 5000);
    one.tolerances[0] = 0;
    const verification found = run(&task);
    for (int i = 0; i < 6; i++) {
        const verified_component *component = &found.components[i];
        check_same(0, component->worst_drawn, "worst drawn %d", i);
        check_same(0, component->worst_corner, "worst corner %d", i);
        check_same(0, component->quantiles[3], "quantile %d", i);
        TEST_ASSERT_TRUE(component->worst_arm == 0);
    }
}

/* Turns of up to 4 about z: of the rest of a turn beyond pi the vector is the shorter way. */
static void test_where_the_remainder_is_not_bounded(void)
{
    one_link one;
    const verification_task task = one_link_task(&one, DRAWS);
    one.tolerances[0] = 4;
    const verification found = run(&task);
    const verified_component *turn = &found.components[5];
    check_same(INFINITY, turn->remainder, "remainder");
    check_within(0.001, pi, turn->worst_drawn, "half a turn");
    /* of |e| the parts above pi come back: up to 2 pi - 4 a magnitude is as likely as its share of 4 */
    check_within(0.02, 2, turn->quantiles[0], "median");
}

static void test_no_samples(void)
{
    one_link one;
    const verification_task task = one_link_task(&one, 0);
    const verification found = run(&task);
    TEST_ASSERT_TRUE(found.drawn == 0 && found.within == 0);
    TEST_ASSERT_TRUE(found.share_low == 0 && found.share_high == 1);
    check_within(1e-12, 400 * sin(0.004), found.components[1].worst_corner, "worst corner");
}

/* ---- threads ---- */

enum { LINKS = 10, COLUMNS = 50 };

/* The Intelledex in two poses. */
typedef struct six_axes {
    armtol_link poses[2 * LINKS];
    double matrices[2 * 6 * COLUMNS];
    double tolerances[COLUMNS];
} six_axes;

static verification_task six_axes_task(six_axes *arm, const double accuracy[6])
{
    static const double q[2][6] = {{0.3, -0.4, 1.1, 0.2, 0.7, -0.9}, {-1, 0.5, -0.6, 1.3, -0.2, 0.4}};
    const size_t n_links = armtol_intelledex_605t.n_links;
    armtol_link links[LINKS];
    TEST_ASSERT_TRUE(n_links <= LINKS);
    armtol_intelledex_605t.links(&armtol_errata_none, links);
    const size_t n = armtol_column_count(links, n_links);
    TEST_ASSERT_TRUE(n <= COLUMNS);
    for (size_t pose = 0; pose < 2; pose++) {
        armtol_link *placed = arm->poses + pose * n_links;
        const size_t joints = armtol_joint_count(links, n_links);
        double *matrix = arm->matrices + pose * 6 * n;
        armtol_status status =
            armtol_links_place(links, n_links, q[pose], joints, &armtol_errata_none, placed);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, status);
        status = armtol_error_matrix(placed, n_links, &armtol_errata_none, matrix, n);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, status);
    }
    for (size_t k = 0; k < n; k++) {
        arm->tolerances[k] = 1e-3 * (double)(1 + k % 3);
    }
    return (verification_task){
        .poses = arm->poses,
        .n_poses = 2,
        .n_links = n_links,
        .matrices = arm->matrices,
        .tolerances = arm->tolerances,
        .n_columns = n,
        .tool = {{10, 20, 30}, ARMTOL_BASE_FRAME},
        .accuracy = accuracy,
        .seed = 5,
    };
}

static void test_the_number_of_threads_changes_nothing(void)
{
    static const uint64_t samples[] = {1, 255, 4096, 4097, 30011};
    static const size_t threads[] = {0, 2, 3, 7, 1000};
    static const double accuracy[6] = {3, 3, 3, 0.01, 0.01, 0.01};
    six_axes arm;
    verification_task task = six_axes_task(&arm, accuracy);
    for (size_t i = 0; i < sizeof samples / sizeof samples[0]; i++) {
        task.samples = samples[i];
        task.n_threads = 1;
        const verification alone = run(&task);
        TEST_ASSERT_TRUE(alone.drawn == samples[i]);
        for (size_t j = 0; j < sizeof threads / sizeof threads[0]; j++) {
            task.n_threads = threads[j];
            const verification together = run(&task);
            TEST_ASSERT_EQUAL_MEMORY(&alone, &together, sizeof alone);
        }
    }
}

/* ---- corners ---- */

/* The largest magnitudes where each error is all that it may be, either way, or nothing. */
static void largest_of_all(const verification_task *task, double largest[6])
{
    const unsigned all = (unsigned)lround(pow(3, (double)task->n_columns));
    for (unsigned i = 0; i < all; i++) {
        double errors[COLUMNS], error[6];
        unsigned rest = i;
        for (size_t k = 0; k < task->n_columns; k++) {
            errors[k] = ((int)(rest % 3) - 1) * task->tolerances[k];
            rest /= 3;
        }
        armtol_tool_error(task->poses, task->n_links, errors, task->n_columns, &task->tool, error);
        for (size_t component = 0; component < 6; component++) {
            largest[component] = fmax(largest[component], fabs(error[component]));
        }
    }
}

static void check_worst_corner(const armtol_link links[2], const double tolerances[8])
{
    double matrix[6 * 8], largest[6] = {0};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_error_matrix(links, 2, &armtol_errata_none, matrix, 8));
    const verification_task task = {
        .poses = links,
        .n_poses = 1,
        .n_links = 2,
        .matrices = matrix,
        .tolerances = tolerances,
        .n_columns = 8,
        .tool = armtol_tool_origin,
    };
    const verification found = run(&task);
    largest_of_all(&task, largest);
    for (size_t i = 0; i < 6; i++) {
        check_within(1e-6 * largest[i], largest[i], found.components[i].worst_corner, "component %zu", i);
    }
}

static void test_the_worst_corner_is_the_worst_of_all(void)
{
    static const double tolerances[8] = {0.01, 1, 1, 0.01, 0.01, 1, 0.01, 0.01};
    random_source source = {9};
    for (int i = 0; i < 60; i++) {
        const armtol_link links[2] = {{ARMTOL_NPR, ARMTOL_REVOLUTE, .a = random_between(&source, 0, 300),
                                       .alpha = random_between(&source, -2, 2),
                                       .theta = random_between(&source, -3, 3)},
                                      {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 200,
                                       .theta = random_between(&source, -3, 3)}};
        check_worst_corner(links, tolerances);
    }
}

/* ---- interrupts and the bar ---- */

static volatile sig_atomic_t handled;

static void handle(int number)
{
    (void)number;
    handled = 1;
}

static void test_a_second_interrupt_is_not_held_up(void)
{
    struct sigaction before, now;
    const struct sigaction ours = {.sa_handler = handle};
    sigaction(SIGINT, &ours, NULL);
    interrupt_watch(&before);
    TEST_ASSERT_FALSE(interrupt_came());
    raise(SIGINT);
    TEST_ASSERT_TRUE(interrupt_came());
    sigaction(SIGINT, NULL, &now);
    TEST_ASSERT_TRUE(now.sa_handler == SIG_DFL);
    interrupt_restore(&before);
    TEST_ASSERT_FALSE(handled);
    raise(SIGINT);
    TEST_ASSERT_TRUE(handled);
    interrupt_watch(&before);
    TEST_ASSERT_FALSE(interrupt_came());
    interrupt_restore(&before);
    signal(SIGINT, SIG_DFL);
}

static void test_drawing_leaves_interrupts_as_they_were(void)
{
    const struct sigaction ours = {.sa_handler = handle};
    struct sigaction now;
    one_link one;
    const verification_task task = one_link_task(&one, 10);
    sigaction(SIGINT, &ours, NULL);
    run(&task);
    sigaction(SIGINT, NULL, &now);
    TEST_ASSERT_TRUE(now.sa_handler == handle);
    signal(SIGINT, SIG_DFL);
}

static void test_ignored_interrupts_stay_ignored(void)
{
    struct sigaction before, now;
    signal(SIGINT, SIG_IGN);
    interrupt_watch(&before);
    raise(SIGINT);
    TEST_ASSERT_FALSE(interrupt_came());
    interrupt_restore(&before);
    sigaction(SIGINT, NULL, &now);
    TEST_ASSERT_TRUE(now.sa_handler == SIG_IGN);
    signal(SIGINT, SIG_DFL);
}

static double seconds(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* What stands on the terminal's last line when all is written. */
static void last_line_on_terminal(const text *said, char line[200])
{
    size_t at = 0;
    memset(line, ' ', 199);
    line[199] = '\0';
    for (size_t i = 0; i < said->length; i++) {
        if (said->bytes[i] == '\r') {
            at = 0;
        } else if (at < 199) {
            line[at++] = said->bytes[i];
        }
    }
}

static void check_interrupted(const process *process)
{
    unsigned long long drawn = 0, within = 0;
    double worst = 0, median = 0;
    process_check_status(process, 0, "interrupted");
    const int read = sscanf(process->output.bytes, "drawn %llu, within %llu, worst %lf, median %lf", &drawn,
                            &within, &worst, &median);
    if (read != 4) {
        fail_with("the interrupted program printed \"%s\"", process->output.bytes);
    }
    TEST_ASSERT_TRUE(drawn > 1000 && drawn < 1000000000000u && within == drawn);
    check_within(0.0001, 0.004, worst, "worst of what was drawn");
    check_within(0.0002, 0.002, median, "median of what was drawn");
}

static void test_the_bar_on_a_terminal(void)
{
    static process process;
    char line[200];
    const process_setup setup = {.program = TEST_ENDLESS, .wires = {WIRE_TERMINAL, WIRE_PIPE, WIRE_TERMINAL}};
    const double started = seconds();
    process_start(&process, &setup);
    process_expect(&process, "\r[....................]   0 %  ");
    TEST_ASSERT_TRUE(seconds() - started > 0.99);
    process_expect(&process, " of 9223372036854775807 arms, ");
    process_expect(&process, " d left");
    process_expect(&process, "\r[");
    process_say(&process, "\003"); /* Ctrl-C */
    process_finish(&process);
    check_interrupted(&process);
    last_line_on_terminal(&process.errors, line);
    if (strspn(line, " ") != strlen(line)) {
        fail_with("left on the terminal: \"%s\"", line);
    }
    TEST_ASSERT_NULL(strchr(process.errors.bytes, '\n'));
    TEST_ASSERT_EQUAL_INT('\r', process.errors.bytes[process.errors.length - 1]);
}

static void test_no_bar_on_a_pipe(void)
{
    static process process;
    const process_setup setup = {.program = TEST_ENDLESS};
    const struct timespec pause = {.tv_sec = 1, .tv_nsec = 500000000};
    process_start(&process, &setup);
    nanosleep(&pause, NULL);
    kill(process.id, SIGINT);
    process_finish(&process);
    check_interrupted(&process);
    TEST_ASSERT_EQUAL_INT(0, process.errors.length);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_quantiles_are_counted);
    RUN_TEST(test_what_is_within_and_what_beyond);
    RUN_TEST(test_magnitudes_out_of_range);
    RUN_TEST(test_the_first_of_the_worst_wins);
    RUN_TEST(test_one_uniform_error);
    RUN_TEST(test_the_worst_arm_can_be_had_again);
    RUN_TEST(test_two_uniform_errors);
    RUN_TEST(test_a_climb_leaves_the_first_order);
    RUN_TEST(test_a_climb_takes_two_errors_at_once);
    RUN_TEST(test_outside_is_not_yet_beyond);
    RUN_TEST(test_an_arm_is_within_when_it_is_in_every_pose);
    RUN_TEST(test_where_nothing_is_asked_all_are_within);
    RUN_TEST(test_infinite_tolerances_are_not_drawn);
    RUN_TEST(test_without_tolerances_nothing_moves);
    RUN_TEST(test_where_the_remainder_is_not_bounded);
    RUN_TEST(test_no_samples);
    RUN_TEST(test_the_number_of_threads_changes_nothing);
    RUN_TEST(test_the_worst_corner_is_the_worst_of_all);
    RUN_TEST(test_a_second_interrupt_is_not_held_up);
    RUN_TEST(test_drawing_leaves_interrupts_as_they_were);
    RUN_TEST(test_ignored_interrupts_stay_ignored);
    RUN_TEST(test_the_bar_on_a_terminal);
    RUN_TEST(test_no_bar_on_a_pipe);
    return UNITY_END();
}
