@echo off
rem Computes a part of a scene for RadiosityRenderer -h (appendix C.3 of the paper): scripts\PartitionServer --help
setlocal
set "MAIN=radiosity.cli.PartitionServer"
rem without call, which would take per cent signs among the arguments for names; start.cmd ends the program
"%~dp0start.cmd" %*
