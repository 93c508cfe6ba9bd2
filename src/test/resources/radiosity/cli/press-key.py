"""Runs a command on a terminal of its own, presses a key when it shows progress, and prints what it showed.

press-key.py KEY WORD COMMAND...: the key is pressed once the output holds WORD. Ends with the command's exit code.
"""
import os
import pty
import sys

key, word, command = sys.argv[1], sys.argv[2], sys.argv[3:]
process, terminal = pty.fork()
if process == 0:
    os.execvp(command[0], command)
shown = b""
pressed = False
while True:
    try:
        read = os.read(terminal, 65536)
    except OSError:
        read = b""
    if not read:
        break
    shown += read
    if not pressed and word.encode() in shown:
        os.write(terminal, key.encode())
        pressed = True
sys.stdout.write(shown.decode(errors="replace"))
sys.stdout.flush()
status = os.waitpid(process, 0)[1]
sys.exit(128 + os.WTERMSIG(status) if os.WIFSIGNALED(status) else os.WEXITSTATUS(status))
