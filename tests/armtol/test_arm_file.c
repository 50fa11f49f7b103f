/*
 * Tables of arms: what people type and what spreadsheets write, every message with its place, and that an arm which is
 * written comes back to the bit.
 */

#include "armtol/tables/arm_file.h"
#include "console/message.h"

#include "support/check.h"
#include "support/random.h"
#include "support/said.h"

#include "unity.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* pi/2 and so on: the doubles nearest to them, from sixty digits of pi. */
#define DEG_0_5 0x1.1df46a2529d39p-7
#define DEG_30 0x1.0c152382d7366p-1
#define DEG_90 0x1.921fb54442d18p+0
#define DEG_160 0x1.657184ae74487p+1

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- reading ---- */

static bool read_bytes(const char *bytes, size_t length, const char *path, arm_model *model, said *said)
{
    FILE *stream = stream_of(bytes, length);
    said_begin();
    const bool fine = arm_file_read(stream, path, model);
    said_end(said);
    fclose(stream);
    return fine;
}

/* A table that is fine, and that nothing is said of. */
static void read_table(const char *text, arm_model *model)
{
    said said;
    const bool fine = read_bytes(text, strlen(text), "tables/arm.csv", model, &said);
    TEST_ASSERT_EQUAL_STRING_MESSAGE("", said.text, text);
    TEST_ASSERT_TRUE_MESSAGE(fine, text);
}

static void check_refused_bytes(const char *expected, const char *bytes, size_t length)
{
    arm_model model;
    said said;
    const bool fine = read_bytes(bytes, length, "arm.csv", &model, &said);
    char line[1100];
    snprintf(line, sizeof line, "armtol: arm.csv:%s\n", expected);
    TEST_ASSERT_EQUAL_STRING_MESSAGE(line, said.text, length < 1000 ? bytes : "(long)");
    TEST_ASSERT_FALSE_MESSAGE(fine, expected);
    TEST_ASSERT_NULL(model.arm.name);
    TEST_ASSERT_NULL(model.arm.links);
}

/* expected begins with LINE:COLUMN. */
static void check_refused(const char *expected, const char *text)
{
    check_refused_bytes(expected, text, strlen(text));
}

static void check_link(const armtol_link *expected, const armtol_link *link, const char *what)
{
    TEST_ASSERT_EQUAL_STRING_MESSAGE(armtol_kind_name(expected->kind), armtol_kind_name(link->kind), what);
    TEST_ASSERT_EQUAL_INT_MESSAGE(expected->joint, link->joint, what);
    check_same(expected->a, link->a, "a, %s", what);
    check_same(expected->alpha, link->alpha, "alpha, %s", what);
    check_same(expected->d, link->d, "d, %s", what);
    check_same(expected->theta, link->theta, "theta, %s", what);
    check_same(expected->beta, link->beta, "beta, %s", what);
}

/* ---- what a table means ---- */

static const char full_table[] =
    "# all that a table can say\n"
    "name: reach\n"
    "title: Reach 3, \"the short one\"   # as its makers call it\n"
    "source: page 12 of the manual\n"
    "units: mm deg\n"
    "\n"
    "kind, joint,  a,    alpha, d,   theta, beta, low,  high, backlash, compliance, moment\n"
    "npr,  theta,  0.5,  90,    -20, 0,     0,    -160, inf,  0.5,      30,         2\n"
    "ppp,  d,      1e2,  0,     7,   -90,   0.5,  -inf, 30,   0.25,     0.5,        4\n"
    "ppr,  fixed,  0,    0,     0,   30,    0,    -,    -,    -,        -,          -\n";

static void test_a_table_that_says_all(void)
{
    static const armtol_link links[] = {
        {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 0.5, .alpha = DEG_90, .d = -20},
        {ARMTOL_PPP, ARMTOL_PRISMATIC, .a = 100, .d = 7, .theta = -DEG_90, .beta = DEG_0_5},
        {ARMTOL_PPR, ARMTOL_FIXED, .theta = DEG_30},
    };
    arm_model model;
    read_table(full_table, &model);
    TEST_ASSERT_EQUAL_STRING("reach", model.arm.name);
    TEST_ASSERT_EQUAL_STRING("Reach 3, \"the short one\"", model.arm.title);
    TEST_ASSERT_EQUAL_STRING("page 12 of the manual", model.arm.source);
    TEST_ASSERT_EQUAL_INT(ARMTOL_MILLIMETRE, model.arm.unit);
    TEST_ASSERT_EQUAL_INT(UNIT_DEGREE, model.angle_unit);
    TEST_ASSERT_EQUAL_UINT(3, model.arm.n_links);
    for (size_t i = 0; i < 3; i++) {
        check_link(&links[i], &model.arm.links[i], "full table");
    }
    arm_model_free(&model);
}

/* A joint's own unit: an angle for a revolute one, a length for a prismatic one. */
static void test_drives(void)
{
    arm_model model;
    read_table(full_table, &model);
    const armtol_drive *drives = model.arm.drives;
    check_same(-DEG_160, drives[0].low, "low");
    check_same((double)INFINITY, drives[0].high, "high");
    check_same(DEG_0_5, drives[0].backlash, "backlash");
    check_same(DEG_30, drives[0].compliance, "compliance");
    check_same(2, drives[0].moment, "moment");
    check_same(-(double)INFINITY, drives[1].low, "low of d");
    check_same(30, drives[1].high, "high of d");
    check_same(0.25, drives[1].backlash, "backlash of d");
    check_same(0.5, drives[1].compliance, "compliance of d");
    check_same(4, drives[1].moment, "moment of d");
    TEST_ASSERT_EQUAL_MEMORY(&armtol_drive_unknown, &drives[2], sizeof drives[2]);
    arm_model_free(&model);
}

