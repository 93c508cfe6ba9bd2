@echo off
rem Computes a part of a scene for RadiosityRenderer -h (appendix C.3 of the paper): scripts\PartitionServer --help
setlocal
set "MAIN=radiosity.cli.PartitionServer"
call "%~dp0start.cmd" %*
exit /b %ERRORLEVEL%
