"""Serving rooms to agents: whoever calls the tools is the policy, and the answers are what was measured."""
