# Sourced by the programs beside it: start <main class> <arguments> ends in java, which takes the process over.
#
# The jar is built where it is missing or older than the sources. A host without Maven needs only the script, this
# file and radiosity.jar in one directory. JAVA_OPTS goes to java, say JAVA_OPTS=-Xmx8g; without it three quarters of
# the memory may be used.

# Sets nothing but functions; the caller has set here to its own directory.
project=$(dirname "$here")

fail() {
    echo "$1" >&2
    exit 1
}

stale() {
    [ ! -f "$1" ] || [ -n "$(find "$project/pom.xml" "$project/src/main" -type f -newer "$1" 2>/dev/null | head -n 1)" ]
}

build() {
    command -v mvn >/dev/null 2>&1 || fail "mvn: expected Maven or $here/radiosity.jar, got neither"
    echo "building $jar" >&2
    (cd "$project" && mvn -q -B -Dstyle.color=never -Dmaven.test.skip=true package) >&2 || fail "$jar: expected to be built, got the errors above"
}

start() {
    jar=$here/radiosity.jar
    if [ ! -f "$jar" ]; then
        jar=$project/target/radiosity.jar
        if stale "$jar"; then build; fi
    fi
    java=${JAVA_HOME:+$JAVA_HOME/bin/}java
    command -v "$java" >/dev/null 2>&1 || fail "$java: expected a Java 17 or later, got none"
    # JAVA_OPTS is split into words on purpose
    exec "$java" -XX:+UseParallelGC -XX:MaxRAMPercentage=75 $JAVA_OPTS -cp "$jar" "$@"
}