/* Every column of drives and masses; and two of them in other words. */
static void test_drives_and_masses(void)
{
    arm_model model;
    read_table("units: mm deg\njoint,a,alpha,d,theta,backlash,stiffness,bits,friction,noise,mass,com_x,com_y,com_z\n"
               "theta,1,0,0,0,0.5,2,13,7,0.5,3,-1,2,-3\nfixed,1,0,0,0,,,,,,4\n",
               &model);
    const armtol_drive *drive = &model.arm.drives[0];
    check_same(DEG_0_5, drive->backlash, "backlash");
    check_within(1e-17, DEG_0_5, drive->compliance, "half a degree a N m");
    check_within(1e-18, DEG_90 / 2048, drive->resolution, "2^13 steps a turn");
    check_same(7, drive->friction, "friction");
    check_same(DEG_0_5, drive->noise, "noise");
    const armtol_mass *masses = model.arm.masses;
    TEST_ASSERT_TRUE(masses[0].mass == 3 && masses[1].mass == 4 && masses[1].center[0] == 0);
    TEST_ASSERT_TRUE(masses[0].center[0] == -1 && masses[0].center[1] == 2 && masses[0].center[2] == -3);
    arm_model_free(&model);
    read_table(full_table, &model);
    TEST_ASSERT_NULL(model.arm.masses);
    arm_model_free(&model);
}

static void test_what_is_left_out(void)
{
    static const armtol_link links[] = {
        {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 1, .alpha = 1.5, .d = 2, .theta = 3},
        {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 4},
        {ARMTOL_NPP, ARMTOL_PRISMATIC, .alpha = -1.5},
        {ARMTOL_PPP, ARMTOL_PRISMATIC, .theta = 1},
    };
    arm_model model;
    read_table("units: m rad\n"
               "theta d alpha a joint\n"
               "3 2 1.5 1 theta\n"
               "0 0 0 4 revolute\n"
               "0 0 -1.5 0 d\n"
               "1 0 0 0 prismatic\n",
               &model);
    TEST_ASSERT_EQUAL_STRING("arm", model.arm.name);
    TEST_ASSERT_EQUAL_STRING("arm", model.arm.title);
    TEST_ASSERT_EQUAL_STRING("not given", model.arm.source);
    TEST_ASSERT_EQUAL_INT(ARMTOL_METRE, model.arm.unit);
    TEST_ASSERT_EQUAL_INT(UNIT_RADIAN, model.angle_unit);
    TEST_ASSERT_EQUAL_UINT(4, model.arm.n_links);
    for (size_t i = 0; i < 4; i++) {
        check_link(&links[i], &model.arm.links[i], "left out");
        TEST_ASSERT_EQUAL_MEMORY(&armtol_drive_unknown, &model.arm.drives[i], sizeof model.arm.drives[i]);
    }
    arm_model_free(&model);
}

static void check_name(const char *expected, const char *path)
{
    static const char text[] = "units: m rad\njoint a alpha d theta\ntheta 0 0 0 0";
    arm_model model;
    said said;
    TEST_ASSERT_TRUE_MESSAGE(read_bytes(text, strlen(text), path, &model, &said), path);
    TEST_ASSERT_EQUAL_STRING(expected, model.arm.name);
    arm_model_free(&model);
}

static void test_an_arm_without_a_name_has_its_files(void)
{
    check_name("arm", "arm");
    check_name("my arm", "some.where/my arm.csv");
    check_name("arm.v2", "/arm.v2.txt");
    check_name(".hidden", "x/.hidden");
    check_name("-", "-");
}

/* ---- ways to write the same table ---- */

/* One link: theta, a = 3.5, alpha = 90 degrees, d = -1, theta = 0.5 degrees, beta = 0; low -160, high not known. */
static void check_same_arm(const char *text)
{
    static const armtol_link link = {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 3.5, .alpha = DEG_90, .d = -1, .theta = DEG_0_5};
    arm_model model;
    read_table(text, &model);
    TEST_ASSERT_EQUAL_STRING_MESSAGE("t1", model.arm.name, text);
    TEST_ASSERT_EQUAL_STRING_MESSAGE("One; two, #3", model.arm.title, text);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(1, model.arm.n_links, text);
    TEST_ASSERT_EQUAL_INT_MESSAGE(ARMTOL_MILLIMETRE, model.arm.unit, text);
    check_link(&link, &model.arm.links[0], text);
    check_same(-DEG_160, model.arm.drives[0].low, "low, %s", text);
    check_same((double)INFINITY, model.arm.drives[0].high, "high, %s", text);
    arm_model_free(&model);
}

static void test_what_people_type(void)
{
    check_same_arm("name: t1\ntitle: \"One; two, #3\"\nunits: mm deg\n"
                   "joint, a, alpha, d, theta, low, high\ntheta, 3.5, 90, -1, 0.5, -160, -\n");
    check_same_arm("name:t1\ntitle \"One; two, #3\"  # remark\nUNITS : deg, MM\n\n  # remark\n"
                   "  JOINT  a Alpha d theta high low # remark; more, still\n"
                   "\tTheta\t3.5 +90 -1.0 5e-1 \t - -160#remark\n\n\n");
    check_same_arm("units mm deg\nname t1\ntitle: \"One; two, #3\"\n"
                   "joint;a;alpha;d;theta;low;high\nrevolute;3,5;90;-1;,5;-160;\n");
    check_same_arm("units: mm deg\nname: t1\ntitle: \"One; two, #3\"\nkind joint a alpha d theta low\n"
                   "auto theta 3.5 90 -1 0.5 -160");
}

