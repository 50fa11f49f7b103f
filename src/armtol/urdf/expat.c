#include "armtol/urdf/parse.h"

#include "armtol/urdf/attributes.h"
#include "console/exit_code.h"
#include "console/message.h"

#include <errno.h>
#include <expat.h>
#include <string.h>

/* The parts of a <joint>. */
typedef enum part { PART_ORIGIN, PART_AXIS, PART_PARENT, PART_CHILD, PART_LIMIT, PART_MIMIC, PARTS } part;

typedef struct parser {
    XML_Parser xml;
    urdf_tree *tree;
    size_t depth;       /* of the element at hand, 1 for <robot> */
    size_t passed_over; /* the depth of an element that is nothing to us, nor is what it holds; else 0 */
    bool has_part[PARTS]; /* of the joint at hand */
    bool in_link;         /* the element of depth 2 at hand is a <link> */
    bool has_inertial, has_mass, has_center; /* of the link at hand */
    bool wrong; /* a message has been given */
} parser;

/* ---- one joint ---- */

static bool read_origin(const urdf_element *element, urdf_joint *joint)
{
    return urdf_attribute_numbers(element, "xyz", 3, joint->xyz) &&
           urdf_attribute_numbers(element, "rpy", 3, joint->rpy);
}

static bool read_axis(const urdf_element *element, urdf_joint *joint)
{
    const char *text;
    return urdf_attribute_text(element, "xyz", &text) &&
           urdf_attribute_numbers(element, "xyz", 3, joint->axis);
}

static bool read_parent(const urdf_element *element, urdf_joint *joint)
{
    const char *text;
    return urdf_attribute_text(element, "link", &text) && urdf_tree_keep(&joint->parent_name, text);
}

static bool read_child(const urdf_element *element, urdf_joint *joint)
{
    const char *text;
    return urdf_attribute_text(element, "link", &text) && urdf_tree_keep(&joint->child_name, text);
}

/* The format has 0 for the one of the two that is not given; where neither is, we take it as nothing said. */
static bool read_limit(const urdf_element *element, urdf_joint *joint)
{
    const bool given = urdf_attribute(element, "lower") != NULL || urdf_attribute(element, "upper") != NULL;
    if (joint->type == URDF_CONTINUOUS || !given) {
        return true;
    }
    joint->low = joint->high = 0;
    if (!urdf_attribute_numbers(element, "lower", 1, &joint->low) ||
        !urdf_attribute_numbers(element, "upper", 1, &joint->high)) {
        return false;
    }
    if (joint->low > joint->high) {
        file_message(&element->place, "the limits of joint %s are %g and %g; expected lower <= upper",
                     message_quote(joint->name, &(quoted){""}), joint->low, joint->high);
        return false;
    }
    return true;
}

static bool read_mimic(const urdf_element *element, urdf_joint *joint)
{
    (void)element;
    joint->mimics = true;
    return true;
}

static const struct {
    const char *name;
    bool (*read)(const urdf_element *element, urdf_joint *joint);
} parts[PARTS] = {
    [PART_ORIGIN] = {"origin", read_origin}, [PART_AXIS] = {"axis", read_axis},
    [PART_PARENT] = {"parent", read_parent}, [PART_CHILD] = {"child", read_child},
    [PART_LIMIT] = {"limit", read_limit},    [PART_MIMIC] = {"mimic", read_mimic},
};

static bool read_part(parser *parser, const urdf_element *element)
{
    urdf_joint *const joint = &parser->tree->joints[parser->tree->n_joints - 1];
    for (size_t i = 0; i < PARTS; i++) {
        if (strcmp(element->name, parts[i].name) == 0) {
            if (parser->has_part[i]) {
                file_message(&element->place, "a second <%s> in joint %s", element->name,
                             message_quote(joint->name, &(quoted){""}));
                return false;
            }
            parser->has_part[i] = true;
            return parts[i].read(element, joint);
        }
    }
    return true;
}

static bool read_type(const urdf_element *element, urdf_joint *joint)
{
    const char *type;
    if (!urdf_attribute_text(element, "type", &type)) {
        return false;
    }
    for (size_t i = 0; i < URDF_JOINT_TYPES; i++) {
        if (strcmp(type, urdf_joint_type_names[i]) == 0) {
            joint->type = (urdf_joint_type)i;
            return true;
        }
    }
    file_message(&element->place,
                 "joint %s is of type %s; expected fixed, revolute, continuous, prismatic, planar or "
                 "floating",
                 message_quote(joint->name, &(quoted){""}), message_quote(type, &(quoted){""}));
    return false;
}

