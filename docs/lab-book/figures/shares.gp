# What one length and one angle may be off, on the same walk.
# data: docs/lab-book/tools/shares
load "style.inc"
set terminal svg size 820,600 font "sans-serif,13" background "white" name "shares"
set multiplot layout 2,1 margins 0.11,0.975,0.2,0.94 spacing 0,0.07

cases = "intella-1 intella-2 adpta-1 adpta-2"
colour(k) = word(c1 . " " . c2 . " " . c3 . " " . c4, k)
first(k) = 15 * (k - 1)
last(k) = 15 * k - 1
set xrange [-0.4:14.4]
set logscale y
set ylabel "rd[0], mm" noenhanced offset 0.5
set yrange [0.009:0.08]
set ytics (0.01, 0.02, 0.04, 0.08)
set format y "%.2f"
set xtics ("" 0, "" 1, "" 2, "" 3, "" 4, "" 5, "" 6, "" 7, "" 8, "" 9, "" 10, "" 11, "" 12, "" 13, "" 14)
set key at screen 0.975,0.985 right top horizontal samplen 2
plot for [k=1:4] "shares.tsv" using ($0):3 every ::first(k)::last(k) with steps linewidth 1.5 \
         linecolor rgb colour(k) notitle, \
     for [k=1:4] "shares.tsv" using ($0):3 every ::first(k)::last(k) with points pointtype 7 pointsize 0.5 \
         linecolor rgb colour(k) notitle, \
     for [k=1:4] NaN with linespoints pointtype 7 pointsize 0.5 linewidth 1.5 linecolor rgb colour(k) \
         title word(cases, k)

set ylabel "ggd[0], rad" noenhanced
set yrange [0.00008:0.01]
set ytics (0.0001, 0.0003, 0.001, 0.003, 0.01)
set format y "%.4f"
set xtics rotate by 40 right noenhanced
set xlabel "corrected so far" offset 0,1.5
unset key
plot for [k=1:4] "shares.tsv" using ($0):4:xtic(2) every ::first(k)::last(k) with steps linewidth 1.5 \
         linecolor rgb colour(k), \
     for [k=1:4] "shares.tsv" using ($0):4 every ::first(k)::last(k) with points pointtype 7 pointsize 0.5 \
         linecolor rgb colour(k)
unset multiplot