static void test_what_spreadsheets_write(void)
{
    /* a byte order mark, CRLF, semicolons, decimal commas, rows as wide as the widest */
    check_same_arm("\xef\xbb\xbf"
                   "name;t1;;;;;;\r\ntitle;\"One; two, #3\";;;;;;\r\nunits;mm;deg;;;;;\r\n;;;;;;;\r\n"
                   "\"# a remark; with a separator\";;;;;;;\r\n"
                   "joint;a;alpha;d;theta;low;high;\r\ntheta;3,5;90,0;-1;0,50;-160;;\r\n;;;;;;;\r\n");
    /* colons in the cells; a key and its value in one cell, which has quotes as it has a semicolon */
    check_same_arm("name: t1;;;;;;\r\n\"title: \"\"One; two, #3\"\"\";;;;;;\r\nunits: mm deg;;;;;;\r\n"
                   "joint;a;alpha;d;theta;low;high\r\ntheta;3,5;90;-1;0,5;-160;-");
    /* commas, everything in quotes; the lines end in CR */
    check_same_arm("\"name\",\"t1\"\r\"title:\",\"One; two, #3\"\r\"units\",\"mm\",\"deg\"\r"
                   "\"joint\",\"a\",\"alpha\",\"d\",\"theta\",\"low\",\"high\"\r"
                   "\"theta\",\"3.5\",\"90\",\"-1\",\"0.5\",\"-160\",\"\"\r");
    /* tabs, and a minus sign that the typesetter made */
    check_same_arm("name:\tt1\t\t\t\t\t\ntitle\t\"One; two, #3\"\t\t\t\t\t\nunits\tmm\tdeg\t\t\t\t\n"
                   "joint\ta\talpha\td\ttheta\tlow\thigh\ntheta\t3,5\t90\t\xe2\x88\x92"
                   "1\t0,5\t\xe2\x80\x93" "160\t\xe2\x80\x93\t\"# a remark; with a separator\"\n");
}

/* ---- kinds ---- */

static void check_kinds(const char *expected, const char *rows)
{
    char text[400], kinds[100] = "";
    arm_model model;
    snprintf(text, sizeof text, "units: mm deg\njoint a alpha d theta beta\n%s", rows);
    read_table(text, &model);
    for (size_t i = 0; i < model.arm.n_links; i++) {
        strcat(strcat(kinds, i > 0 ? " " : ""), armtol_kind_name(model.arm.links[i].kind));
    }
    TEST_ASSERT_EQUAL_STRING_MESSAGE(expected, kinds, rows);
    arm_model_free(&model);
}

/* By the axes of the whole table: axes.h, note 2. The last joint's d carries the tool, whatever its alpha is. */
static void test_kinds_that_a_table_leaves_to_the_axes(void)
{
    check_kinds("npr npr", "theta 0 90 300 0 0\ntheta 0 0 100 0 0\n");
    check_kinds("npr npr npr", "theta 0 90 300 0 0\ntheta 0 0 100 0 0\nfixed 0 0 20 0 0\n");
    check_kinds("ppr npr", "theta 300 0 0 0 0\ntheta 250 0 20 0 0\n");
    check_kinds("ppr ppr", "theta 300 0 0 0 0\ntheta 250 0 20 0 0.01\n");
    check_kinds("ppr ppr", "theta 300 28 0 0 0\ntheta 250 0 0 0 0\n"); /* 300 apart, a reach of 550: 28.6 degrees */
    check_kinds("npr ppr", "theta 300 -29 0 0 0\ntheta 250 0 0 0 0\n");
    check_kinds("npp ppp", "d 0 90 0 0 0\nd 0 0 0 0 0\n");
}

static void check_note(const char *expected, const char *last)
{
    char text[400];
    arm_model model;
    said said;
    snprintf(text, sizeof text, "units: mm deg\nkind joint a alpha d theta\nnpr theta 0 90 300 0\n%s\n", last);
    TEST_ASSERT_TRUE(read_bytes(text, strlen(text), "arm.csv", &model, &said));
    TEST_ASSERT_EQUAL_STRING_MESSAGE(expected, said.text, last);
    arm_model_free(&model);
}

static void test_a_last_link_that_counts_no_length_is_noted(void)
{
    static const char note[] =
        "armtol: arm.csv:4:2: note: the last link is ppr, which counts its d, the length of the tool, "
        "as exact; npr, as auto makes it, does not\n";
    check_note(note, " ppr theta 0 0 100 0");
    check_note(note, " ppr theta 60 180 -100 0");
    check_note("", " ppr theta 60 0 0 0");
    check_note("", " ppr theta 60 5 100 0");
    check_note("", " npr theta 0 0 100 0");
    check_note("", " auto theta 0 0 100 0");
    check_note("", " ppr fixed 0 0 100 0");
}

/* The tables of docs/arm-files.md are between ```csv and ```. */
static void test_the_tables_of_the_documentation(void)
{
    static const char begin[] = "```csv\n";
    static const size_t n_links[] = {3, 2};
    static char text[1 << 15];
    FILE *stream = fopen(TEST_DOCUMENT, "rb");
    TEST_ASSERT_NOT_NULL_MESSAGE(stream, TEST_DOCUMENT);
    text[fread(text, 1, sizeof text - 1, stream)] = '\0';
    fclose(stream);
    size_t tables = 0;
    for (char *at = strstr(text, begin); at != NULL; at = strstr(at, begin)) {
        arm_model model;
        at += strlen(begin);
        char *const end = strstr(at, "```");
        TEST_ASSERT_TRUE(end != NULL && tables < sizeof n_links / sizeof n_links[0]);
        *end = '\0';
        read_table(at, &model);
        TEST_ASSERT_EQUAL_UINT(n_links[tables++], model.arm.n_links);
        arm_model_free(&model);
        at = end + 1;
    }
    TEST_ASSERT_EQUAL_UINT(sizeof n_links / sizeof n_links[0], tables);
}