static bool begin_joint(parser *parser, const urdf_element *element)
{
    const char *name;
    memset(parser->has_part, 0, sizeof parser->has_part);
    return urdf_attribute_text(element, "name", &name) &&
           urdf_tree_add_joint(parser->tree, name, &element->place) &&
           read_type(element, &parser->tree->joints[parser->tree->n_joints - 1]);
}

static bool has_direction(const urdf_joint *joint)
{
    const bool has_axis = joint->type == URDF_REVOLUTE || joint->type == URDF_CONTINUOUS ||
                          joint->type == URDF_PRISMATIC;
    return !has_axis || joint->axis[0] != 0 || joint->axis[1] != 0 || joint->axis[2] != 0;
}

static bool end_joint(const parser *parser)
{
    const urdf_joint *const joint = &parser->tree->joints[parser->tree->n_joints - 1];
    for (int i = PART_PARENT; i <= PART_CHILD; i++) {
        if (!parser->has_part[i]) {
            file_message(&joint->place, "joint %s has no <%s>", message_quote(joint->name, &(quoted){""}),
                         parts[i].name);
            return false;
        }
    }
    if (!has_direction(joint)) {
        file_message(&joint->place, "the axis of joint %s is 0 0 0; expected a direction",
                     message_quote(joint->name, &(quoted){""}));
        return false;
    }
    return true;
}

/* ---- one link ---- */

static bool a_second(const parser *parser, const urdf_element *element)
{
    const urdf_link *const link = &parser->tree->links[parser->tree->n_links - 1];
    file_message(&element->place, "a second <%s> in link %s", element->name, message_quote(link->name, &(quoted){""}));
    return false;
}

static bool begin_inertial(parser *parser, const urdf_element *element)
{
    if (parser->has_inertial) {
        return a_second(parser, element);
    }
    parser->has_inertial = true;
    return true;
}

static bool read_mass(const urdf_element *element, urdf_link *link)
{
    const char *text;
    if (!urdf_attribute_text(element, "value", &text) || !urdf_attribute_numbers(element, "value", 1, &link->mass)) {
        return false;
    }
    if (link->mass < 0) {
        file_message(&element->place, "the mass of link %s is %g; expected 0 or more",
                     message_quote(link->name, &(quoted){""}), link->mass);
        return false;
    }
    return true;
}

/* Of what <inertial> holds the mass and its center matter here; how its axes lie does not. */
static bool read_inertial(parser *parser, const urdf_element *element)
{
    urdf_link *const link = &parser->tree->links[parser->tree->n_links - 1];
    const bool mass = strcmp(element->name, "mass") == 0, origin = strcmp(element->name, "origin") == 0;
    bool *const has = mass ? &parser->has_mass : &parser->has_center;
    if (!mass && !origin) {
        return true;
    }
    if (*has) {
        return a_second(parser, element);
    }
    *has = true;
    return mass ? read_mass(element, link) : urdf_attribute_numbers(element, "xyz", 3, link->center);
}

static bool end_link(const parser *parser)
{
    const urdf_link *const link = &parser->tree->links[parser->tree->n_links - 1];
    if (parser->has_inertial && !parser->has_mass) {
        file_message(&link->place, "link %s has an <inertial> without a <mass>", message_quote(link->name, &(quoted){""}));
        return false;
    }
    return true;
}

/* ---- elements ---- */

static file_place place_of(const parser *parser)
{
    return (file_place){parser->tree->path, (size_t)XML_GetCurrentLineNumber(parser->xml),
                        (size_t)XML_GetCurrentColumnNumber(parser->xml) + 1};
}

static void stop(parser *parser)
{
    parser->wrong = true;
    XML_StopParser(parser->xml, XML_FALSE);
}

static bool begin_robot(parser *parser, const urdf_element *element)
{
    const char *name;
    if (strcmp(element->name, "robot") != 0) {
        file_message(&element->place, "the file holds %s; expected a URDF, <robot name=\"...\">",
                     message_quote(element->name, &(quoted){""}));
        return false;
    }
    return urdf_attribute_text(element, "name", &name) && urdf_tree_keep(&parser->tree->robot, name);
}

static bool begin_link(parser *parser, const urdf_element *element)
{
    const char *name;
    parser->in_link = true;
    parser->has_inertial = parser->has_mass = parser->has_center = false;
    return urdf_attribute_text(element, "name", &name) &&
           urdf_tree_add_link(parser->tree, name, &element->place);
}

