# How far the tools of arms are off that are built to the published and to the corrected tolerances.
# data: docs/lab-book/tools/part 'Largest linear component' yield --format=tsv golden/published.tsv
load "style.inc"
set terminal svg size 820,420 font "sans-serif,13" background "white" name "yield"
set lmargin 21
set rmargin 3
set tmargin 2
unset key
unset grid
set border 1 linecolor rgb "#444444"
set logscale x
set xrange [0.02:10]
set xtics (0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10)
set xlabel "largest linear component of the tool's error, mm: 10 to 90 % of arms, median, 99 %, worst drawn"
set yrange [7.6:-0.6]
set ytics noenhanced scale 0
set style fill solid noborder

# 0.5 mm is the accuracy that all four cases ask for
set arrow from 0.5, graph 0 to 0.5, graph 1 nohead linecolor rgb "#333333" dashtype 2
set label "asked for" at 0.5, graph 1 center offset 0,0.8 textcolor rgb "#333333"

published(name) = strstrt(name, "published") > 0
colour(name) = published(name) ? 0xd55e00 : 0x0072b2
plot "yield.tsv" using 2:0:2:4:($0 - 0.28):($0 + 0.28):(colour(strcol(1))):ytic(1) every ::1 \
         with boxxyerror linecolor rgb variable, \
     "" using 4:0:($5 - $4):(0):(colour(strcol(1))) every ::1 with vectors nohead linewidth 1.5 \
         linecolor rgb variable, \
     "" using 3:($0 - 0.28):(0):(0.56) every ::1 with vectors nohead linewidth 2 linecolor rgb "white", \
     "" using 6:0:(colour(strcol(1))) every ::1 with points pointtype 7 pointsize 0.6 linecolor rgb variable
