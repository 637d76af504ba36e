"""Whether a room is what its prompt demanded: an independent judge, by SceneEval's definitions.

It reads the files of a finished room with a geometry and a vocabulary of its own, so that a mistake of the reader, the
planner or the relations is not repeated here.
"""