/* A link, a joint, or nothing to us. */
static bool begin_thing(parser *parser, const urdf_element *element)
{
    parser->in_link = false;
    if (strcmp(element->name, "joint") == 0) {
        return begin_joint(parser, element);
    }
    if (strcmp(element->name, "link") == 0) {
        return begin_link(parser, element);
    }
    parser->passed_over = parser->depth;
    return true;
}

static bool begin_below(parser *parser, const urdf_element *element)
{
    if (parser->in_link && parser->depth == 3 && strcmp(element->name, "inertial") == 0) {
        return begin_inertial(parser, element);
    }
    parser->passed_over = parser->depth;
    if (parser->in_link) {
        return parser->depth == 3 || read_inertial(parser, element);
    }
    return read_part(parser, element);
}

static bool begin(parser *parser, const urdf_element *element)
{
    if (strncmp(element->name, "xacro:", strlen("xacro:")) == 0) {
        file_message(&element->place, "the file holds %s, which is xacro; expand it with xacro first",
                     message_quote(element->name, &(quoted){""}));
        return false;
    }
    if (parser->passed_over != 0) {
        return true;
    }
    if (parser->depth == 1) {
        return begin_robot(parser, element);
    }
    return parser->depth == 2 ? begin_thing(parser, element) : begin_below(parser, element);
}

static void on_start(void *data, const XML_Char *name, const XML_Char **attributes)
{
    parser *const parser = data;
    if (!parser->wrong) {
        const urdf_element element = {name, (const char *const *)attributes, place_of(parser)};
        parser->depth++;
        if (!begin(parser, &element)) {
            stop(parser);
        }
    }
}

/* What is not passed over in depth 2 is a link or a joint. */
static void on_end(void *data, const XML_Char *name)
{
    parser *const parser = data;
    (void)name;
    if (parser->wrong) {
        return;
    }
    if (parser->passed_over == 0 && parser->depth == 2 && !(parser->in_link ? end_link(parser) : end_joint(parser))) {
        stop(parser);
    }
    if (parser->passed_over == parser->depth) {
        parser->passed_over = 0;
    }
    parser->depth--;
}

/* It may define entities, which have no place in a URDF: a few lines of them grow beyond any memory. */
static void on_doctype(void *data, const XML_Char *name, const XML_Char *system, const XML_Char *public,
                       int has_subset)
{
    parser *const parser = data;
    (void)name;
    (void)system;
    (void)public;
    (void)has_subset;
    if (!parser->wrong) {
        const file_place place = place_of(parser);
        file_message(&place, "a document type declaration (<!DOCTYPE>); expected a URDF, which needs none");
        stop(parser);
    }
}

/* ---- the file ---- */

static bool say_error(const parser *parser)
{
    const enum XML_Error error = XML_GetErrorCode(parser->xml);
    const file_place place = place_of(parser);
    if (parser->wrong) {
        return false;
    }
    if (error == XML_ERROR_NO_MEMORY) {
        out_of_memory();
    } else if (XML_GetCurrentByteIndex(parser->xml) <= 0 && error == XML_ERROR_NO_ELEMENTS) {
        message("%s is empty; expected a URDF, <robot name=\"...\">", parser->tree->path);
    } else {
        file_message(&place, "not XML: %s", XML_ErrorString(error));
    }
    return false;
}

static bool parse_all(parser *parser, FILE *stream)
{
    enum { CHUNK = 1 << 14 };
    for (size_t n = CHUNK; n > 0;) {
        void *const buffer = XML_GetBuffer(parser->xml, CHUNK);
        if (buffer == NULL) {
            return say_error(parser);
        }
        n = fread(buffer, 1, CHUNK, stream);
        if (ferror(stream)) {
            exit_code_note_error(errno);
            message("%s: %s", parser->tree->path, strerror(errno));
            return false;
        }
        if (XML_ParseBuffer(parser->xml, (int)n, n == 0) != XML_STATUS_OK) {
            return say_error(parser);
        }
    }
    return true;
}

bool urdf_parse(FILE *stream, urdf_tree *tree)
{
    parser parser = {.xml = XML_ParserCreate(NULL), .tree = tree};
    if (parser.xml == NULL) {
        out_of_memory();
        return false;
    }
    XML_SetUserData(parser.xml, &parser);
    XML_SetElementHandler(parser.xml, on_start, on_end);
    XML_SetStartDoctypeDeclHandler(parser.xml, on_doctype);
    const bool fine = parse_all(&parser, stream);
    XML_ParserFree(parser.xml);
    return fine;
}
