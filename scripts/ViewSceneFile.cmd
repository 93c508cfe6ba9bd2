@echo off
rem Walks through a scene file (appendix C.4 of the paper): scripts\ViewSceneFile --help
setlocal
set "MAIN=radiosity.cli.ViewSceneFile"
rem what Java 3D uses of the JDK's windows
set "JAVA_OPTS=--add-exports java.base/java.lang=ALL-UNNAMED --add-exports java.desktop/sun.awt=ALL-UNNAMED --add-exports java.desktop/sun.java2d=ALL-UNNAMED %JAVA_OPTS%"
call "%~dp0start.cmd" %*
exit /b %ERRORLEVEL%