/* ---- what is wrong, and where ---- */

#define UNITS "units: mm deg\n"
#define HEAD UNITS "joint,a,alpha,d,theta\n"
#define FULL UNITS "kind,joint,a,alpha,d,theta,beta,low,high,backlash,compliance,moment\n"
#define EXPECTED_UNITS "expected a unit of length, mm, m or in, and one of angles, deg or rad"
#define EXPECTED_COLUMNS                                                                                               \
    "expected name, kind, joint, a, alpha, d, theta, beta, sign, couple, multiplier, offset, low, high, backlash, "    \
    "compliance or stiffness, moment, "                                                                                \
    "resolution or bits, friction, noise, mass, com_x, com_y or com_z"
#define NEITHER                                                                                                        \
    " is neither a key (name, title, source, units, order) nor a column (name, kind, joint, a, alpha, d, theta, ...)"
#define NO_TABLE                                                                                                       \
    "the file ends before a table of links; expected a row of names: joint, a, alpha, d, theta and, as needed, "       \
    "name, kind, beta, sign, couple, multiplier, offset, low, high, backlash, compliance, moment, resolution, "        \
    "friction, noise, mass, com_x, com_y, com_z"
#define SAVE_AS "save the table as UTF-8 (in a spreadsheet: CSV, UTF-8)"

static void test_wrong_keys(void)
{
    check_refused("2:3: unknown key \"colour\"; expected name, title, source, units or order", "\n  colour: red\n");
    check_refused("1:1: unknown key \"nam\"; expected name, title, source, units or order", "nam: red\n");
    check_refused("1:2: unknown key \"colour\"; expected name, title, source, units or order", "\"colour:\";red\n");
    check_refused("2:3: a second \"units\"", UNITS "  units: mm deg\n");
    check_refused("3:1: a second \"title\"", "title: one\nname: x\ntitle;two\n");
    check_refused("1:17: a cell too many behind \"title\"; put a text with separators in quotes",
                  "title,Puma 560, Unimation\n");
    check_refused("1:11: a cell too many behind \"name: x\"", "\"name: x\";\"y\"\n");
    check_refused("1:12: unknown unit \"inch\"; " EXPECTED_UNITS, "units: deg inch\n");
    check_refused("1:10: unknown unit \"grad\"; " EXPECTED_UNITS, "units;mm;grad;;\n");
    check_refused("1:8: " EXPECTED_UNITS ", as in \"units: mm deg\"", "units: mm m\n");
    check_refused("1:8: " EXPECTED_UNITS ", as in \"units: mm deg\"", "units: rad\n");
    check_refused("1:7: " EXPECTED_UNITS ", as in \"units: mm deg\"", "units:\n");
    check_refused("1:8: " EXPECTED_UNITS ", as in \"units: mm deg\"", "units: mm deg deg\n");
    check_refused("1:8: " EXPECTED_UNITS ", as in \"units: mm deg\"", "units: mm deg m\n");
    check_refused("1:11: unknown unit \"inch\"; " EXPECTED_UNITS, "units;\"mm inch\";deg\n");
}

static void test_wrong_head_rows(void)
{
    check_refused("1:1: " NO_TABLE, "");
    check_refused("2:1: " NO_TABLE, "name: x\n" UNITS);
    check_refused("2:1: \"nmae\"" NEITHER, UNITS "nmae x\n");
    check_refused("2:1: \"theta0\"" NEITHER, UNITS "theta0,d\n");
    check_refused("2:9: unknown column \"b\"; " EXPECTED_COLUMNS, UNITS "joint,a,b,d,theta\n");
    check_refused("2:15: unknown column \"length in mm\"; " EXPECTED_COLUMNS,
                  UNITS "\"joint\";\"a\" ; \"length in mm\" ;d;theta\n");
    check_refused("2:15: a second column \"a\"", UNITS "joint,a,alpha,A,d,theta\n");
    check_refused("2:9: a column without a name", UNITS "joint,a,,alpha,d,theta\n");
    check_refused("2:1: a column without a name", UNITS ",joint,a,alpha,d,theta\n");
    check_refused("2:6: the head row has no column \"a\"", UNITS "joint\njoint,a,alpha,d,theta\ntheta,1,0,0,0\n");
    check_refused("2:16: the head row has no column \"theta\"", UNITS "joint,a,alpha,d\n");
    check_refused("2:22: the head row has no column \"joint\"", UNITS "kind,theta,a,alpha,d,,,\n");
    check_refused("1:1: no units above the table; expected a line \"units: mm deg\" (mm or m, deg or rad)",
                  "joint,a,alpha,d,theta\nunits: mm deg\n");
    check_refused("2:1: the table has no links; expected a row for each", HEAD);
    check_refused("4:1: the table has no links; expected a row for each", HEAD "\n,,,# remark");
}

static void test_wrong_numbers_of_cells(void)
{
    check_refused("3:14: no value for \"theta\"", HEAD "theta,0,90,1 \n");
    check_refused("3:9: no value for \"alpha\"", HEAD "theta,0,,1,2\n");
    check_refused("3:14: no value for \"theta\"", HEAD "theta,0,90,1,-\n");
    check_refused("3:1: no value for \"joint\"", HEAD ",0,0,1,2\n");
    check_refused("3:15: a cell too many; the head row names 5 columns", HEAD "theta,0,0,1,2,,3,4\n");
    check_refused("4:15: a cell too many; the head row names 5 columns", HEAD "theta,0,0,1,2,\ntheta,0,0,1,2,3\n");
    check_refused("3:14: 4 cells, but the head row names 5 columns; expected a - for what is not known",
                  UNITS "joint a alpha d theta\ntheta 0 0 1  # remark\n");
    check_refused("3:1: unknown joint \"theta 0 0 1 2\"; expected theta (revolute), d (prismatic) or fixed",
                  HEAD "theta 0 0 1 2\n");
}

