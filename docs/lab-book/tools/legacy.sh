# Read by the other tools here: copies of the legacy programs, changed and built. Needs $scratch, a folder.

published=golden/published.tsv

say_and_stop() {
    printf '%s: %s\n' "${0##*/}" "$2" >&2
    exit "$1"
}

need() {
    for tool; do
        command -v "$tool" >/dev/null 2>&1 || say_and_stop 2 "$tool is missing"
    done
}

# copy_legacy FOLDER [SED]...: the sources, edited by these expressions, each of which has to change something.
copy_legacy() {
    folder=$1
    shift
    mkdir -p "$folder"
    cp legacy/*.[ch] "$folder"
    for expression; do
        changed=false
        for file in "$folder"/*.[ch]; do
            sed "$expression" "$file" >"$scratch/edited" || say_and_stop 2 "not for sed: $expression"
            cmp -s "$file" "$scratch/edited" || changed=true
            cat "$scratch/edited" >"$file"
        done
        $changed || say_and_stop 2 "changes nothing: $expression"
    done
}

# build_legacy FOLDER COMPILER [FLAG...]: both programs, never optimised
build_legacy() {
    built=$1
    shift
    for program in intella adpta; do
        "$@" -std=gnu89 -O0 -w -ffp-contract=off -DPROGRAM="\"$program\"" \
            -o "$built/$program" "$built/$program.c" -lm
    done
}

# build_for_68020 FOLDER [FLAG...]
build_for_68020() {
    folder_68020=$1
    shift
    build_legacy "$folder_68020" m68k-linux-gnu-gcc -m68020 -static "$@"
}

# run_legacy FOLDER [RUNNER]: the paper's four cases; what is missed, and the count, go to FOLDER/count.
run_legacy() {
    reproduce --misses --legacy --runner="${2-}" "$1" "$published" "$1/out" >"$1/count" || [ -s "$1/count" ]
}

# the count of run_legacy, a number
count_of() {
    sed -n 's/ of [0-9]* published numbers reproduced$//p' "$1/count"
}

# how many of the 16 files (4 cases of 4) are byte for byte those of golden/1987
same_files() {
    same=0
    for file in golden/1987/*/*.1; do
        ! cmp -s "$file" "$1/out/1987/${file#golden/1987/}" || same=$((same + 1))
    done
    echo "$same"
}

# printed FOLDER CASE LABEL: the number that a file of the case gives after LABEL
printed() {
    sed -n "s/^ *$3 = *//p" "$1/out/1987/$2"/*.1
}
