"""Answers hello and reads no more."""

import sys
import time

from good import Message, reply, say

request: Message = {"id": 0, "op": "hello", "protocol": 1}
sys.stdin.readline()
say(reply(request))
time.sleep(3600)