static void test_wrong_cells(void)
{
    check_refused("3:7: a: \"x\" is not a number", HEAD "theta,x,0,1,2\n");
    check_refused("4:11: d: \"nan\" is not a finite number", HEAD "theta,0,0,1,2\ntheta,0,0,nan,2\n");
    check_refused("3:9: alpha: \"1e999\" is too large a number", HEAD "theta,0,1e999,1,2\n");
    check_refused("3:9: alpha: \"-inf\" is not a finite number", HEAD "theta,0,-inf,1,2\n");
    check_refused("3:7: a: \"0x10\" is not a number", HEAD "theta,0x10,0,1,2\n");
    check_refused("3:7: a: \"3,5\" is not a number", HEAD "theta,\"3,5\",0,1,2\n");
    check_refused("3:7: a: \"1.234,5\" is not a number", UNITS "joint;a;alpha;d;theta\ntheta;1.234,5;0;1;2\n");
    check_refused("3:7: a: \"#REF!\" is not a number", HEAD "theta,#REF!,0,1,2\n");
    check_refused("3:7: a: \"#N/A\" is not a number", HEAD "theta,#N/A,0,1,2\n");
    check_refused("3:1: unknown joint \"beta\"; expected theta (revolute), d (prismatic) or fixed",
                  HEAD "beta,0,0,1,2\n");
    check_refused("3:1: unknown kind \"rrr\"; expected npr, npp, ppr, ppp or auto",
                  UNITS "kind,joint,a,alpha,d,theta\nrrr,theta,0,0,1,2\n");
    check_refused("5:7: a: \"x\" is not a number",
                  "units: mm deg\r\n\r\njoint,a,alpha,d,theta\r\n\r\ntheta,x,0,0,0\r\n");
    check_refused("4:7: a: \"x\" is not a number", "\runits: mm deg\rjoint,a,alpha,d,theta\rtheta,x,0,0,0\r");
    /* a place is counted in characters, not in bytes */
    check_refused("1:11: a cell too many behind \"title\"; put a text with separators in quotes",
                  "title;\xc3\xa4\xf0\x9f\xa4\x96\xe2\x82\xac;x\n");
}

static void test_a_number_of_many_digits(void)
{
    char text[800];
    arm_model model;
    snprintf(text, sizeof text, HEAD "theta,%0500d.5,0,1,2\n", 7);
    read_table(text, &model);
    check_same(7.5, model.arm.links[0].a, "a");
    arm_model_free(&model);
    snprintf(text, sizeof text, HEAD "theta,%0510d.5,0,1,2\n", 7);
    check_refused("3:7: a: \"0000000000000000000000000000000000000000...\" is too long", text);
}

static void test_of_two_mistakes_the_first_is_told(void)
{
    check_refused("3:3: a: \"x\" is not a number", UNITS "d,a,alpha,theta,joint\n0,x,0,0,foo\n");
    check_refused("3:5: unknown joint \"foo\"; expected theta (revolute), d (prismatic) or fixed",
                  UNITS "d,a,joint,alpha,theta\n0,0,foo,x,0\n");
}

static void check_full(const char *expected, const char *row)
{
    char text[400];
    snprintf(text, sizeof text, FULL "%s", row);
    check_refused(expected, text);
}

/* Columns behind those that a row needs. */
static void check_drive(const char *expected, const char *columns, const char *cells)
{
    char text[256];
    snprintf(text, sizeof text, UNITS "joint,a,alpha,d,theta,%s\ntheta,0,90,0,0,%s\n", columns, cells);
    check_refused(expected, text);
}

static void test_rows_that_contradict_themselves(void)
{
    check_full("3:1: a link whose joint is theta cannot be npp; expected npr or ppr", "npp,theta,0,90,0,0\n");
    check_full("3:1: a link whose joint is theta cannot be ppp; expected npr or ppr", "ppp,revolute,0,0,0,0\n");
    check_full("3:1: a link whose joint is d cannot be npr; expected npp or ppp", "npr,d,0,90,0,0\n");
    check_full("3:1: a link whose joint is d cannot be ppr; expected npp or ppp", "ppr,d,0,0,0,0\n");
    check_full("3:21: low is above high", "npr,theta,0,90,0,0,,10,9.5\n");
    check_full("3:28: backlash: \"-1\" is negative", "npr,theta,0,90,0,0,0,10,10,-1\n");
    check_full("3:24: compliance: \"-0.1\" is negative", "npr,theta,0,90,0,0,,,,,-0.1,1\n");
    check_full("3:26: moment: \"-2\" is negative", "npr,theta,0,90,0,0,,,,,1,-2\n");
    check_drive("3:16: bits: \"17.5\" is no whole number from 1 to 64", "bits", "17.5");
    check_drive("3:16: bits: \"0\" is no whole number from 1 to 64", "bits", "0");
    check_drive("3:16: stiffness: \"0\" is not greater than zero", "stiffness", "0");
    check_drive("3:16: mass: \"-1\" is negative", "mass", "-1");
    check_drive("3:16: com_y without mass", "com_y", "-1");
    check_drive("3:18: stiffness beside compliance; expected one of the two", "compliance,stiffness", "1,1");
    check_drive("3:18: bits beside resolution; expected one of the two", "resolution,bits", "1,1");
    check_refused("3:11: bits are those of a turn; expected resolution",
                  UNITS "joint,a,alpha,d,theta,bits\nd,0,0,0,0,17\n");
    check_full("3:26: moment without compliance; only their product counts", "npr,theta,0,90,0,0,,,,,-,1\n");
    check_full("3:21: a fixed link has no low; expected - or an empty cell", "npr,fixed,0,90,0,0,,0,1\n");
    check_full("3:21: low: \"inf\" is not a finite number", "npr,theta,0,90,0,0,,inf,\n");
    check_full("3:22: high: \"-inf\" is not a finite number", "npr,theta,0,90,0,0,,,-inf\n");
}

