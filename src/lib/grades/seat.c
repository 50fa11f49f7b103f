#include "armtol/seat.h"

#include <math.h>

armtol_seat armtol_seat_errors(double apart, double position, double play)
{
    const double off = position + play; /* the diameter of where the axis can be in a seat */
    const armtol_seat none = {(double)NAN, (double)NAN};
    return apart > 0 && position >= 0 && play >= 0 ? (armtol_seat){off / 2, off / apart} : none;
}
