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
    urdf_fault fault;     /* of the element at hand */
    bool wrong; /* a message has been given */
} parser;

/* ---- one joint ---- */

static bool read_origin(const urdf_element *element, urdf_joint *joint)
{
    const double *q = joint->quaternion;
    joint->has_quaternion = urdf_attribute(element, "quat_xyzw") != NULL;
    if (joint->has_quaternion && urdf_attribute(element, "rpy") != NULL) {
        return urdf_element_fault(element, "<origin> has both rpy and quat_xyzw; expected one of them");
    }
    if (!urdf_attribute_numbers(element, "xyz", 3, joint->xyz) ||
        !urdf_attribute_numbers(element, "rpy", 3, joint->rpy) ||
        !urdf_attribute_numbers(element, "quat_xyzw", 4, joint->quaternion)) {
        return false;
    }
    const bool fine = !joint->has_quaternion || q[0] != 0 || q[1] != 0 || q[2] != 0 || q[3] != 0;
    return fine || urdf_element_fault(element, "quat_xyzw of <origin> is 0 0 0 0; expected a rotation");
}

static bool read_axis(const urdf_element *element, urdf_joint *joint)
{
    const char *text;
    return urdf_attribute_text(element, "xyz", &text) &&
           urdf_attribute_numbers(element, "xyz", 3, joint->axis);
}

static bool read_end(const urdf_element *element, urdf_joint *joint)
{
    const char *text;
    char **const name = strcmp(element->name, "parent") == 0 ? &joint->parent_name : &joint->child_name;
    return urdf_attribute_text(element, "link", &text) && urdf_tree_keep(name, text);
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
    return joint->low <= joint->high ||
           urdf_element_fault(element, "the limits of joint %s are %g and %g; expected lower <= upper",
                              message_quote(joint->name, &(quoted){""}), joint->low, joint->high);
}

static bool read_mimic(const urdf_element *element, urdf_joint *joint)
{
    const char *leader;
    return urdf_attribute_text(element, "joint", &leader) && urdf_tree_keep(&joint->leader_name, leader) &&
           urdf_attribute_numbers(element, "multiplier", 1, &joint->multiplier) &&
           urdf_attribute_numbers(element, "offset", 1, &joint->offset);
}

static const struct {
    const char *name;
    bool (*read)(const urdf_element *element, urdf_joint *joint);
} parts[PARTS] = {
    [PART_ORIGIN] = {"origin", read_origin}, [PART_AXIS] = {"axis", read_axis},
    [PART_PARENT] = {"parent", read_end},    [PART_CHILD] = {"child", read_end},
    [PART_LIMIT] = {"limit", read_limit},    [PART_MIMIC] = {"mimic", read_mimic},
};

/* A fault that keeps the tree from being built; without one memory was short, which has been said. */
static bool say_fault(const urdf_element *element)
{
    if (element->fault->text[0] != '\0') {
        file_message(&element->place, "%s", element->fault->text);
    }
    return false;
}

/* A fault that matters where the joint is needed, the first of it. */
static bool keep_fault(const urdf_element *element, urdf_joint *joint)
{
    if (element->fault->text[0] == '\0') {
        return false;
    }
    if (joint->fault != NULL) {
        return true;
    }
    joint->fault_place = element->place;
    return urdf_tree_keep(&joint->fault, element->fault->text);
}

static bool read_part_of(parser *parser, const urdf_element *element, part part, urdf_joint *joint)
{
    const bool fine = parser->has_part[part]
                          ? urdf_element_fault(element, "a second <%s> in joint %s", element->name,
                                               message_quote(joint->name, &(quoted){""}))
                          : parts[part].read(element, joint);
    const bool of_tree = part == PART_PARENT || part == PART_CHILD;
    parser->has_part[part] = true;
    return fine || (of_tree ? say_fault(element) : keep_fault(element, joint));
}

