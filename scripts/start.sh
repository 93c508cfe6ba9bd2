# Sourced by the programs beside it, which set here to this directory: start <main class> <arguments> ends in java,
# which takes the process over.
#
# The jar is built where it is missing or older than the sources. A host without Maven needs only the program's script,
# this file and radiosity.jar in one directory. JAVA_OPTS goes to java, say JAVA_OPTS=-Xmx8g; without it three quarters
# of the memory may be used.
#
# A program that sets directives=<file> has only what that names compiled by the JVM's slow compiler, the rest by the
# quick one: a third of the time of a short render. Not with JAVA_OPTS, as the JVM's own words are not shown then.

project=$(dirname "$here")
java=${JAVA_HOME:+$JAVA_HOME/bin/}java

fail() {
    echo "$1" >&2
    exit 1
}

is_stale() {
    [ ! -f "$jar" ] || [ -n "$(find "$project/pom.xml" "$project/src/main" -type f -newer "$jar" | head -n 1)" ]
}

build() {
    command -v mvn >/dev/null 2>&1 || fail "mvn: expected Maven or $here/radiosity.jar, got neither"
    echo "building $jar" >&2
    (cd "$project" && mvn -q -B -Dstyle.color=never -Dmaven.test.skip=true package) >&2 \
        || fail "$jar: expected to be built, got the errors above"
    keep_classes
}

# What the JVM makes of the jar's classes is kept in a file beside it: a third of the time of a short render. A JVM
# to which the file does not belong does without.
keep_classes() {
    rm -f "$classes"
    "$java" -XX:ArchiveClassesAtExit="$classes" -Xlog:disable -XX:+UseParallelGC -cp "$jar" \
        radiosity.cli.RadiosityRenderer -q -pa 5% --schedule predict -it 20 "$project/scenes/cornell-box.lws" "$classes.scene" \
        >/dev/null 2>&1
    rm -f "$classes.scene"
}

start() {
    command -v "$java" >/dev/null 2>&1 || fail "$java: expected Java 17 or later, got none"
    jar=$here/radiosity.jar
    if [ ! -f "$jar" ]; then
        jar=$project/target/radiosity.jar
        classes=$project/target/radiosity.jsa
        if is_stale; then build; fi
    fi
    hot=
    if [ -z "$JAVA_OPTS" ] && [ -f "${directives-}" ]; then hot=$directives; fi
    # JAVA_OPTS is split into words on purpose
    exec "$java" -XX:SharedArchiveFile="${jar%.jar}.jsa" -Xlog:cds=off -Xlog:cds+dynamic=off -XX:+UseParallelGC \
        -XX:MaxRAMPercentage=75 ${hot:+-XX:+UnlockDiagnosticVMOptions} ${hot:+-XX:-DisplayVMOutput} \
        ${hot:+"-XX:CompilerDirectivesFile=$hot"} $JAVA_OPTS -cp "$jar" "$@"
}
