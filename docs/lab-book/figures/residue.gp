# The Adept's angle tolerance over the first word on the skew diagonal, the second 1 and the third 0.
# data: docs/lab-book/tools/diagonals --scan
load "style.inc"
set terminal svg size 820,640 font "sans-serif,13" background "white" name "residue"
set multiplot layout 2,1 margins 0.12,0.96,0.09,0.93 spacing 0,0.1

band = "#cfe8d8"
# the last printed digit, in mrad, half up and half down
below(n) = 1000 * column(n) - 0.0005
above(n) = 1000 * column(n) + 0.0005
of(name, value) = strcol(1) eq name ? value : NaN
unset grid
unset key
set xrange [0:3]
set format y "%.4f"
set ylabel "ggd, mrad" offset 0.5
set title offset 0,-0.6
set style fill solid noborder

set title "adpta, case 1"
low = 5.3114
high = 5.3161
set yrange [low:high]
plot "residue.tsv" using (of("published", 1.5)):(1000 * $3):(0):(3):(below(3)):(above(3)) \
         with boxxyerror linecolor rgb band, \
     "" using (of("published", 0.03)):(1000 * $3):("what is printed as published") with labels left \
         textcolor rgb "#00664b", \
     "" using (of("VAX", $2)):(low):(0):(high - low) with vectors nohead linecolor rgb grey dashtype 2, \
     "" using (of("68020", $2)):(low):(0):(high - low) with vectors nohead linecolor rgb c2 linewidth 1.5, \
     "" using (of("VAX", $2)):(high - 0.0003):("VAX  ") with labels right textcolor rgb grey, \
     "" using (of("68020", $2)):(high - 0.0003):("  68020: IEEE, big-endian") with labels left textcolor rgb c2, \
     "" using (of("scan", $2)):(1000 * $3) with lines linewidth 2 linecolor rgb c1, \
     "" using (of("none", $2)):(1000 * $3) with points pointtype 6 pointsize 1 linecolor rgb c4, \
     "" using (of("none", 0.05)):(1000 * $3):("no residue: all three words 0") with labels left offset 0,-0.8 \
         textcolor rgb c4

set title "adpta, case 2"
low = 6.0775
high = 6.0825
set yrange [low:high]
set xlabel "first word on the diagonal" offset 0,0.4
plot "residue.tsv" using (of("published", 1.5)):(1000 * $4):(0):(3):(below(4)):(above(4)) \
         with boxxyerror linecolor rgb band, \
     "" using (of("VAX", $2)):(low):(0):(high - low) with vectors nohead linecolor rgb grey dashtype 2, \
     "" using (of("68020", $2)):(low):(0):(high - low) with vectors nohead linecolor rgb c2 linewidth 1.5, \
     "" using (of("scan", $2)):(1000 * $4) with lines linewidth 2 linecolor rgb c1, \
     "" using (of("none", $2)):(1000 * $4) with points pointtype 6 pointsize 1 linecolor rgb c4, \
     "" using (of("none", 0.05)):(1000 * $4):("no residue") with labels left offset 0,-0.8 textcolor rgb c4
unset multiplot
