"""Runs a command on a terminal of its own, presses a key after a time, and prints what the terminal showed.

on-terminal.py SECONDS KEY COMMAND...: KEY is the number of a character; its exit code is the command's.
"""
import os
import pty
import select
import signal
import sys
import time

end = time.monotonic() + float(sys.argv[1])
key, command = bytes([int(sys.argv[2])]), sys.argv[3:]
process, terminal = pty.fork()
if process == 0:
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # who was started in the background ignores Ctrl-C
    os.execvp(command[0], command)
pressed = False
while True:
    if not pressed and time.monotonic() >= end:
        os.write(terminal, key)
        pressed = True
    if not select.select([terminal], [], [], .02)[0]:
        continue
    try:
        shown = os.read(terminal, 65536)
    except OSError:
        shown = b""
    if not shown:
        break
    sys.stdout.buffer.write(shown)
    sys.stdout.flush()
status = os.waitpid(process, 0)[1]
sys.exit(128 + os.WTERMSIG(status) if os.WIFSIGNALED(status) else os.WEXITSTATUS(status))