static void test_quotes_that_are_wrong(void)
{
    check_refused("3:7: the quoted cell does not end on this line", HEAD "theta,\"0,0,1,2\n");
    check_refused("3:8: the quoted cell does not end on this line", HEAD "theta, \"0\"\",0,1,2\n");
    check_refused("3:11: text behind the quoted cell; expected a separator or the end of the line",
                  HEAD "theta,\"0\" x,0,1,2\n");
    check_refused("3:10: text behind the quoted cell; expected a separator or the end of the line",
                  UNITS "joint a alpha d theta\ntheta \"0\"0 0 1 2\n");
    check_refused("2:19: the quoted cell does not end on this line", UNITS "joint,alpha,theta,\"a\n");
    check_refused("2:24: the quoted cell does not end on this line", UNITS "name,joint,alpha,theta,\"a\n");
}

static void test_what_is_no_text(void)
{
    static const char utf_16[] = "\xff\xfeu\0n\0i\0t\0s\0\n\0";
    static const char without_mark[] = "u\0n\0i\0t\0s\0\n\0";
    check_refused_bytes("1:1: the file is UTF-16; " SAVE_AS, utf_16, sizeof utf_16);
    check_refused_bytes("1:1: the file is UTF-16; " SAVE_AS, "\xfe\xff\0u", 4);
    check_refused_bytes("1:2: a zero byte: UTF-16, or no text; " SAVE_AS, without_mark, sizeof without_mark);
    check_refused("2:4: a control character, which has no meaning here", "\n# a\033[31m");
    check_refused("1:1: a control character, which has no meaning here", "\177");
    check_refused("1:4: a control character, which has no meaning here", "# \xc2\xa0\xc2\x9b" "31m");
    check_refused("1:7: a character that is not UTF-8; " SAVE_AS, "# Gr\xc3\xbc\xc3\x9f" "\xfc\n");
    check_refused("1:4: a character that is not UTF-8; " SAVE_AS, "# x\xc3");           /* cut */
    check_refused("1:3: a character that is not UTF-8; " SAVE_AS, "# \xc0\xaf");        /* too long a form */
    check_refused("1:3: a character that is not UTF-8; " SAVE_AS, "# \xe0\x80\x80");
    check_refused("1:3: a character that is not UTF-8; " SAVE_AS, "# \xed\xa0\x80");     /* half of a pair */
    check_refused("1:3: a character that is not UTF-8; " SAVE_AS, "# \xf4\x90\x80\x80"); /* beyond the last */
}

static void test_a_line_without_an_end(void)
{
    enum { LENGTH = 10000000 };
    char *text = malloc(LENGTH);
    TEST_ASSERT_NOT_NULL(text);
    memset(text, '1', LENGTH);
    check_refused_bytes("1:65537: the line is too long; expected at most 65536 bytes", text, LENGTH);
    /* as long as a line may be, it is taken */
    memset(text, ' ', LENGTH);
    static const char head[] = "units: m rad";
    static const char table[] = "\njoint,a,alpha,d,theta\ntheta,0,0,0,0\n";
    memcpy(text, head, strlen(head));
    memcpy(text + 65536, table, sizeof table);
    arm_model model;
    read_table(text, &model);
    arm_model_free(&model);
    free(text);
}

static void test_how_many_links(void)
{
    static const char head[] = HEAD, row[] = "theta,0,0,0,0\n";
    enum { MOST = 1000 };
    char *text = malloc(sizeof head + (MOST + 1) * sizeof row);
    TEST_ASSERT_NOT_NULL(text);
    strcpy(text, head);
    for (int i = 0; i < MOST; i++) {
        strcat(text, row);
    }
    arm_model model;
    read_table(text, &model);
    TEST_ASSERT_EQUAL_UINT(MOST, model.arm.n_links);
    arm_model_free(&model);
    strcat(text, row);
    check_refused("1003:1: more than 1000 links", text);
    free(text);
}

static void check_stream(const char *expected, FILE *stream, const char *path)
{
    arm_model model;
    said said;
    TEST_ASSERT_NOT_NULL(stream);
    said_begin();
    const bool fine = arm_file_read(stream, path, &model);
    said_end(&said);
    fclose(stream);
    TEST_ASSERT_EQUAL_STRING(expected, said.text);
    TEST_ASSERT_FALSE(fine);
}

static void test_what_cannot_be_read(void)
{
    check_stream("armtol: a/folder: Is a directory\n", fopen(".", "rb"), "a/folder");
    check_stream("armtol: closed: Bad file descriptor\n", fopen("/dev/null", "wb"), "closed");
}

/* ---- writing ---- */

static void write_bytes(const armtol_arm *arm, angle_unit unit, char *text, size_t size)
{
    FILE *stream = tmpfile();
    TEST_ASSERT_NOT_NULL(stream);
    arm_file_write(arm, ORDER_PAUL, unit, stream);
    rewind(stream);
    const size_t length = fread(text, 1, size, stream);
    TEST_ASSERT_TRUE(length < size);
    text[length] = '\0';
    fclose(stream);
}

