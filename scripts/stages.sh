# SPDX-License-Identifier: LGPL-2.1-or-later
# Stages that are skipped while nothing changed; sourced after common.sh, not run.

# Hash of all that a result can depend on: the project's files as they are, and the packages.
tree_hash() {
    {
        if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
            git ls-files -z --cached --others --exclude-standard
        else
            find . -path ./build -prune -o -type f -print0
        fi | sort -z | xargs -0 -r sha256sum 2>/dev/null
        dpkg-query -W -f='${Package} ${Version}\n' 2>/dev/null
    } | sha256sum | cut -c1-32
}

# stage NAME COMMAND...: runs the command with its output shown and kept in build/stages/NAME.log;
# when it passed for the same files before, shows that output's last lines instead.
stage() {
    local name=$1 log="$root/build/stages/$1.log" stamp="$root/build/stages/$1.passed"
    shift
    mkdir -p "$root/build/stages"
    if [ -z "${FORCE:-}" ] && [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$hash" ]; then
        say "$name: passed before, nothing changed since (FORCE=1 runs it again)"
        tail -n "${STAGE_LINES:-1}" "$log"
        return 0
    fi
    rm -f "$stamp"
    say "$name"
    local start=$SECONDS
    if ! "$@" 2>&1 | tee "$log"; then
        fail "$name failed; its output is in build/stages/$name.log"
    fi
    printf '%s' "$hash" >"$stamp"
    say "$name: passed in $((SECONDS - start)) s"
}
