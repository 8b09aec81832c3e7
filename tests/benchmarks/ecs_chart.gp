# Draws the sweep of bench_ecs --chart: one panel per operation, cost per entity against the number of entities.
#   gnuplot -e "sweep='ecs.csv'; picture='ecs.svg'" ecs_chart.gp        (a .png works, too)

if (picture[strlen(picture) - 2:] eq "png") {
  set terminal pngcairo size 1280, 760 font "DejaVu Sans,10" background "white"
} else {
  set terminal svg size 1280, 760 font "DejaVu Sans, Helvetica, sans-serif,13" background "white"
}
set output picture
set datafile separator ","

# Names hold spaces, and a list of gnuplot's is separated by them: '~' stands for ' ' in lists.
listed = "awk -F, 'NR > 1 && %s && !seen[$%d]++ {gsub(\" \", \"~\", $%d); print $%d}' "
panels = system(sprintf(listed, "1", 1, 1, 1).sweep)
series(panel) = system(sprintf(listed, "$1 == \"".panel."\"", 2, 2, 2).sweep)
spaced(name) = system("printf %s '".name."' | tr '~' ' '")
rows(panel, test) = sprintf("< awk -F, '$1 == \"%s\" && %s' %s", panel, test, sweep)
named(name) = "$2 == \"".name."\""

# Both axes are logarithmic: the ratio of two costs is the same distance everywhere.
set logscale xy
set xrange [1e3:1e7]
set format x "10^{%L}"
set mxtics 1
set ytics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000)
set key top left reverse Left samplen 1.6 spacing 1.05 textcolor "#303030"
set border 3 linecolor "#808080"
set tics nomirror scale 0.5 textcolor "#606060"
set grid xtics ytics linetype 2 linecolor "#e6e6e6" linewidth 1 dashtype solid

set linetype 1 linecolor "#8c8c8c" linewidth 2.2 dashtype (6, 4) pointtype -1
set linetype 2 linecolor "#1f5fa8" linewidth 2.2 pointtype 7 pointsize 0.5
set linetype 3 linecolor "#e0752d" linewidth 2.2 pointtype 5 pointsize 0.5
set linetype 4 linecolor "#3f9b57" linewidth 2.2 pointtype 9 pointsize 0.6

set multiplot layout 2, 4 margins 0.04, 0.99, 0.05, 0.865 spacing 0.035, 0.105
set label 1 "Hachure's world against raw arrays" at screen 0.012, 0.965 font ",17" textcolor "#202020"
set label 2 "ns per entity of two components of 12 bytes, against the number of entities; dashed: the same on raw arrays" \
  at screen 0.012, 0.925 textcolor "#606060"
do for [i = 1:words(panels)] {
  panel = spaced(word(panels, i))
  names = series(panel)
  set yrange [*:*]
  stats rows(panel, "1") using 4 nooutput
  set yrange [STATS_min / 1.5 : STATS_max * (STATS_max / STATS_min) ** 0.5 * 2] # room for the key
  set title "{/:Bold ".panel."}" offset 0, -0.5 textcolor "#202020"
  plot for [k = 1:words(names)] rows(panel, named(spaced(word(names, k)))) using 3:4 with linespoints linetype k \
    title spaced(word(names, k)) noenhanced
  unset label
}
unset multiplot
