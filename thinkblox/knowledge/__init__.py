"""What reader, planner and expert know of things and rooms: general words, habits, senses, types of rooms."""
