# Prints what the routines of a C file of 1987 declare, as listing.tsv has it: file, routine, formals, locals. What
# today's compilers force is taken back, double formals and register indices, and so is UNSET, which is ours.

function show() {
    printf "%s\t%s\t%s\t%s\n", FILENAME, routine, declared["formal"], declared["local"]
    routine = ""
}

# A declaration may take several lines, a name or more on each.
function declare(text,    kind) {
    kind = inside ? "local" : "formal"
    sub(/^UNSET /, "", text)
    sub(/^register /, "", text)
    sub(/^double /, "float ", text)
    gsub(/,\*/, ", *", text)
    if (!open && kind == "formal" && declared[kind] && sub(/^float /, "", text)) declared[kind] = declared[kind] ", "
    else if (!open && declared[kind]) declared[kind] = declared[kind] "; "
    else if (open) declared[kind] = declared[kind] " "
    open = text !~ /;$/
    sub(/;$/, "", text)
    declared[kind] = declared[kind] text
}

{
    gsub(/\/\*.*\*\//, "")
    gsub(/^[ \t]+|[ \t]+$/, "")
}

!routine && /^[a-z][a-z0-9]*\([a-z0-9,]*\)$/ {
    routine = $0
    sub(/\(.*/, "", routine)
    inside = open = 0
    split("", declared)
    next
}
!routine { next }
!inside && $0 == "{" { inside = 1; next }
$0 == "" { next }
!inside || open || /^(UNSET |register |float |int |FILE )/ { declare($0); next }
{ show() }
