# Of the 66 published numbers, how many change when one erratum alone is corrected.
# data: docs/lab-book/tools/effect --counts
load "style.inc"
set terminal svg size 700,400 font "sans-serif,13" background "white" name "effects"
set lmargin 17
set rmargin 3
unset key
unset grid
set border 2 linecolor rgb "#444444"
set xrange [0:42]
set yrange [13.6:-0.6]
set format x ""
unset xtics
set ytics noenhanced scale 0
set bmargin 3
set xlabel "published numbers that change, of 66, when it alone is corrected"
set style fill solid noborder
plot "effects.tsv" using (0):0:(0):2:($0 - 0.36):($0 + 0.36):ytic(1) with boxxyerror linecolor rgb c1, \
     "effects.tsv" using ($2 + 0.4):0:2 with labels left noenhanced
