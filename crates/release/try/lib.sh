# The table of a try, for the scripts that source this file: they set `user`, a folder outside the repository.

failures=0
# row NAME COMMAND…: runs a command, and prints a row of the table. The output of a failure follows.
row() {
    local name=$1 start=$SECONDS result=passed
    shift
    "$@" >"$user/output" 2>&1 || { result=FAILED; failures=$((failures + 1)); }
    printf '| %s | %s | %d s |\n' "$name" "$result" $((SECONDS - start))
    [ "$result" = passed ] || sed 's/^/    /' "$user/output"
}

heading() { printf '| what | result | time |\n|---|---|--:|\n'; }
