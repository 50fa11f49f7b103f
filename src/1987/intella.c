/* intella: how precisely the parts of an Intelledex 605T have to be made (Hahn 1987). */

#include "1987/program.h"

int main(int argc, char *argv[])
{
    return program_main(argc, argv, &program_intella);
}
