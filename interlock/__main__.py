"""`python -m interlock`, and the command `interlock`: an interrupt ends it without a traceback while it still loads."""

import os
import sys


def main() -> None:
    """Run the command line."""
    try:
        from interlock.cli.main import main as run
    except KeyboardInterrupt:
        sys.stderr.write("interrupted\n")
        sys.stderr.flush()
        os._exit(130)
    run()


if __name__ == "__main__":
    main()