static void test_a_table_is_laid_out_for_people(void)
{
    static const armtol_link links[] = {
        {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = DEG_90, .d = 0.5},
        {ARMTOL_PPP, ARMTOL_PRISMATIC, .a = -100.25, .theta = -DEG_90},
        {ARMTOL_NPR, ARMTOL_FIXED, .alpha = DEG_30},
    };
    const double inf = (double)INFINITY, unknown = (double)NAN;
    const armtol_drive drives[] = {
        {-DEG_160, DEG_30, unknown, 0, 0}, {-3, inf, unknown, 0, 0}, {1, 2, 3, 4, 5}};
    const armtol_arm arm = {"x1", "Number #1", "", ARMTOL_METRE, 3, links, drives};
    static char text[2000];
    write_bytes(&arm, UNIT_DEGREE, text, sizeof text);
    TEST_ASSERT_EQUAL_STRING("name: x1\n"
                             "title: \"Number #1\"\n"
                             "units: m deg\n"
                             "\n"
                             "kind, joint,       a, alpha,   d, theta,  low, high\n"
                             "npr,  theta,       0,    90, 0.5,     0, -160,   30\n"
                             "ppp,  d,     -100.25,     0,   0,   -90,   -3,    -\n"
                             "npr,  fixed,       0,    30,   0,     0,    -,    -\n",
                             text);
}

/* Every bit of it, -0 and nan included. */
static void check_same_bits(const armtol_arm *expected, const armtol_arm *arm, const char *what)
{
    TEST_ASSERT_EQUAL_STRING_MESSAGE(expected->name, arm->name, what);
    TEST_ASSERT_EQUAL_STRING_MESSAGE(expected->title, arm->title, what);
    TEST_ASSERT_EQUAL_STRING_MESSAGE(expected->source, arm->source, what);
    TEST_ASSERT_EQUAL_INT_MESSAGE(expected->unit, arm->unit, what);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->n_links, arm->n_links, what);
    for (size_t i = 0; i < arm->n_links; i++) {
        const armtol_link *one = &expected->links[i], *other = &arm->links[i];
        TEST_ASSERT_TRUE_MESSAGE(one->kind == other->kind && one->joint == other->joint, what);
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&one->a, &other->a, 5 * sizeof one->a, what);
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&expected->drives[i], &arm->drives[i], sizeof arm->drives[i], what);
    }
}

static void check_round_trip(const armtol_arm *arm, angle_unit unit, const char *what)
{
    static char text[1 << 18];
    arm_model model;
    write_bytes(arm, unit, text, sizeof text);
    read_table(text, &model);
    check_same_bits(arm, &model.arm, what);
    TEST_ASSERT_EQUAL_INT(unit, model.angle_unit);
    arm_model_free(&model);
}

static void test_every_built_in_arm_comes_back(void)
{
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        const armtol_arm *arm = armtol_arm_at(i);
        check_round_trip(arm, UNIT_RADIAN, arm->name);
        check_round_trip(arm, UNIT_DEGREE, arm->name);
    }
}

/* Over a hundred powers of ten; some are 0, with either sign. */
static double draw_number(random_source *random)
{
    const double kind = random_between(random, 0, 10), mantissa = random_between(random, -10, 10);
    if (kind < 1) {
        return copysign(0, mantissa);
    }
    return kind < 7 ? mantissa : mantissa * pow(10, random_between(random, -100, 10));
}

static bool draw_yes(random_source *random)
{
    return random_between(random, 0, 2) < 1;
}

static armtol_link draw_link(random_source *random)
{
    static const armtol_kind kinds[] = {ARMTOL_NPR, ARMTOL_PPR, ARMTOL_NPP, ARMTOL_PPP};
    const armtol_joint joint = (armtol_joint)random_between(random, 0, ARMTOL_JOINT_COUNT);
    const size_t first = joint == ARMTOL_PRISMATIC ? 2 : 0, n = joint == ARMTOL_FIXED ? 4 : 2;
    armtol_link link = {.kind = kinds[first + (size_t)random_between(random, 0, (double)n)], .joint = joint};
    double *const numbers[] = {&link.a, &link.alpha, &link.d, &link.theta, &link.beta};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        *numbers[i] = draw_number(random);
    }
    return link;
}

static armtol_drive draw_drive(random_source *random)
{
    armtol_drive drive = armtol_drive_unknown;
    drive.low = draw_yes(random) ? draw_number(random) : drive.low;
    drive.high = draw_yes(random) ? fabs(draw_number(random)) + fmax(drive.low, 0) : drive.high;
    drive.backlash = draw_yes(random) ? fabs(draw_number(random)) : drive.backlash;
    if (draw_yes(random)) {
        drive.compliance = fabs(draw_number(random));
        drive.moment = fabs(draw_number(random));
    }
    drive.resolution = draw_yes(random) ? fabs(draw_number(random)) : 0;
    drive.friction = draw_yes(random) ? fabs(draw_number(random)) : 0;
    drive.noise = draw_yes(random) ? fabs(draw_number(random)) : 0;
    return drive;
}

enum { MOST_DRAWN = 12 };

