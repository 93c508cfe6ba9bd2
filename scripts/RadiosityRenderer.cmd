@echo off
rem Renders a LightWave scene (appendix C.1 of the paper): scripts\RadiosityRenderer --help
setlocal
set "MAIN=radiosity.cli.RadiosityRenderer"
call "%~dp0start.cmd" %*
exit /b %ERRORLEVEL%
