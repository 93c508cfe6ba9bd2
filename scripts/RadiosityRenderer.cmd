@echo off
rem Renders a LightWave scene (appendix C.1 of the paper): scripts\RadiosityRenderer --help
setlocal
set "MAIN=radiosity.cli.RadiosityRenderer"
set "DIRECTIVES=%~dp0compiler.json"
rem without call, which would take per cent signs among the arguments for names; start.cmd ends the program
"%~dp0start.cmd" %*
