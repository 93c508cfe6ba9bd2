@echo off
rem Walks through a scene file (appendix C.4 of the paper): scripts\ViewSceneFile --help
setlocal
set "MAIN=radiosity.cli.ViewSceneFile"
rem what Java 3D uses of the JDK's windows
set "JAVA_OPTS=--add-exports java.base/java.lang=ALL-UNNAMED --add-exports java.desktop/sun.awt=ALL-UNNAMED --add-exports java.desktop/sun.java2d=ALL-UNNAMED %JAVA_OPTS%"
rem without call, which would take per cent signs among the arguments for names; start.cmd ends the program
"%~dp0start.cmd" %*
