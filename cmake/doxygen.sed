# What Doxygen 1.9.4 is given in place of a header's text.
# "\file What it does.": it takes words behind \file for the file's name.
s|^/// \\file \(.*\)|/// \\file\n/// \1|
# It finds no scope for a specialisation that is named from outside its namespace.
s|^struct fmt::formatter<\(.*\)> : .* {|struct formatter<\1> {|
