@echo off
rem The programs beside it go on here with MAIN set to a class. The jar is built where it is missing or older than the
rem sources; a host without Maven needs only the program, this file and radiosity.jar in one directory.
rem A program that sets DIRECTIVES to a file has only what that names compiled by the JVM's slow compiler, the rest by
rem the quick one. Not with JAVA_OPTS, as the JVM's own words are not shown then.
set "JAR=%~dp0radiosity.jar"
if exist "%JAR%" goto run
set "PROJECT=%~dp0.."
set "JAR=%PROJECT%\target\radiosity.jar"
if not exist "%JAR%" goto build
powershell -NoProfile -Command "$built = (Get-Item $env:JAR).LastWriteTime; exit [int][bool](Get-ChildItem -Recurse -File $env:PROJECT\pom.xml, $env:PROJECT\src\main | Where-Object LastWriteTime -gt $built)"
if not errorlevel 1 goto run
:build
echo building %JAR% 1>&2
set "MAVEN_OPTS=%MAVEN_OPTS% -Djansi.noreset=true"
call mvn -q -B -Dstyle.color=never -Dmaven.test.skip=true -Dcompiler.failOnWarning=false -f "%PROJECT%\pom.xml" package 1>&2
if errorlevel 1 exit /b 1
:run
set "JAVA=java"
if defined JAVA_HOME set "JAVA=%JAVA_HOME%\bin\java"
set "HOT="
if not defined DIRECTIVES goto start
if not exist "%DIRECTIVES%" goto start
if not defined JAVA_OPTS set HOT=-XX:+UnlockDiagnosticVMOptions -XX:-DisplayVMOutput -XX:CompilerDirectivesFile="%DIRECTIVES%"
:start
"%JAVA%" --enable-native-access=ALL-UNNAMED -XX:+UseParallelGC -XX:MaxRAMPercentage=75 %HOT% %JAVA_OPTS% -cp "%JAR%" %MAIN% %*
exit /b %ERRORLEVEL%