static void check_drawn_arm(random_source *random, int number)
{
    static const char *const texts[] = {"plain",     "two words", "a #1",    "\"quoted\"", "in \"the\" middle",
                                        " blank",    "comma,",    "a; b, c", "# all",      "\xc3\xbc\xe2\x82\xac",
                                        "units: mm", "\"",        "-",       ";\t,"};
    enum { TEXTS = sizeof texts / sizeof texts[0] };
    armtol_link links[MOST_DRAWN];
    armtol_drive drives[MOST_DRAWN];
    armtol_mass masses[MOST_DRAWN];
    const bool weighs = draw_yes(random);
    const size_t n = 1 + (size_t)random_between(random, 0, MOST_DRAWN);
    for (size_t i = 0; i < n; i++) {
        links[i] = draw_link(random);
        drives[i] = links[i].joint == ARMTOL_FIXED ? armtol_drive_unknown : draw_drive(random);
        masses[i] = (armtol_mass){fabs(draw_number(random)), {draw_number(random), draw_number(random), 0}};
    }
    if (links[n - 1].kind == ARMTOL_PPR) {
        links[n - 1].kind = ARMTOL_NPR; /* of a ppr something might be said */
    }
    const armtol_arm arm = {
        .name = texts[(size_t)random_between(random, 0, TEXTS)],
        .title = texts[(size_t)random_between(random, 0, TEXTS)],
        .source = texts[(size_t)random_between(random, 0, TEXTS)],
        .unit = draw_yes(random) ? ARMTOL_MILLIMETRE : ARMTOL_METRE,
        .n_links = n, .links = links, .drives = drives,
        .masses = weighs ? masses : NULL,
    };
    char what[40];
    snprintf(what, sizeof what, "arm %d", number);
    check_round_trip(&arm, draw_yes(random) ? UNIT_DEGREE : UNIT_RADIAN, what);
}

static void test_an_arm_that_is_written_comes_back_to_the_bit(void)
{
    random_source random = {1983};
    for (int i = 0; i < 200; i++) {
        check_drawn_arm(&random, i);
    }
}

/* ---- anything at all ---- */

/* Changes, drops or doubles some bytes, or copies some from elsewhere. */
static size_t mutate(random_source *random, char *text, size_t length, size_t size)
{
    static const char alphabet[] = "\n\r\t ,;#\"-.:0179eEinfmdag\xc3\xa4\xff";
    const int changes = 1 + (int)random_between(random, 0, 5);
    for (int i = 0; i < changes && length > 1; i++) {
        const size_t at = (size_t)random_between(random, 0, (double)length);
        switch ((int)random_between(random, 0, 4)) {
        case 0:
            text[at] = alphabet[(size_t)random_between(random, 0, sizeof alphabet)];
            break;
        case 1:
            memmove(text + at, text + at + 1, --length - at);
            break;
        case 2:
            if (length < size) {
                memmove(text + at + 1, text + at, length++ - at);
            }
            break;
        default:
            text[at] = text[(size_t)random_between(random, 0, (double)length)];
        }
    }
    return length;
}

/* Whatever a file holds, it is an arm that comes back when it is written, or there is one line on why it is none. */
static void check_anything(const char *bytes, size_t length, bool *was_fine)
{
    arm_model model;
    said said;
    *was_fine = read_bytes(bytes, length, "fuzz", &model, &said);
    if (*was_fine) {
        TEST_ASSERT_EQUAL_STRING("", said.text);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_check(model.arm.links, model.arm.n_links));
        check_round_trip(&model.arm, model.angle_unit, "fuzz");
    } else {
        TEST_ASSERT_EQUAL_STRING_LEN("armtol: fuzz", said.text, strlen("armtol: fuzz"));
        TEST_ASSERT_EQUAL_PTR(strrchr(said.text, '\n'), strchr(said.text, '\n'));
    }
    arm_model_free(&model);
}

static void test_anything_at_all(void)
{
    static const char quoted[] = "\xef\xbb\xbf\"name\";\"t\"\r\n\"title: a; \"\"b\"\"\";;\r\nunits;m;rad;;\r\n"
                                 "\"joint\";a;alpha;d;theta\r\nd;3,5;\"1,5\";0;-1;;\r\nfixed;0;0;0;0\r\n";
    static const struct {
        const char *text;
        size_t length;
    } seeds[] = {{full_table, sizeof full_table - 1}, {quoted, sizeof quoted - 1}};
    random_source random = {7};
    int fine = 0;
    for (int i = 0; i < TEST_FUZZ; i++) {
        char text[2000];
        size_t length = seeds[i % 2].length;
        bool was_fine;
        memcpy(text, seeds[i % 2].text, length);
        length = mutate(&random, text, length, sizeof text);
        check_anything(text, length, &was_fine);
        fine += was_fine;
    }
    TEST_ASSERT_TRUE(fine > TEST_FUZZ / 20 && fine < TEST_FUZZ * 19 / 20);
}

int main(void)
{
    message_start("armtol");
    UNITY_BEGIN();
    RUN_TEST(test_a_table_that_says_all);
    RUN_TEST(test_drives);
    RUN_TEST(test_drives_and_masses);
    RUN_TEST(test_what_is_left_out);
    RUN_TEST(test_an_arm_without_a_name_has_its_files);
    RUN_TEST(test_what_people_type);
    RUN_TEST(test_what_spreadsheets_write);
    RUN_TEST(test_kinds_that_a_table_leaves_to_the_axes);
    RUN_TEST(test_a_last_link_that_counts_no_length_is_noted);
    RUN_TEST(test_the_tables_of_the_documentation);
    RUN_TEST(test_wrong_keys);
    RUN_TEST(test_wrong_head_rows);
    RUN_TEST(test_wrong_numbers_of_cells);
    RUN_TEST(test_wrong_cells);
    RUN_TEST(test_a_number_of_many_digits);
    RUN_TEST(test_of_two_mistakes_the_first_is_told);
    RUN_TEST(test_rows_that_contradict_themselves);
    RUN_TEST(test_quotes_that_are_wrong);
    RUN_TEST(test_what_is_no_text);
    RUN_TEST(test_a_line_without_an_end);
    RUN_TEST(test_how_many_links);
    RUN_TEST(test_what_cannot_be_read);
    RUN_TEST(test_a_table_is_laid_out_for_people);
    RUN_TEST(test_every_built_in_arm_comes_back);
    RUN_TEST(test_an_arm_that_is_written_comes_back_to_the_bit);
    RUN_TEST(test_anything_at_all);
    return UNITY_END();
}
