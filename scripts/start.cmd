@echo off
rem The programs beside it go on here with MAIN set to a class. The jar is built where it is missing or older than the
rem sources; a host without Maven needs only the program, this file and radiosity.jar in one directory.
set "JAR=%~dp0radiosity.jar"
if exist "%JAR%" goto run
set "PROJECT=%~dp0.."
set "JAR=%PROJECT%\target\radiosity.jar"
if not exist "%JAR%" goto build
powershell -NoProfile -Command "$built = (Get-Item $env:JAR).LastWriteTime; exit [int][bool](Get-ChildItem -Recurse -File $env:PROJECT\pom.xml, $env:PROJECT\src\main | Where-Object LastWriteTime -gt $built)"
if not errorlevel 1 goto run
:build
echo building %JAR% 1>&2
call mvn -q -B -Dmaven.test.skip=true -f "%PROJECT%\pom.xml" package 1>&2
if errorlevel 1 exit /b 1
:run
set "JAVA=java"
if defined JAVA_HOME set "JAVA=%JAVA_HOME%\bin\java"
"%JAVA%" -XX:+UseParallelGC -XX:MaxRAMPercentage=75 %JAVA_OPTS% -cp "%JAR%" %MAIN% %*
exit /b %ERRORLEVEL%
