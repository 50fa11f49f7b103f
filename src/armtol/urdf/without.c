#include "armtol/urdf/urdf.h"

#include "console/message.h"

static bool refuse(const char *path)
{
    message("%s is a URDF, and this armtol was built without expat, which reads them; install expat with its "
            "headers (package libexpat1-dev, expat-devel or expat) and build armtol again",
            path);
    return false;
}

bool urdf_read(FILE *stream, const char *path, const char *base, const char *tip, arm_model *model)
{
    (void)stream;
    (void)base;
    (void)tip;
    *model = (arm_model){.arm = {.name = NULL}};
    return refuse(path);
}

bool urdf_draw(FILE *stream, const char *path, const urdf_units *units, FILE *drawn)
{
    (void)stream;
    (void)units;
    (void)drawn;
    return refuse(path);
}

bool urdf_is_built_in(void)
{
    return false;
}
