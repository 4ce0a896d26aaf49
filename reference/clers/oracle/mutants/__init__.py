"""Mistakes put into the reference: would the vectors notice them?"""
