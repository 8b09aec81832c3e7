# Draws what bench_abstracted_lines --chart wrote: error against cost for the knobs of finding abstracted lines.
#   gnuplot -e "sweep='abstracted_lines.csv'; picture='abstracted_lines.svg'" abstracted_lines_chart.gp

if (picture[strlen(picture) - 2:] eq "png") {
  set terminal pngcairo size 1200, 900 font "DejaVu Sans,10" background "white"
} else {
  set terminal svg size 1200, 900 font "DejaVu Sans, Helvetica, sans-serif,13" background "white"
}
set output picture
set datafile separator ","
rows(panel, series) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\"' %s", panel, series, sweep)

set border 3 linecolor "#808080"
set tics nomirror scale 0.5 textcolor "#606060"
set grid xtics ytics linetype 2 linecolor "#e6e6e6" linewidth 1 dashtype solid
set linetype 1 linecolor "#1f5fa8" linewidth 2 pointtype 7 pointsize 0.7
set linetype 2 linecolor "#2f8f4e" linewidth 2 pointtype 5 pointsize 0.7
set linetype 3 linecolor "#e0752d" linewidth 2 pointtype 9 pointsize 0.8
set linetype 4 linecolor "#8a4fa3" linewidth 2 pointtype 13 pointsize 0.8
set linetype 5 linecolor "#707070" linewidth 2 pointtype 11 pointsize 0.8
set linetype 6 linecolor "#c2272d" linewidth 2 pointtype 6 pointsize 1.8

set multiplot layout 2, 2 margins 0.075, 0.985, 0.07, 0.86 spacing 0.085, 0.14
set label 1 "Finding abstracted lines: how far off their place is, against time" at screen 0.012, 0.965 font ",17" textcolor "#202020"
set label 2 "place: RMS over the pixels of bars as wide as the lines, at 12 angles and phases; a dotted line is the limit of .02 px" \
  at screen 0.012, 0.935 textcolor "#606060"
set label 3 "time: blur and lines of both channels, bunny at 1024x768, by megapixel that lines can be in" at screen 0.012, 0.912 textcolor "#606060"

set logscale y
set format y "%g"
set ylabel "RMS, px" textcolor "#606060" offset 1, 0
set key top right textcolor "#303030" samplen 2 spacing 1.1
limit(x) = 0.02

set title "{/:Bold taps, and 1 to 8 fits; widths 3 to 16}" offset 0, -0.5 textcolor "#202020"
set xlabel "ms by megapixel" textcolor "#606060"
set xrange [0:*]
set yrange [1e-3:*]
plot limit(x) with lines dashtype 3 linecolor "#808080" linewidth 1 notitle, \
     rows("search", "square") using 4:5 with linespoints linetype 1 title "3 x 3", \
     rows("search", "weighted") using 4:5 with linespoints linetype 2 title "3 x 3 weighted", \
     rows("search", "wide") using 4:5 with linespoints linetype 3 title "5 x 5", \
     rows("search", "preset") using 4:5 with points linetype 6 title "presets", \
     rows("search", "preset") using 4:5:3 with labels left offset 1.1, 0.5 textcolor "#c2272d" notitle

unset label
set title "{/:Bold kinds of blur, widths 4, 8, 16, 24; 6 fits}" offset 0, -0.5 textcolor "#202020"
set xlabel "ms by megapixel, blur alone" textcolor "#606060"
set logscale x
set xrange [*:*]
plot limit(x) with lines dashtype 3 linecolor "#808080" linewidth 1 notitle, \
     for [i = 1:5] rows("blur", word("exact separable recursive half kawase", i)) using 4:5 with linespoints linetype i title word("exact separable recursive half kawase", i), \
     rows("blur", "separable") using 4:5:3 with labels left offset 0.7, 0.6 textcolor "#606060" font ",11" notitle, \
     rows("blur", "kawase") using 4:5:3 with labels left offset 0.7, 0.6 textcolor "#606060" font ",11" notitle
unset logscale x

set title "{/:Bold formats of tones, contrast 1, .1, .03; widths 4 and 16}" offset 0, -0.5 textcolor "#202020"
set xlabel "ms by megapixel" textcolor "#606060"
set xrange [0:*]
plot limit(x) with lines dashtype 3 linecolor "#808080" linewidth 1 notitle, \
     for [i = 1:4] rows("storage", word("rg8 rg16 rg16f rg32f", i)) using 4:5 with linespoints linetype i title word("rg8 rg16 rg16f rg32f", i), \
     rows("storage", "rg8") using 4:5:3 with labels left offset 0.7, 0.4 textcolor "#606060" font ",11" notitle, \
     rows("storage", "rg16f") using 4:5:3 with labels left offset 0.7, 0.4 textcolor "#606060" font ",11" notitle

set title "{/:Bold beta, by number of fits; widths 3 to 16}" offset 0, -0.5 textcolor "#202020"
set xlabel "beta" textcolor "#606060"
set xrange [0:1]
plot limit(x) with lines dashtype 3 linecolor "#808080" linewidth 1 notitle, \
     for [i = 1:5] rows("beta", word("1 2 3 5 8", i)) using 4:5 with linespoints linetype i title word("1 2 3 5 8", i)." fits"
unset multiplot
