"""A scene in MuJoCo: build, check, settle, render."""