static bool read_part(parser *parser, const urdf_element *element)
{
    urdf_joint *const joint = &parser->tree->joints[parser->tree->n_joints - 1];
    for (part part = 0; part < PARTS; part++) {
        if (strcmp(element->name, parts[part].name) == 0) {
            return read_part_of(parser, element, part, joint);
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
    return urdf_element_fault(element,
                              "joint %s is of type %s; expected fixed, revolute, continuous, prismatic, planar or "
                              "floating",
                              message_quote(joint->name, &(quoted){""}), message_quote(type, &(quoted){""}));
}

static bool begin_joint(parser *parser, const urdf_element *element)
{
    const char *name;
    memset(parser->has_part, 0, sizeof parser->has_part);
    if (!urdf_attribute_text(element, "name", &name)) {
        return say_fault(element);
    }
    if (!urdf_tree_add_joint(parser->tree, name, &element->place)) {
        return false;
    }
    urdf_joint *const joint = &parser->tree->joints[parser->tree->n_joints - 1];
    return read_type(element, joint) || keep_fault(element, joint);
}

static bool has_direction(const urdf_joint *joint)
{
    return !urdf_joint_moves(joint) || joint->axis[0] != 0 || joint->axis[1] != 0 || joint->axis[2] != 0;
}

static bool check_axis(parser *parser, urdf_joint *joint)
{
    const urdf_element element = {.place = joint->place, .fault = &parser->fault};
    return has_direction(joint) ||
           urdf_element_fault(&element, "the axis of joint %s is 0 0 0; expected a direction",
                              message_quote(joint->name, &(quoted){""})) ||
           keep_fault(&element, joint);
}

static bool end_joint(parser *parser)
{
    urdf_joint *const joint = &parser->tree->joints[parser->tree->n_joints - 1];
    for (int i = PART_PARENT; i <= PART_CHILD; i++) {
        if (!parser->has_part[i]) {
            file_message(&joint->place, "joint %s has no <%s>", message_quote(joint->name, &(quoted){""}),
                         parts[i].name);
            return false;
        }
    }
    parser->fault.text[0] = '\0';
    return check_axis(parser, joint);
}

/* ---- one link ---- */

static bool a_second(const parser *parser, const urdf_element *element)
{
    const urdf_link *const link = &parser->tree->links[parser->tree->n_links - 1];
    file_message(&element->place, "a second <%s> in link %s", element->name, message_quote(link->name, &(quoted){""}));
    return false;
}

static bool read_mass(const urdf_element *element, urdf_link *link)
{
    const char *text;
    if (!urdf_attribute_text(element, "value", &text) || !urdf_attribute_numbers(element, "value", 1, &link->mass)) {
        return false;
    }
    return link->mass >= 0 || urdf_element_fault(element, "the mass of link %s is %g; expected 0 or more",
                                                 message_quote(link->name, &(quoted){""}), link->mass);
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
    const bool fine = mass ? read_mass(element, link) : urdf_attribute_numbers(element, "xyz", 3, link->center);
    return fine || say_fault(element);
}

static bool end_link(const parser *parser)
{
    const urdf_link *const link = &parser->tree->links[parser->tree->n_links - 1];
    if (parser->has_inertial && !parser->has_mass) {
        file_message(&link->place, "link %s has an <inertial> without a <mass>",
                     message_quote(link->name, &(quoted){""}));
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
    return urdf_attribute_text(element, "name", &name) ? urdf_tree_keep(&parser->tree->robot, name)
                                                       : say_fault(element);
}

static bool begin_link(parser *parser, const urdf_element *element)
{
    const char *name;
    parser->in_link = true;
    parser->has_inertial = parser->has_mass = parser->has_center = false;
    return urdf_attribute_text(element, "name", &name) ? urdf_tree_add_link(parser->tree, name, &element->place)
                                                       : say_fault(element);
}

/* What only defines does no harm where nothing uses it; what uses it is looked at where it stands. */
static bool begin_xacro(parser *parser, const urdf_element *element)
{
    static const char *const definitions[] = {"xacro:property", "xacro:arg", "xacro:macro"};
    for (size_t i = 0; i < sizeof definitions / sizeof definitions[0]; i++) {
        if (strcmp(element->name, definitions[i]) == 0) {
            parser->passed_over = parser->depth;
            return true;
        }
    }
    file_message(&element->place, "the file holds %s, which is xacro; expand it with xacro first, or say --xacro",
                 message_quote(element->name, &(quoted){""}));
    return false;
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
        const bool second = parser->has_inertial;
        parser->has_inertial = true;
        return !second || a_second(parser, element);
    }
    parser->passed_over = parser->depth;
    if (parser->in_link) {
        return parser->depth == 3 || read_inertial(parser, element);
    }
    return read_part(parser, element);
}

static bool begin(parser *parser, const urdf_element *element)
{
    if (parser->passed_over != 0) {
        return true;
    }
    if (strncmp(element->name, "xacro:", strlen("xacro:")) == 0) {
        return begin_xacro(parser, element);
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
        const urdf_element element = {name, (const char *const *)attributes, place_of(parser), &parser->fault};
        parser->fault.text[0] = '\0';
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

/* Letters of an older code in a file that does not name it are no UTF-8. */
static const char *advice(const parser *parser, enum XML_Error error)
{
    int offset = 0, size = 0;
    const char *const text = XML_GetInputContext(parser->xml, &offset, &size);
    const bool letter = error == XML_ERROR_INVALID_TOKEN && text != NULL && offset < size && (text[offset] & 0x80) != 0;
    const bool code = error == XML_ERROR_UNKNOWN_ENCODING || error == XML_ERROR_PARTIAL_CHAR;
    return letter || code ? "; the text is in an older code than UTF-8; save the file as UTF-8" : "";
}

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
        file_message(&place, "not XML: %s%s", XML_ErrorString(error), advice(parser, error));
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
