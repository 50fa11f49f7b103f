/* The two programs in one module: which of them it is says the name that it is started by. */

#include "1987/program.h"

int main(int argc, char *argv[])
{
    return program_main(argc, argv, program_named(argv[0]));
}
