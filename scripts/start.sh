# Sourced by the programs beside it, which set here to this directory: start <main class> <arguments> ends in java,
# which takes the process over.
#
# The jar is built where it is missing or older than the sources. A host without Maven needs only the program's script,
# this file and radiosity.jar in one directory. JAVA_OPTS goes to java, say JAVA_OPTS=-Xmx8g; without it three quarters
# of the memory may be used.
#
# A program that sets directives=<file> has only what that names compiled by the JVM's slow compiler, the rest by the
# quick one: a third of the time of a short render. Not with JAVA_OPTS, as the JVM's own words are not shown then.
#
# A program that sets run=<function> has that called with the command instead of java taking the process over.

project=$(dirname "$here")
java=${JAVA_HOME:+$JAVA_HOME/bin/}java
run=exec

fail() {
    echo "$1" >&2
    exit 1
}

is_stale() {
    [ ! -f "$jar" ] || [ -e "$unfinished" ] \
        || [ -n "$(find "$project/pom.xml" "$project/src/main" -type f -newer "$jar" | head -n 1)" ]
}

# Without escape codes: Maven's library for colours would end with one even where nothing was coloured.
build() {
    echo "building $jar" >&2
    : >"$unfinished"
    (cd "$project" && MAVEN_OPTS="$MAVEN_OPTS -Djansi.noreset=true" \
        mvn -q -B -Dstyle.color=never -Dmaven.test.skip=true -Dcompiler.failOnWarning=false package) >&2 \
        || fail "$jar: expected to be built, got the errors above"
    keep_classes
    rm -f "$unfinished"
}

# What the first of several programs builds the others find built. A lock goes with the process that holds it.
build_once() {
    command -v mvn >/dev/null 2>&1 || fail "mvn: expected Maven or $here/radiosity.jar, got neither"
    mkdir -p "$project/target" && [ -w "$project/target" ] \
        || fail "$project/target: expected a directory to build $jar in, got none that can be written"
    lock=$project/target/build.lock
    if command -v flock >/dev/null 2>&1; then
        exec 9>"$lock"
        flock -n 9 || { tell_waiting; flock 9; }
        if is_stale; then build; fi
        exec 9>&-
    else
        lock_by_link
        trap 'rm -f "$lock.link"' EXIT
        trap 'exit 130' INT
        trap 'exit 143' TERM
        if is_stale; then build; fi
        rm -f "$lock.link"
        trap - EXIT INT TERM
    fi
}

tell_waiting() {
    echo "waiting for another program, which is building $jar" >&2
}

# Where there is no flock (macOS): a link to the number of the process. That of one that was killed is taken away, and
# nobody waits for longer than ten minutes: its number may be another's by then.
lock_by_link() {
    seconds=0
    until ln -s $$ "$lock.link" 2>/dev/null; do
        [ -L "$lock.link" ] && [ $seconds -lt 600 ] || return 0
        if kill -0 "$(readlink "$lock.link")" 2>/dev/null; then
            [ $seconds -gt 0 ] || tell_waiting
        else
            rm -f "$lock.link"
        fi
        sleep 1
        seconds=$((seconds + 1))
    done
}

# What the JVM makes of the jar's classes is kept in a file beside it: a third of the time of a short render. A JVM
# to which the file does not belong does without.
keep_classes() {
    rm -f "$classes"
    "$java" -XX:ArchiveClassesAtExit="$classes" -Xlog:disable -XX:+UseParallelGC -cp "$jar" \
        radiosity.cli.RadiosityRenderer -q -pa 5% --schedule predict -it 20 "$project/scenes/cornell-box.lws" "$classes.scene" \
        >/dev/null 2>&1
    rm -f "$classes.scene"
    [ -e "$classes" ] || : >"$classes"
}

# After a build by hand.
lacks_classes() {
    [ -w "$project/target" ] && { [ ! -e "$classes" ] || [ -n "$(find "$jar" -newer "$classes")" ]; }
}

start() {
    command -v "$java" >/dev/null 2>&1 || fail "$java: expected Java 17 or later, got none"
    jar=$here/radiosity.jar
    built=
    if [ ! -f "$jar" ]; then
        jar=$project/target/radiosity.jar
        classes=$project/target/radiosity.jsa
        unfinished=$project/target/build.unfinished
        if is_stale; then
            build_once
            built=-Dradiosity.built=true
        elif lacks_classes; then
            keep_classes
            built=-Dradiosity.built=true
        fi
    fi
    # In the locale C, or in one that is not installed, Java cannot open files whose names have letters beyond ASCII.
    if [ "$(locale charmap 2>/dev/null)" = ANSI_X3.4-1968 ]; then
        LC_ALL=C.UTF-8
        export LC_ALL
    fi
    hot=
    if [ -z "$JAVA_OPTS" ] && [ -f "${directives-}" ]; then hot=$directives; fi
    # JAVA_OPTS is split into words on purpose. Natives of the key listener and of Java 3D are loaded without a word from
    # the JVM.
    $run "$java" --enable-native-access=ALL-UNNAMED -XX:SharedArchiveFile="${jar%.jar}.jsa" -Xlog:cds=off \
        -Xlog:cds+dynamic=off -XX:+UseParallelGC -XX:MaxRAMPercentage=75 ${hot:+-XX:+UnlockDiagnosticVMOptions} \
        ${hot:+-XX:-DisplayVMOutput} ${hot:+"-XX:CompilerDirectivesFile=$hot"} $built $JAVA_OPTS -cp "$jar" "$@"
}
