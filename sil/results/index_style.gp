# Colour and dash of each index, by its name, as index_styles.csv has them for all pictures and pages; black is the firmware's
# warning. Expects: scripts. To be loaded after picture_style.gp, whose format of data it leaves.
index_table = ""
add_index(name, colour, dash) = (index_table = index_table." ".name." ".colour." ".dash, 0)
set datafile separator comma
unset datafile columnheaders
stats scripts."/index_styles.csv" every ::1 using (add_index(strcol(1), strcol(2), strcol(3))) nooutput
set datafile columnheaders
sky = sky_blue
place_of(name) = sum [i = 1:words(index_table) / 3] (word(index_table, 3 * i - 2) eq name ? i : 0)
index_colour(name) = place_of(name) > 0 ? value(word(index_table, 3 * place_of(name) - 1)) : grey
index_dash(name) = place_of(name) > 0 ? int(word(index_table, 3 * place_of(name))) : 3

# Others, in their order; none is black.
other_colours = blue." ".vermilion." ".green." ".purple." ".orange." ".sky_blue
other_colour(i) = word(other_colours, 1 + (i - 1) % 6)
other_dash(i) = 1 + (i - 1) / 6
