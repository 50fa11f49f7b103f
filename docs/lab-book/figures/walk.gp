# The bounds on the walk from 1987 to all corrected, one erratum at a time.
# data: reproduce --walk --format=tsv golden/published.tsv
load "style.inc"
set terminal svg size 820,600 font "sans-serif,13" background "white" name "walk"
set multiplot layout 2,1 margins 0.11,0.975,0.2,0.94 spacing 0,0.07

# Each case has a line of heads and 15 of data.
cases = "intella-1 intella-2 adpta-1 adpta-2"
first(k) = 16 * (k - 1) + 1
last(k) = 16 * k - 1
colour(k) = word(c1 . " " . c2 . " " . c3 . " " . c4, k)
set xrange [-0.4:14.4]
set ylabel "distance bound, mm" offset 0.5
set yrange [0.034:0.047]
set format y "%.3f"
set xtics ("" 0, "" 1, "" 2, "" 3, "" 4, "" 5, "" 6, "" 7, "" 8, "" 9, "" 10, "" 11, "" 12, "" 13, "" 14)
set key at screen 0.975,0.985 right top horizontal samplen 2
plot for [k=1:4] "walk.tsv" using ($0):2 every ::first(k)::last(k) with steps linewidth 1.5 \
         linecolor rgb colour(k) notitle, \
     for [k=1:4] "walk.tsv" using ($0):2 every ::first(k)::last(k) with points pointtype 7 pointsize 0.5 \
         linecolor rgb colour(k) notitle, \
     for [k=1:4] NaN with linespoints pointtype 7 pointsize 0.5 linewidth 1.5 linecolor rgb colour(k) \
         title word(cases, k)

set ylabel "angle bound, rad"
set yrange [0.0003:0.0009]
set format y "%.4f"
set xtics rotate by 40 right noenhanced
set xlabel "corrected so far" offset 0,1.5
unset key
plot for [k=1:4] "walk.tsv" using ($0):3:xtic(1) every ::first(k)::last(k) with steps linewidth 1.5 \
         linecolor rgb colour(k), \
     for [k=1:4] "walk.tsv" using ($0):3 every ::first(k)::last(k) with points pointtype 7 pointsize 0.5 \
         linecolor rgb colour(k)
unset multiplot
