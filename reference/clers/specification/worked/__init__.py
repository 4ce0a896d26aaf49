"""Worked examples: tables on pages whose cells are compared with what the reference computes."""
