"""`python -m thinkblox` is the command line."""

import sys

from thinkblox.cli import main

sys.exit(main())
