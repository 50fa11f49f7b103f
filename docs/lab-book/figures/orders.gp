# Ways to write the inverse kinematics, by how many of the published joint values they give.
# data: docs/lab-book/tools/part 'Configurations by how many' joint-orders --show histogram --format=tsv golden/published.tsv
load "style.inc"
set terminal svg size 820,400 font "sans-serif,13" background "white" name "orders"
set multiplot layout 1,2 margins 0.09,0.985,0.16,0.9 spacing 0.1,0
unset key
set style fill solid noborder
set boxwidth 0.8
set logscale y
set format y "10^{%T}"
set xlabel "joint values right"
set title offset 0,-0.6

# The zeros of a histogram are not on a logarithmic axis.
some(n) = n > 0 ? n : NaN
right(name) = name eq "any" ? NaN : real(name)
set title "intella: ways, of 12 values"
set yrange [0.5:3e6]
set xrange [-0.7:12.7]
set xtics 0, 2, 12
plot "orders.tsv" using (right(strcol(1))):(some($2)):(right(strcol(1)) == 12 ? 0xd55e00 : 0x0072b2) every ::1 \
         with boxes linecolor rgb variable

set title "both programs: pairs of ways, of 20 values"
set yrange [0.5:3e10]
set xrange [-0.7:20.7]
set xtics 0, 2, 20
plot "orders.tsv" using (right(strcol(1))):(some($4)):(right(strcol(1)) == 20 ? 0xd55e00 : 0x0072b2) every ::1 \
         with boxes linecolor rgb variable
unset multiplot
